#include "judging.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers.h"
#include "words.h"

namespace elsie::report {

using experiment::Runs;

bool Judging::keeps(double value) const {
  const double tolerance = expectation.tolerance;
  return (!expectation.at_least || value >= *expectation.at_least - tolerance) &&
         (!expectation.at_most || value <= *expectation.at_most + tolerance) &&
         (!expectation.about || std::abs(value - *expectation.about) <= tolerance);
}

bool Judging::keeps(const std::optional<Interval>& interval) const {
  return interval && keeps(interval->low) && keeps(interval->high);
}

std::string Judging::shown(double value) const {
  const std::string text = brief(value, 5);
  for (const auto& limit : {expectation.at_least, expectation.at_most, expectation.about}) {
    if (limit && value != *limit && text == brief(*limit, 5)) {
      return number_text(value);
    }
  }
  return text;
}

std::string Judging::with_unit(double value) const {
  return shown(value) + (subject.unit.empty() ? "" : " " + subject.unit);
}

std::optional<double> Judging::value_of(const Run& run) const {
  if (expectation.runs == Runs::successes && !run.success()) {
    return std::nullopt;
  }
  if (run.broken()) {  // not successful; other values are unknown
    const bool success = !subject.measure && expectation.per.empty();
    return success ? std::optional(0.0) : std::nullopt;
  }
  const auto of = [&](const std::optional<std::size_t>& measure) {
    return measure ? run.values[*measure] : std::optional(run.success() ? 1.0 : 0.0);
  };
  std::optional<double> value = of(subject.measure);
  if (value && !expectation.per.empty()) {
    const std::optional<double> per = of(subject.per);
    value = per && *per != 0.0 ? std::optional(*value / *per) : std::nullopt;
  }
  return value && is_usable(*value) ? value : std::nullopt;
}

std::vector<double> Judging::values_of(std::size_t cell, bool infinite) const {
  std::vector<double> values;
  for (const std::size_t place : findings.cells[cell].runs) {
    const Run& run = results.runs[place];
    if (const auto value = value_of(run)) {
      const bool bound = infinite && findings.is_censored(run, *subject.measure);
      values.push_back(bound ? std::numeric_limits<double>::infinity() : *value);
    }
  }
  return values;
}

bool Judging::asks_for_success() const {
  return !subject.measure || expectation.runs == Runs::successes ||
         (!expectation.per.empty() && !subject.per);
}

std::size_t Judging::censored(std::size_t cell) const {
  return censored(cell, Outcome::time_limit) + censored(cell, Outcome::failure);
}

std::size_t Judging::censored(std::size_t cell, Outcome outcome) const {
  if (!subject.measure || !expectation.per.empty() || expectation.runs == Runs::successes) {
    return 0;
  }
  const auto& runs = findings.cells[cell].runs;
  return static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), [&](std::size_t run) {
    return results.runs[run].outcome == outcome && value_of(results.runs[run]) &&
           findings.is_censored(results.runs[run], *subject.measure);
  }));
}

std::string Judging::limits() const {
  const bool ratio = expectation.relation == Relation::ratio;
  const bool difference = expectation.relation == Relation::difference;
  const std::string unit = ratio || subject.unit.empty() ? "" : " " + subject.unit;
  const auto number = [&](double value) { return number_text(value) + unit; };
  // A difference below 0 is reported as "less", which turns "at least" into "at most".
  const auto amount = [&](const char* words, const char* if_less, double value) {
    if (!difference) {
      return words + number(value);
    }
    return (value < 0.0 ? if_less : words) + number(std::abs(value)) +
           (value < 0.0 ? " less" : " more");
  };
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " and ") + part; };
  if (expectation.at_least) {
    add(amount("at least ", "at most ", *expectation.at_least));
  }
  if (expectation.at_most) {
    add(amount("at most ", "at least ", *expectation.at_most));
  }
  if (expectation.about) {
    add(amount("about ", "about ", *expectation.about));
  }
  const std::string tolerance =
      expectation.tolerance > 0.0 ? " give or take " + number(expectation.tolerance) : "";
  if (ratio) {
    text += tolerance + " times that of the cell with ";
  } else if (difference) {
    text += " than in the cell with ";
  } else {
    text += tolerance;
  }
  for (std::size_t i = 0; i < expectation.reference.size(); ++i) {
    text +=
        (i ? ", " : "") + expectation.reference[i].factor + " " + expectation.reference[i].level;
  }
  text += difference ? tolerance : "";
  if (expectation.confidence) {
    text += ", with " + brief(100.0 * *expectation.confidence) + " % confidence";
  }
  return text;
}

std::string Judging::basis(const std::vector<double>& values) const {
  if (expectation.statistic != Statistic::rate) {
    return counted(values.size(), "run");
  }
  const auto hits = std::count_if(values.begin(), values.end(), [](double v) { return v != 0.0; });
  return std::to_string(hits) + " of " + std::to_string(values.size());
}

std::string Judging::reservations(std::size_t cell) const {
  if (findings.cells[cell].one_run) {
    return ", all the same run";
  }
  std::size_t broken = 0;
  for (const std::size_t run : findings.cells[cell].runs) {
    broken += results.runs[run].broken() ? 1 : 0;
  }
  if (broken == 0 || expectation.runs == Runs::successes) {
    return "";
  }
  return "; " + counted(broken, "run") + " ended abnormally";
}

std::string Judging::interval_in_words(const std::optional<Interval>& interval) const {
  if (!expectation.confidence) {
    return "";
  }
  if (!interval) {
    return "; too few for an interval";
  }
  return "; " + brief(100.0 * *expectation.confidence) + " % interval from " +
         shown(interval->low) + " to " + shown(interval->high);
}

std::string Judging::unknown(std::size_t cell, const std::vector<double>& values) const {
  const std::string who =
      expectation.runs == Runs::successes ? "successful run" : "run that ended normally";
  return (values.empty() ? "no " : "only one ") + who + " of " + label(cell) + " has a value";
}

Claim Judging::not_known(std::size_t cell, const std::string& why, bool open) const {
  Claim claim;
  claim.cell = cell;
  claim.open = open;
  claim.found =
      subject.words + " of " + label(cell) + " is not known" + (open ? " yet" : "") + ": " + why;
  claim.sentence = claim.found + "; expected " + limits();
  return claim;
}

std::optional<Claim> Judging::obstacle(std::size_t cell, std::size_t needed) const {
  if (asks_for_success() && !findings.cells[needed].goals) {
    return not_known(cell, "its world has no goals, so a run can neither succeed nor fail");
  }
  if (const std::size_t pending = findings.cells[needed].pending; pending > 0) {
    return not_known(cell,
                     "not all runs of " + label(needed) + " are done, " +
                         counted(pending, "is", "are") + " still to be done",
                     true);
  }
  return std::nullopt;
}

std::string Judging::stopped(std::size_t cell) const {
  const std::size_t stopped = censored(cell, Outcome::time_limit);
  const std::size_t failed = censored(cell, Outcome::failure);
  return (stopped > 0 ? counted(stopped, "run was", "runs were") + " stopped by the time limit"
                      : "") +
         (stopped > 0 && failed > 0 ? " and " : "") +
         (failed > 0 ? counted(failed, "run") + " failed" : "");
}

}  // namespace elsie::report
