#include "judge.h"

#include <cmath>

#include "elsie/base/near_name.h"

#include "judging.h"
#include "numbers.h"
#include "words.h"

namespace elsie::report {

using experiment::Expectation;
using experiment::Runs;

namespace {

std::string word_of(Statistic statistic) {
  switch (statistic) {
    case Statistic::mean:
      return "mean ";
    case Statistic::median:
      return "median ";
    case Statistic::standard_deviation:
      return "standard deviation of ";
    case Statistic::minimum:
      return "minimum ";
    case Statistic::maximum:
      return "maximum ";
    case Statistic::rate:
      return "rate of ";
  }
  return "";
}

// Only runs that are done have measures, so a name may be unknown because runs failed.
std::string unknown_measure(const Findings& findings, const std::string& name,
                            const std::vector<std::string>& names) {
  const std::size_t broken = findings.broken(), pending = findings.pending();
  const std::string what = "a measure '" + name + "'";
  if (pending == findings.runs()) {
    return "no run has " + what + " yet: none is done";
  }
  if (broken + pending == findings.runs()) {
    return "no run has " + what + ": " + broken_in_words(findings) +
           (pending > 0 ? ", and " + counted(pending, "is", "are") + " still to be done" : "");
  }
  std::string others = broken > 0 ? broken_in_words(findings) : "";
  if (pending > 0) {
    others += (others.empty() ? "" : ", and ") + counted(pending, "run is", "runs are") +
              " still to be done";
  }
  return (others.empty() ? "no run has " : "no run that ended normally has ") + what +
         base::did_you_mean(name, names) + (others.empty() ? "" : "; " + others);
}

// Finds the measures, their description and unit. Returns the problem with their names, or "".
std::string find_subject(const Expectation& expectation, const Findings& findings,
                         Subject& subject) {
  const Results& results = findings.results;
  std::vector<std::string> names{kSuccess};
  for (const Measure& measure : results.measures) {
    names.push_back(measure.name);
  }
  const auto place = [&](const std::string& name, std::optional<std::size_t>& found) {
    for (std::size_t i = 0; i < results.measures.size(); ++i) {
      if (results.measures[i].name == name && name != kSuccess) {
        found = i;
      }
    }
    return found || name == kSuccess ? std::string() : unknown_measure(findings, name, names);
  };
  const bool rate = expectation.statistic == Statistic::rate;
  const bool plain = rate && expectation.measure == kSuccess && expectation.per.empty();
  subject.words = plain ? "success rate"
                        : word_of(expectation.statistic) + expectation.measure +
                              (expectation.per.empty() ? "" : " per " + expectation.per);
  if (expectation.runs == Runs::successes) {
    subject.words += " of successful runs";
  }
  std::string trouble = place(expectation.measure, subject.measure);
  if (trouble.empty() && !expectation.per.empty()) {
    trouble = place(expectation.per, subject.per);
  }
  if (!rate && subject.measure && expectation.per.empty()) {
    subject.unit = results.measures[*subject.measure].unit;
  }
  return trouble;
}

// The limits, unless the name states them: an expectation without a name is named after them.
std::string expected(const Judging& judging) {
  const bool difference = judging.expectation.relation == Relation::difference;
  const auto names = [&](const std::optional<double>& limit) {
    const auto tells = [&](const char* word) {
      const double value = limit && difference ? std::abs(*limit) : limit.value_or(0.0);
      return limit && judging.expectation.name.find(word + number_text(value)) != std::string::npos;
    };
    return tells(": at least ") || tells(": at most ") || tells(": about ");
  };
  if (!names(judging.expectation.at_least) && !names(judging.expectation.at_most) &&
      !names(judging.expectation.about)) {
    return judging.subject.words + ": " + judging.limits();
  }
  return judging.expectation.confidence
             ? "with " + brief(100.0 * *judging.expectation.confidence) + " % confidence"
             : "";
}

}  // namespace

Verdict judge(const Expectation& expectation, const Findings& findings,
              const experiment::Grid& grid) {
  Verdict verdict;
  verdict.name = expectation.name;
  Subject subject;
  verdict.trouble = find_subject(expectation, findings, subject);
  const Judging judging{expectation, findings, subject};
  verdict.expected = expected(judging);
  verdict.waits = findings.pending() > 0 || findings.partial();
  if (!verdict.trouble.empty()) {
    return verdict;
  }
  if (findings.partial()) {
    verdict.trouble = missing_in_words(findings) + "; an expectation needs all of them";
    return verdict;
  }
  for (const std::size_t cell : grid.cells_of(expectation)) {
    verdict.claims.push_back(expectation.relation == Relation::none
                                 ? judge_cell(judging, cell)
                                 : judge_pair(judging, cell, grid.reference_of(expectation, cell)));
  }
  if (verdict.claims.empty()) {
    verdict.trouble = "it covers no cell";
    verdict.waits = false;
  }
  return verdict;
}

}  // namespace elsie::report
