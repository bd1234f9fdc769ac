#include "judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "elsie/base/near_name.h"
#include "elsie/experiment/grid.h"

#include "numbers.h"
#include "words.h"

namespace elsie::report {

namespace {

using experiment::Expectation;
using experiment::Runs;

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

// The measures of an expectation as indices into Results::measures; kSuccess has none.
struct Subject {
  std::optional<std::size_t> measure, per;
  std::string words;
  std::string unit;  // of the statistic
};

constexpr const char* kNoGoals = "its world has no goals, so a run can neither succeed nor fail";

// Judges one expectation.
class Judge {
 public:
  Judge(const Expectation& expectation, const Findings& findings, const experiment::Grid& grid)
      : expectation_(expectation), findings_(findings), results_(findings.results), grid_(grid) {}

  Verdict verdict() {
    Verdict verdict;
    verdict.name = expectation_.name;
    verdict.trouble = find_subject();
    verdict.expected = expected();
    if (!verdict.trouble.empty()) {
      return verdict;
    }
    if (findings_.partial()) {
      verdict.trouble = missing_in_words(findings_) + "; an expectation is about all of them";
      return verdict;
    }
    for (const std::size_t cell : grid_.cells_of(expectation_)) {
      verdict.claims.push_back(expectation_.relation == Relation::none
                                   ? about(cell)
                                   : about(cell, grid_.reference_of(expectation_, cell)));
    }
    if (verdict.claims.empty()) {
      verdict.trouble = "there is no cell that it is about";
    }
    return verdict;
  }

 private:
  // The limits, unless the name states them: an expectation without a name is named after them.
  std::string expected() const {
    const bool difference = expectation_.relation == Relation::difference;
    const auto names = [&](const std::optional<double>& limit) {
      const auto tells = [&](const char* word) {
        const double value = limit && difference ? std::abs(*limit) : limit.value_or(0.0);
        return limit && expectation_.name.find(word + number_text(value)) != std::string::npos;
      };
      return tells(": at least ") || tells(": at most ") || tells(": about ");
    };
    if (!names(expectation_.at_least) && !names(expectation_.at_most) &&
        !names(expectation_.about)) {
      return subject_.words + ": " + limits();
    }
    return expectation_.confidence
               ? "with " + brief(100.0 * *expectation_.confidence) + " % confidence"
               : "";
  }

  // Finds the measures. Returns what is wrong with their names; "" if nothing.
  std::string find_subject() {
    std::vector<std::string> names{kSuccess};
    for (const Measure& measure : results_.measures) {
      names.push_back(measure.name);
    }
    const auto place = [&](const std::string& name, std::optional<std::size_t>& found) {
      for (std::size_t i = 0; i < results_.measures.size(); ++i) {
        if (results_.measures[i].name == name && name != kSuccess) {
          found = i;
        }
      }
      return found || name == kSuccess ? std::string() : unknown_measure(name, names);
    };
    const bool rate = expectation_.statistic == Statistic::rate;
    const bool plain = rate && expectation_.measure == kSuccess && expectation_.per.empty();
    subject_.words = plain ? "success rate"
                           : word_of(expectation_.statistic) + expectation_.measure +
                                 (expectation_.per.empty() ? "" : " per " + expectation_.per);
    if (expectation_.runs == Runs::successes) {
      subject_.words += " of successful runs";
    }
    std::string trouble = place(expectation_.measure, subject_.measure);
    if (trouble.empty() && !expectation_.per.empty()) {
      trouble = place(expectation_.per, subject_.per);
    }
    if (!rate && subject_.measure && expectation_.per.empty()) {
      subject_.unit = results_.measures[*subject_.measure].unit;
    }
    return trouble;
  }

  // Only runs that are done have measures, so that a name may be unknown because runs failed.
  std::string unknown_measure(const std::string& name,
                              const std::vector<std::string>& names) const {
    const std::size_t broken = findings_.broken(), pending = findings_.pending();
    const std::string what = "a measure '" + name + "'";
    if (pending == findings_.runs()) {
      return "no run has " + what + " yet: none is done";
    }
    if (broken + pending == findings_.runs()) {
      return "no run has " + what + ": " + broken_in_words(findings_) +
             (pending > 0 ? ", and " + counted(pending, "is", "are") + " still to be done" : "");
    }
    std::string others = broken > 0 ? broken_in_words(findings_) : "";
    if (pending > 0) {
      others += (others.empty() ? "" : ", and ") + counted(pending, "run is", "runs are") +
                " still to be done";
    }
    return (others.empty() ? "no run has " : "no run that ended normally has ") + what +
           base::did_you_mean(name, names) + (others.empty() ? "" : "; " + others);
  }

  std::string limits() const {
    const bool ratio = expectation_.relation == Relation::ratio;
    const bool difference = expectation_.relation == Relation::difference;
    const std::string unit = ratio || subject_.unit.empty() ? "" : " " + subject_.unit;
    const auto number = [&](double value) { return number_text(value) + unit; };
    // A difference below 0 is given as "less", which turns "at least" into "at most".
    const auto amount = [&](const char* words, const char* if_less, double value) {
      if (!difference) {
        return words + number(value);
      }
      return (value < 0.0 ? if_less : words) + number(std::abs(value)) +
             (value < 0.0 ? " less" : " more");
    };
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " and ") + part; };
    if (expectation_.at_least) {
      add(amount("at least ", "at most ", *expectation_.at_least));
    }
    if (expectation_.at_most) {
      add(amount("at most ", "at least ", *expectation_.at_most));
    }
    if (expectation_.about) {
      add(amount("about ", "about ", *expectation_.about));
    }
    const std::string tolerance =
        expectation_.tolerance > 0.0 ? " give or take " + number(expectation_.tolerance) : "";
    if (ratio) {
      text += tolerance + " times that of the cell with ";
    } else if (difference) {
      text += " than in the cell with ";
    } else {
      text += tolerance;
    }
    for (std::size_t i = 0; i < expectation_.reference.size(); ++i) {
      text += (i ? ", " : "") + expectation_.reference[i].factor + " " +
              expectation_.reference[i].level;
    }
    text += difference ? tolerance : "";
    if (expectation_.confidence) {
      text += ", with " + brief(100.0 * *expectation_.confidence) + " % confidence";
    }
    return text;
  }

  bool keeps(double value) const {
    const double tolerance = expectation_.tolerance;
    return (!expectation_.at_least || value >= *expectation_.at_least - tolerance) &&
           (!expectation_.at_most || value <= *expectation_.at_most + tolerance) &&
           (!expectation_.about || std::abs(value - *expectation_.about) <= tolerance);
  }

  bool keeps(const std::optional<Interval>& interval) const {
    return interval && keeps(interval->low) && keeps(interval->high);
  }

  // As few digits as are readable, but enough to tell the value from the limit.
  std::string shown(double value) const {
    const std::string text = brief(value, 5);
    for (const auto& limit : {expectation_.at_least, expectation_.at_most, expectation_.about}) {
      if (limit && value != *limit && text == brief(*limit, 5)) {
        return number_text(value);
      }
    }
    return text;
  }

  std::string with_unit(double value) const {
    return shown(value) + (subject_.unit.empty() ? "" : " " + subject_.unit);
  }

  // The value of one run; none: it has none.
  std::optional<double> value_of(const Run& run) const {
    if (expectation_.runs == Runs::successes && !run.success()) {
      return std::nullopt;
    }
    if (run.broken()) {  // not successful; other values are unknown
      const bool success = !subject_.measure && expectation_.per.empty();
      return success ? std::optional(0.0) : std::nullopt;
    }
    const auto of = [&](const std::optional<std::size_t>& measure) {
      return measure ? run.values[*measure] : std::optional(run.success() ? 1.0 : 0.0);
    };
    std::optional<double> value = of(subject_.measure);
    if (value && !expectation_.per.empty()) {
      const std::optional<double> per = of(subject_.per);
      value = per && *per != 0.0 ? std::optional(*value / *per) : std::nullopt;
    }
    return value && is_usable(*value) ? value : std::nullopt;
  }

  // `infinite`: values that are only known to be larger than a limit count as infinite.
  std::vector<double> values_of(std::size_t cell, bool infinite = false) const {
    std::vector<double> values;
    for (const std::size_t place : findings_.cells[cell].runs) {
      const Run& run = results_.runs[place];
      if (const auto value = value_of(run)) {
        const bool bound = infinite && findings_.is_censored(run, *subject_.measure);
        values.push_back(bound ? std::numeric_limits<double>::infinity() : *value);
      }
    }
    return values;
  }

  std::string label(std::size_t cell) const { return results_.cells[cell].label; }

  // The same draws for all cells: equal values have equal intervals.
  const std::string& stream() const { return expectation_.name; }

  // "19 of 20", "20 runs"
  std::string basis(const std::vector<double>& values) const {
    if (expectation_.statistic != Statistic::rate) {
      return counted(values.size(), "run");
    }
    const auto hits =
        std::count_if(values.begin(), values.end(), [](double v) { return v != 0.0; });
    return std::to_string(hits) + " of " + std::to_string(values.size());
  }

  // Reservations about the values of a cell: "; 2 runs ended abnormally".
  std::string reservations(std::size_t cell) const {
    if (findings_.cells[cell].one_run) {
      return ", all the same run";
    }
    std::size_t broken = 0;
    for (const std::size_t run : findings_.cells[cell].runs) {
      broken += results_.runs[run].broken() ? 1 : 0;
    }
    if (broken == 0 || expectation_.runs == Runs::successes) {
      return "";
    }
    return "; " + counted(broken, "run") + " ended abnormally";
  }

  std::string interval_in_words(const std::optional<Interval>& interval) const {
    if (!expectation_.confidence) {
      return "";
    }
    if (!interval) {
      return "; too few for an interval";
    }
    return "; " + brief(100.0 * *expectation_.confidence) + " % interval from " +
           shown(interval->low) + " to " + shown(interval->high);
  }

  std::string unknown(std::size_t cell, const std::vector<double>& values) const {
    const std::string who =
        expectation_.runs == Runs::successes ? "successful run" : "run that ended normally";
    return (values.empty() ? "no " : "only one ") + who + " of " + label(cell) + " has a value";
  }

  // "not all runs of fusion are done, 3 are still to be done"; "" if all are.
  std::string incomplete(std::size_t cell) const {
    const std::size_t pending = findings_.cells[cell].pending;
    return pending == 0 ? ""
                        : "not all runs of " + label(cell) + " are done, " +
                              counted(pending, "is", "are") + " still to be done";
  }

  Claim not_known(std::size_t cell, const std::string& why) const {
    Claim claim;
    claim.cell = cell;
    claim.found = subject_.words + " of " + label(cell) + " is not known: " + why;
    claim.sentence = claim.found + "; expected " + limits();
    return claim;
  }

  // Judges a cell alone.
  Claim about(std::size_t cell) const {
    const std::string missing = incomplete(cell);
    if (!missing.empty()) {
      return not_known(cell, missing);
    }
    if (asks_for_success() && !findings_.cells[cell].goals) {
      return not_known(cell, kNoGoals);
    }
    const std::vector<double> values = values_of(cell);
    if (const std::size_t count = censored(cell); count > 0) {
      return about_bounds(cell, values, values_of(cell, true), count);
    }
    Claim claim;
    claim.cell = cell;
    if (!values.empty()) {
      claim.value = statistic_of(expectation_.statistic, values);
    }
    if (!claim.value) {
      return not_known(cell, unknown(cell, values));
    }
    claim.holds = keeps(*claim.value);
    if (expectation_.confidence) {
      claim.interval = interval_of(values);
      claim.holds = keeps(claim.interval);
    }
    claim.found = subject_.words + " of " + label(cell) + " is " + with_unit(*claim.value) + " (" +
                  basis(values) + interval_in_words(claim.interval) + reservations(cell) + ")";
    claim.sentence = claim.found + ", expected " + limits();
    return claim;
  }

  std::optional<Interval> interval_of(const std::vector<double>& values) const {
    return report::interval_of(expectation_.statistic, values, *expectation_.confidence,
                               results_.seed(), stream());
  }

  // Whether it is about success, which has no meaning in a world without goals.
  bool asks_for_success() const {
    return !subject_.measure || expectation_.runs == Runs::successes ||
           (!expectation_.per.empty() && !subject_.per);
  }

  // The number of values that are only lower bounds, from runs that the time limit stopped.
  std::size_t censored(std::size_t cell) const {
    if (!subject_.measure || !expectation_.per.empty() || expectation_.runs == Runs::successes) {
      return 0;
    }
    const auto& runs = findings_.cells[cell].runs;
    return static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), [&](std::size_t run) {
      return value_of(results_.runs[run]) &&
             findings_.is_censored(results_.runs[run], *subject_.measure);
    }));
  }

  // "3 runs were stopped by the time limit"
  static std::string stopped(std::size_t runs) {
    return counted(runs, "run was", "runs were") + " stopped by the time limit";
  }

  // Judges a cell with lower bounds: its mean and maximum are bounds, too. A median or minimum,
  // with infinity in place of the bounds, is exact if it is finite.
  Claim about_bounds(std::size_t cell, const std::vector<double>& bounds,
                     const std::vector<double>& infinite, std::size_t count) const {
    const Statistic statistic = expectation_.statistic;
    if (statistic == Statistic::standard_deviation || statistic == Statistic::rate) {
      return not_known(cell, stopped(count));
    }
    const bool ordered = statistic == Statistic::median || statistic == Statistic::minimum;
    const double value = *statistic_of(statistic, ordered ? infinite : bounds);
    Claim claim;
    claim.cell = cell;
    std::string amount;
    if (std::isfinite(value) && ordered) {
      claim.value = value;
      claim.holds = keeps(value);
      if (expectation_.confidence) {
        claim.interval = interval_of(infinite);
        claim.holds = keeps(claim.interval);
      }
      amount = with_unit(value) + " (" + basis(bounds) + interval_in_words(claim.interval);
    } else {
      // The mean of times cut off at the limit is at most that of the true times.
      const double least = *statistic_of(statistic, bounds);
      const auto interval =
          expectation_.confidence ? interval_of(bounds) : std::optional(Interval{least, least});
      claim.holds =
          !expectation_.at_most && !expectation_.about && interval && keeps(interval->low);
      amount = "at least " + with_unit(least) + " (" + basis(bounds);
    }
    claim.found = subject_.words + " of " + label(cell) + " is " + amount + "; " + stopped(count) +
                  reservations(cell) + ")";
    claim.sentence = claim.found + ", expected " + limits();
    return claim;
  }

  // Judges a cell relative to its reference.
  Claim about(std::size_t cell, std::optional<std::size_t> reference) const {
    if (!reference) {
      return not_known(cell, "there is no cell to compare it with");
    }
    for (const std::size_t each : {cell, *reference}) {
      const std::string missing = incomplete(each);
      if (!missing.empty()) {
        return not_known(cell, missing);
      }
      if (asks_for_success() && !findings_.cells[each].goals) {
        return not_known(cell, kNoGoals);
      }
      if (const std::size_t count = censored(each); count > 0) {
        return not_known(cell, "of " + label(each) + " " + stopped(count));
      }
    }
    const std::vector<Pair> pairs = pairs_of(cell, *reference);
    if (pairs.empty()) {
      return not_known(cell, no_pair(cell, *reference));
    }
    std::vector<double> own, others;
    for (const Pair& pair : pairs) {
      own.push_back(pair.cell);
      others.push_back(pair.reference);
    }
    const auto mine = statistic_of(expectation_.statistic, own);
    const auto theirs = statistic_of(expectation_.statistic, others);
    const bool ratio = expectation_.relation == Relation::ratio;
    if (ratio && theirs == 0.0) {
      return not_known(cell, "that of " + label(*reference) + " is 0");
    }
    Claim claim;
    claim.cell = cell;
    claim.value = relation_of(expectation_.relation, expectation_.statistic, pairs);
    if (!claim.value || !mine || !theirs) {
      return not_known(cell, "that of " + label(*reference) + " has no value to compare it with");
    }
    claim.holds = keeps(*claim.value);
    if (expectation_.confidence) {
      claim.interval = interval_of(pairs);
      claim.holds = keeps(claim.interval);
    }
    claim.found = subject_.words + " of " + label(cell) + " is " +
                  (ratio ? shown(*claim.value) + " times that of "
                         : with_unit(std::abs(*claim.value)) +
                               (*claim.value < 0.0 ? " less" : " more") + " than that of ") +
                  label(*reference) + " (" + with_unit(*mine) + ", " + basis(own) +
                  reservations(cell) + ", against " + with_unit(*theirs) + ", " + basis(others) +
                  reservations(*reference) + left_out(cell, *reference, pairs.size()) +
                  (ratio && pairs.size() > 1 && !claim.interval && expectation_.confidence
                       ? "; no interval, as that of " + label(*reference) + " may be 0"
                       : interval_in_words(claim.interval)) +
                  ")";
    claim.sentence = claim.found + ", expected " + limits();
    return claim;
  }

  // The values of both cells for each seed. Seeds with only one value are left out: those at which
  // one cell fails may be the hard ones.
  std::vector<Pair> pairs_of(std::size_t cell, std::size_t reference) const {
    std::map<std::uint64_t, double> others;
    for (const std::size_t run : findings_.cells[reference].runs) {
      if (const auto value = value_of(results_.runs[run])) {
        others[results_.runs[run].seed] = *value;
      }
    }
    std::map<std::uint64_t, Pair> pairs;
    for (const std::size_t run : findings_.cells[cell].runs) {
      const auto value = value_of(results_.runs[run]);
      const auto other = others.find(results_.runs[run].seed);
      if (value && other != others.end()) {
        pairs[results_.runs[run].seed] = {*value, other->second};
      }
    }
    std::vector<Pair> all;
    for (const auto& [seed, pair] : pairs) {
      all.push_back(pair);
    }
    return all;
  }

  std::string no_pair(std::size_t cell, std::size_t reference) const {
    for (const std::size_t each : {cell, reference}) {
      if (const auto values = values_of(each); values.empty()) {
        return unknown(each, values);
      }
    }
    return "there is no seed with which " + label(cell) + " and " + label(reference) +
           (expectation_.runs == Runs::successes ? " both succeeded" : " both have a value");
  }

  // "; of the seeds with which both succeeded", or "" if these are all seeds.
  std::string left_out(std::size_t cell, std::size_t reference, std::size_t pairs) const {
    const std::size_t most =
        std::max(findings_.cells[cell].runs.size(), findings_.cells[reference].runs.size());
    return pairs == most                          ? ""
           : expectation_.runs == Runs::successes ? "; of the seeds with which both succeeded"
                                                  : "; of the seeds for which both have a value";
  }

  std::optional<Interval> interval_of(const std::vector<Pair>& pairs) const {
    if (expectation_.statistic != Statistic::rate) {
      return paired_interval(expectation_.relation, expectation_.statistic, pairs,
                             *expectation_.confidence, results_.seed(), stream());
    }
    Frequency own{0, pairs.size()}, other{0, pairs.size()};
    for (const Pair& pair : pairs) {
      own.hits += pair.cell != 0.0 ? 1 : 0;
      other.hits += pair.reference != 0.0 ? 1 : 0;
    }
    return interval_of_rates(expectation_.relation, own, other, *expectation_.confidence);
  }

  const Expectation& expectation_;
  const Findings& findings_;
  const Results& results_;
  const experiment::Grid& grid_;
  Subject subject_;
};

}  // namespace

Verdict judge(const Expectation& expectation, const Findings& findings,
              const experiment::Grid& grid) {
  return Judge(expectation, findings, grid).verdict();
}

}  // namespace elsie::report
