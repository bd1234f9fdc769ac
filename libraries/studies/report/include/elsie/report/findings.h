// What the runs of an experiment come to: the cells in numbers, what stands out, and whether what
// was expected has come true. All forms of a report are made of this.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elsie/experiment/experiment.h"
#include "elsie/report/results.h"
#include "elsie/report/statistics.h"

namespace elsie::report {

/// The confidence of all intervals that are shown. An expectation may ask for another one.
inline constexpr double kConfidence = 0.95;

/// The measure that every run has: 1 when it reached its goals, else 0.
inline constexpr const char* kSuccess = "success";

/// The measure that a run stopped by its time limit has a lower bound of only: how long it takes to
/// reach the goals. What other measures count or add up, they do as long as the run goes on.
inline constexpr const char* kTime = "time_s";

/// A sample of which some values are only known to be larger than a limit, the same for all. Their
/// mean is not known. Quantiles below the limit are: as every value that is known lies below it,
/// the estimate of Kaplan and Meier (1958) is the plain distribution of the sample up to there.
struct Censoring {
  std::size_t count = 0;  // how many are only known to be larger
  double limit = 0.0;     // the least of the bounds
  std::optional<double> median;
  std::optional<Interval> median_interval;  // its upper end may be infinite: not below the limit
};

/// One measure in one cell, over the runs that ended by themselves and have it.
struct MeasureFindings {
  std::vector<double> values;          // in the order of the runs; bounds as if they were values
  std::optional<Summary> all;          // none when a value is censored
  std::optional<Censoring> censoring;  // then
  std::optional<Interval> interval;    // of the mean
  std::optional<Interval> fences;      // with fewer than kFewest values: none
  std::optional<Summary> successes;    // over the successful runs only

  /// Whether a value is outside of the fences, by more than rounding.
  bool stands_out(double value) const;
  /// By how much values differ that are the same but for rounding; there is a summary.
  double rounding() const;
};

/// With fewer values there are no outliers to be told from the others.
inline constexpr std::size_t kFewest = 5;

/// A value outside of its cell's fences.
struct Outlier {
  std::size_t run = 0;      // place in Results::runs
  std::size_t measure = 0;  // place in Results::measures
  double value = 0.0;
  double beyond = 0.0;  // how far outside, in quartile ranges; infinite when all others are equal
};

/// One cell. A sample has one run of each seed: a repetition is no second observation.
struct CellFindings {
  std::vector<std::size_t> runs;    // the sample, places in Results::runs
  std::vector<std::size_t> broken;  // of all repetitions
  std::size_t pending = 0;          // of all repetitions
  std::size_t ended = 0;            // of the sample
  std::size_t successes = 0;        // of the sample
  Interval success;                 // Wilson's interval of the rate of success
  /// Its world has some, or cannot be read; without goals a run can neither succeed nor fail.
  bool goals = true;
  std::vector<MeasureFindings> measures;  // in the order of Findings::measures
  std::vector<Outlier> outliers;          // the farthest first

  /// Two seeds or more, and all gave one and the same run: nothing in this cell is left to chance,
  /// and its runs are one observation.
  bool one_run = false;

  bool complete() const { return pending == 0; }
};

/// Runs of one cell and one seed that ended differently: something in them is not reproducible.
struct Disagreement {
  std::vector<std::size_t> runs;  // places in Results::runs
};

/// What one cell says to an expectation.
struct Claim {
  std::size_t cell = 0;
  bool holds = false;
  std::string found;     // "success rate of fusion is 0.95 (19 of 20)"
  std::string sentence;  // the same, and ", expected at least 1"
  std::optional<double> value;
  std::optional<Interval> interval;  // when the expectation asks for confidence
};

/// An expectation, held against the results.
struct Verdict {
  std::string name;
  std::string expected;  // "success rate: at least 0.9, with 95 % confidence"; "": the name says it
  std::vector<Claim> claims;  // about each cell that it concerns
  std::string trouble;        // why it cannot be judged; empty: it can

  bool met() const;
};

struct Findings {
  Results results;
  std::vector<std::size_t> measures;  // those to show, in order; places in Results::measures
  std::vector<CellFindings> cells;    // in the order of Results::cells
  std::vector<Disagreement> disagreements;
  std::vector<Verdict> verdicts;

  std::size_t runs() const { return results.runs.size(); }
  /// It ended by itself without success, in a world where there is some.
  bool missed(const Run& run) const;
  /// The time that it took to succeed is not known: it was stopped before.
  bool is_censored(const Run& run, std::size_t measure) const;
  /// Some cell has goals.
  bool any_goals() const;
  std::size_t ended() const;
  std::size_t broken() const;
  std::size_t pending() const { return runs() - ended(); }
  /// Runs of the experiment that are not in the database: that of a shard, or of some shards.
  std::size_t missing() const { return results.all_runs > runs() ? results.all_runs - runs() : 0; }
  bool partial() const { return missing() > 0; }
  /// All runs of the experiment ended by themselves, alike for the same seed, and every expectation
  /// is met.
  bool good() const;
};

/// What a report needs to know of the experiment.
struct Questions {
  std::vector<std::string> measures;  // to show; none: all
  std::vector<experiment::Expectation> expectations;
};

/// Works it all out. A measure to show that no run has is left out.
Findings find(Results results, const Questions& questions);

}  // namespace elsie::report
