#include "page.h"

#include <algorithm>

#include "elsie/files/base64.h"
#include "elsie/page/viewer.h"
#include "elsie/report/report.h"
#include "elsie/results/hash.h"

#include "markup.h"
#include "numbers.h"

namespace elsie::report {

std::string runs_table(const std::string& what, const std::string& why, const std::string& rows) {
  return "<div class=\"scroll\"><table class=\"runs\"><thead><tr><th class=\"n\">run</th>"
         "<th class=\"n\">seed</th><th>" +
         what + "</th><th>" + why + "</th><th>again</th></tr></thead><tbody>" + rows +
         "</tbody></table></div>\n";
}

std::string run_row(const PageContext& page, const Run& run, const std::string& what,
                    const std::string& why) {
  return "<tr><td class=\"n\">" + std::to_string(run.id) + "</td><td class=\"n\">" +
         std::to_string(run.seed) + "</td><td>" + what + "</td><td>" + why +
         "</td><td><code class=\"command\">" + escaped(replay_command(page.database, run.id)) +
         "</code></td></tr>";
}

std::string ending_tag(const Findings& findings, const Run& run) {
  if (run.broken()) {
    return "<em class=\"tag bad\">" + std::string(to_string(run.state)) + "</em>";
  }
  if (!run.ended()) {
    return "<em class=\"tag\">to do</em>";
  }
  switch (run.outcome.value_or(Outcome::failure)) {
    case Outcome::success:
      return "success";
    case Outcome::time_limit:
      return findings.cells[run.cell].goals ? "<em class=\"tag bad\">time limit</em>" : "no goals";
    default:
      return "<em class=\"tag bad\">failure</em>";
  }
}

std::string anchor(std::size_t cell) { return "cell-" + std::to_string(cell + 1); }

namespace {

// This many cells with all figures make at most a megabyte.
constexpr std::size_t kMostInDetail = 100;

}  // namespace

bool PageContext::is_detailed(std::size_t cell) const {
  return std::binary_search(detailed.begin(), detailed.end(), cell);
}

std::vector<std::size_t> cells_in_detail(const Findings& findings, const std::string& filter) {
  std::vector<std::size_t> notable, others;
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    if (findings.results.cells[i].label.find(filter) == std::string::npos) {
      continue;
    }
    const CellFindings& cell = findings.cells[i];
    const bool stands_out = !cell.broken.empty() || !cell.outliers.empty() ||
                            std::any_of(cell.runs.begin(), cell.runs.end(), [&](std::size_t run) {
                              return findings.missed(findings.results.runs[run]);
                            });
    (stands_out ? notable : others).push_back(i);
  }
  if (notable.size() + others.size() <= kMostInDetail) {
    notable.insert(notable.end(), others.begin(), others.end());
    std::sort(notable.begin(), notable.end());
    return notable;
  }
  // At least half of the sections go to cells with notable runs, if there are that many.
  const std::size_t even =
      std::min(others.size(), kMostInDetail - std::min(notable.size(), kMostInDetail / 2));
  std::vector<std::size_t> chosen;
  const auto take = [&](const std::vector<std::size_t>& from, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      chosen.push_back(from[i * from.size() / count]);
    }
  };
  take(notable, std::min(notable.size(), kMostInDetail - even));
  take(others, std::min(others.size(), kMostInDetail - chosen.size()));
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::string html_report(const Findings& findings, const ResultsFile& file,
                        const std::string& database, const std::string& cells,
                        const Answers& answers) {
  const std::vector<std::size_t> detailed = cells_in_detail(findings, cells);
  Inks inks = choose_inks(findings);
  add_behaviors(file, findings, detailed, inks);
  const PageContext page{findings, file, database, inks, detailed, answers};
  const std::string title = escaped(findings.results.experiment);
  const std::string style = std::string("\n") + kPageStyle,
                    script = std::string("\n") + kPageScript;
  // Under this policy, the browser refuses anything that a label could inject, and all requests.
  // The viewer's frame is under it, too.
  const std::string head =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src " +
      files::policy_hash(results::sha256(style)) + " " + page::viewer_style_hash() +
      "; script-src " + files::policy_hash(results::sha256(script)) + " " +
      page::viewer_script_hash() +
      "; img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<meta name=\"generator\" content=\"elsie report\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>" +
      title + " \xe2\x80\x93 elsie report</title>\n<style>" + style +
      "</style>\n</head>\n<body>\n<main>\n" + answer_section(page) + comparison_sections(page) +
      factor_sections(page) + time_sections(page);
  const std::string rest = cell_sections(page) + methods_section(page) + "</main>\n<script>" +
                           script + "</script>\n</body>\n</html>\n";
  const std::size_t size = head.size() + rest.size();
  return head + watch_section(page, kMostPageBytes - std::min(size, kMostPageBytes)) + rest;
}

}  // namespace elsie::report
