// The methods and sources of the numbers.
#include <vector>

#include "markup.h"
#include "numbers.h"
#include "page.h"
#include "words.h"

namespace elsie::report {

namespace {

std::string row(const std::string& name, const std::string& value) {
  return value.empty() ? "" : "<dt>" + name + "</dt><dd>" + value + "</dd>";
}

std::vector<std::string> notes() {
  return {
      // NOLINTNEXTLINE(bugprone-suspicious-missing-comma)
      "A cell\xe2\x80\x99s sample has one run for each seed; repetitions of a seed are compared, "
      "not counted again.",
      "Runs that ended abnormally count as not successful; means, quartiles and boxes "
      "are over the others, whether these reached their goals or not.",
      "Standard deviation: divisor n \xe2\x88\x92 1. Quartiles: linear between order "
      "statistics (definition 7 of Hyndman and Fan, 1996).",
      "Interval of a rate: Wilson (1927). Interval of a mean: bootstrap-t (Efron, 1979; Hall, "
      "1988), " +
          std::to_string(kResamples) +
          " resamples from a generator that is seeded by the fingerprint, so that the same "
          "database gives the same page; with fewer than " +
          std::to_string(kFewestForBootstrap) + " values Student\xe2\x80\x99s t.",
      "The time of a run that the time limit stopped is censored: it is at least the limit. A run "
      "that failed never reaches its goals: its time is longer than all others. The "
      "mean of such times is not known; their median is when it lies below the limit (Kaplan and "
      "Meier, 1958).",
      "Outlier: more than 1.5 quartile ranges beyond the quartiles (Tukey, 1977), in samples "
      "of at least " +
          std::to_string(kFewest) + ".",
      "Who decided when: % of the time in which a behaviour had the largest share in the command, "
      "and its mean share. Where several alternated quickly, a bar is divided in proportion to "
      "the time of each."};
}

}  // namespace

std::string methods_section(const PageContext& page) {
  const Results& results = page.findings.results;
  std::string text = "<section id=\"methods\"><h2>How this was made</h2>\n<dl class=\"about\">";
  text += row("runs", escaped(size_in_words(page.findings)));
  text += row("database", "<code>" + escaped(page.database) + "</code>");
  text += row("experiment file", "<code>" + escaped(results.file) + "</code>");
  text += row("fingerprint", "<code>" + escaped(results.fingerprint) + "</code>");
  text += row("begun", escaped(results.created));
  text += row("elsie", escaped(results.elsie_version));
  text += "</dl>\n<ul class=\"notes\">";
  for (const std::string& note : notes()) {
    text += "<li>" + note + "</li>";
  }
  if (const std::string note = give_ups_in_words(page.findings); !note.empty()) {
    text += "<li><strong>" + escaped(note) + "</strong></li>";
  }
  text += "</ul>\n";
  if (!page.findings.measures.empty()) {
    text += "<details><summary>What was measured</summary><dl class=\"about\">";
    for (const Measure& measure : results.measures) {
      text += "<dt><code>" + escaped(measure.name) + "</code></dt><dd>" + escaped(measure.meaning) +
              (measure.unit.empty() ? "" : " <span>" + escaped(measure.unit) + "</span>") + "</dd>";
    }
    text += "</dl></details>\n";
  }
  if (!results.text.empty()) {
    text += "<details><summary>The experiment file</summary><pre>" + escaped(results.text) +
            "</pre></details>\n";
  }
  return text + "</section>\n";
}

}  // namespace elsie::report
