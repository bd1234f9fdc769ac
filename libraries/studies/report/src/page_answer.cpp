// The head of the page: the question and the answer.
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "effects.h"
#include "markup.h"
#include "numbers.h"
#include "page.h"
#include "words.h"

namespace elsie::report {

namespace {

constexpr const char* kYes =
    "<svg class=\"icon yes\" viewBox=\"0 0 20 20\" role=\"img\" aria-label=\"met\"><circle "
    "cx=\"10\" "
    "cy=\"10\" r=\"9\"/><path d=\"M5.8 10.4l2.8 2.8 5.6-6\"/></svg>";
constexpr const char* kNo =
    "<svg class=\"icon no\" viewBox=\"0 0 20 20\" role=\"img\" aria-label=\"not met\"><circle "
    "cx=\"10\" cy=\"10\" r=\"9\"/><path d=\"M6.6 6.6l6.8 6.8M13.4 6.6l-6.8 6.8\"/></svg>";

constexpr const char* kOpen =
    "<svg class=\"icon open\" viewBox=\"0 0 20 20\" role=\"img\" aria-label=\"not known yet\">"
    "<circle cx=\"10\" cy=\"10\" r=\"9\"/><path d=\"M5.5 10h.01M10 10h.01M14.5 10h.01\"/></svg>";

const char* icon_of(const Verdict& verdict) {
  return verdict.met() ? kYes : verdict.open() ? kOpen : kNo;
}

std::string tile(const std::string& value, const std::string& of, const std::string& label) {
  return "<div><dt>" + label + "</dt><dd>" + value + (of.empty() ? "" : "<i>" + of + "</i>") +
         "</dd></div>";
}

std::string duration(double seconds) {
  if (seconds < 120.0) {
    return brief(seconds, 3) + " s";
  }
  if (seconds < 7200.0) {
    return brief(seconds / 60.0, 3) + " min";
  }
  return brief(seconds / 3600.0, 3) + " h";
}

std::string tiles(const Findings& findings) {
  std::set<std::uint64_t> seeds;
  double simulated_s = 0.0, wall_s = 0.0;
  for (const Run& run : findings.results.runs) {
    seeds.insert(run.seed);
    simulated_s += run.simulated_s.value_or(0.0);
    wall_s += run.wall_s.value_or(0.0);
  }
  std::string text = "<dl class=\"tiles\">";
  const std::string successes = successes_in_words(findings);
  const std::size_t of = successes.find(" of ");
  text += tile(successes.substr(0, of), of == std::string::npos ? "" : successes.substr(of),
               findings.any_goals() ? "successful runs" : "no run succeeds or fails");
  text += tile(std::to_string(findings.cells.size()), "",
               findings.cells.size() == 1 ? "cell" : "cells");
  text += tile(std::to_string(seeds.size()), "", seeds.size() == 1 ? "seed" : "seeds");
  if (findings.broken() > 0) {
    text += tile(std::to_string(findings.broken()), "", "ended abnormally");
  }
  if (findings.pending() > 0) {
    text += tile(std::to_string(findings.pending()), "", "still to be done");
  }
  if (findings.partial()) {
    text += tile(std::to_string(findings.missing()), "", "not in this database");
  }
  text += tile(duration(simulated_s), "", "simulated");
  text += tile(duration(wall_s), "", "of computing");
  return text + "</dl>\n";
}

std::string headline(const Findings& findings) {
  const char* const kind = findings.good() ? "good" : findings.open() ? "open" : "bad";
  return "<h2 class=\"verdict " + std::string(kind) + "\">" +
         (findings.good()   ? kYes
          : findings.open() ? kOpen
                            : kNo) +
         "<span>" + answer_in_words(findings) + "</span></h2>\n";
}

std::string verdict_item(const Verdict& verdict) {
  const auto bad = [](bool open) { return open ? "<p class=\"quiet\">" : "<p class=\"bad\">"; };
  std::string text = "<li>" + std::string(icon_of(verdict)) + "<div><b>" + escaped(verdict.name) +
                     "</b> <span>" + escaped(verdict.expected) + "</span>";
  if (!verdict.trouble.empty()) {
    text += bad(verdict.open()) + escaped(verdict.trouble) + "</p>";
  }
  // Failures are shown, the others are folded.
  std::string others;
  std::size_t count = 0;
  for (const Claim& claim : verdict.claims) {
    if (!claim.holds) {
      text += bad(claim.open) + escaped(claim.found) + "</p>";
    } else {
      others += "<p>" + escaped(claim.found) + "</p>";
      ++count;
    }
  }
  if (count == 1 && verdict.claims.size() == 1) {
    text += others;
  } else if (count > 0) {
    text += "<details><summary>" + counted(count, "cell meets it", "cells meet it") + "</summary>" +
            others + "</details>";
  }
  return text + "</div></li>\n";
}

// Failed runs: they are about plugins or the machine rather than the experiment.
std::string troubles(const PageContext& page) {
  const Findings& findings = page.findings;
  std::string rows;
  for (const Run& run : findings.results.runs) {
    if (!run.broken()) {
      continue;
    }
    const std::string log = run.log.value_or("").empty()
                                ? ""
                                : "<details><summary>its last output</summary><pre>" +
                                      escaped(*run.log) + "</pre></details>";
    rows += run_row(page, run, escaped(findings.results.cells[run.cell].label),
                    ending_tag(findings, run) + " " + escaped(circumstances(run)) + log);
  }
  std::string text;
  if (!rows.empty()) {
    text +=
        "<section id=\"broken\"><h2>Runs that ended abnormally</h2><p class=\"lead\">"
        "They count as not successful and have no values.</p>" +
        runs_table("cell", "what happened", rows) + "</section>\n";
  }
  if (!findings.disagreements.empty()) {
    text += "<section id=\"unlike\"><h2>Equal seeds, different runs</h2><ul>";
    for (const Disagreement& disagreement : findings.disagreements) {
      text += "<li class=\"bad\">" + escaped(in_words(findings.results, disagreement)) + "</li>";
    }
    text += "</ul></section>\n";
  }
  return text;
}

}  // namespace

std::string answer_section(const PageContext& page) {
  const Findings& findings = page.findings;
  const Results& results = findings.results;
  std::string text =
      "<header><p class=\"eyebrow\">Experiment</p><h1>" + escaped(results.experiment) + "</h1>\n";
  if (!results.description.empty()) {
    text += "<p class=\"lead\">" + escaped(results.description) + "</p>\n";
  }
  text += "</header>\n<section id=\"answer\">" + headline(findings);
  if (std::string effects = effects_in_words(findings); !effects.empty()) {
    effects[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(effects[0])));
    text += "<p class=\"lead\">" + escaped(effects) + ".</p>\n";
  }
  text += tiles(findings);
  if (!findings.verdicts.empty()) {
    text += "<ul class=\"expectations\">\n";
    for (const Verdict& verdict : findings.verdicts) {
      text += verdict_item(verdict);
    }
    text += "</ul>\n";
  }
  return text + "</section>\n" + troubles(page);
}

}  // namespace elsie::report
