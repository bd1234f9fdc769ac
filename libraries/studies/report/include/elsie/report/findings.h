// Findings: the results of an experiment as numbers for each cell, its outliers, and whether its
// expectations are met. All forms of a report are made from them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elsie/experiment/experiment.h"
#include "elsie/report/results.h"
#include "elsie/report/statistics.h"

namespace elsie::report {

/// The confidence of all intervals in the report. An expectation may ask for another.
inline constexpr double kConfidence = 0.95;

/// A measure of every run: 1 if it reached its goals, else 0.
inline constexpr const char* kSuccess = "success";

/// The time until the goals are reached. In a run that its time limit stopped, this measure has
/// only a lower bound. Other measures count or sum what happened during the run.
inline constexpr const char* kTime = "time_s";

/// A sample in which some values are only known to be larger than a common limit. Its mean is
/// unknown. Quantiles below the limit are known: all known values are below it, so that the
/// estimate of Kaplan and Meier (1958) is the plain distribution of the sample up to the limit.
struct Censoring {
  std::size_t count = 0;        // number of these values
  std::size_t failures = 0;     // of these, runs that failed: they never reach their goals
  std::optional<double> limit;  // the smallest bound of the others
  std::optional<double> least;  // the smallest known value
  std::optional<double> median;
  /// As of the curve (see survival.h); the upper end may be infinite: at least the limit.
  std::optional<Interval> median_interval;
};

/// One measure in one cell, over the runs that are done and have a value.
struct MeasureFindings {
  std::vector<double> values;          // in the order of the runs; bounds count as values
  std::optional<Summary> all;          // none when a value is censored
  std::optional<Censoring> censoring;  // when a value is censored
  std::optional<Interval> interval;    // of the mean
  std::optional<Interval> fences;      // none with fewer than kFewest values
  std::optional<Summary> successes;    // over the successful runs only

  /// Returns whether a value is outside of the fences by more than rounding.
  bool stands_out(double value) const;
  /// The largest difference between values that counts as rounding. Requires a summary.
  double rounding() const;
};

/// Smaller samples have no outliers.
inline constexpr std::size_t kFewest = 5;

/// A value outside of its cell's fences.
struct Outlier {
  std::size_t run = 0;      // index into Results::runs
  std::size_t measure = 0;  // index into Results::measures
  double value = 0.0;
  double beyond = 0.0;  // distance from the fence in quartile ranges; infinite if these are 0
};

/// One cell. Its sample has one run of each seed: a repetition is not another observation.
struct CellFindings {
  std::vector<std::size_t> runs;    // the sample, indices into Results::runs
  std::vector<std::size_t> broken;  // with repetitions
  std::size_t pending = 0;          // with repetitions
  std::size_t ended = 0;            // of the sample
  std::size_t successes = 0;        // of the sample
  Interval success;                 // Wilson's interval of the rate of success
  /// True if the world has goals or cannot be read; without goals, a run cannot succeed or fail.
  bool goals = true;
  std::vector<MeasureFindings> measures;  // in the order of Findings::measures
  std::vector<Outlier> outliers;          // the farthest first

  /// True if there are several seeds and all gave the same run: nothing in this cell is random, and
  /// its runs are one observation.
  bool one_run = false;

  bool complete() const { return pending == 0; }
};

/// Runs of one cell and one seed that ended differently: something in them is not reproducible.
struct Disagreement {
  std::vector<std::size_t> runs;  // indices into Results::runs
};

/// The judgement of an expectation in one cell.
struct Claim {
  std::size_t cell = 0;
  bool holds = false;
  /// Not known yet, because runs are still to be done: neither met nor missed.
  bool open = false;
  std::string found;     // "success rate of fusion is 0.95 (19 of 20)"
  std::string sentence;  // `found` followed by ", expected at least 1"
  std::optional<double> value;
  std::optional<Interval> interval;  // if the expectation asks for confidence
};

/// An expectation with its judgement.
struct Verdict {
  std::string name;
  std::string expected;  // "success rate: at least 0.9, with 95 % confidence"; "": the name says so
  std::vector<Claim> claims;  // one for each cell that it covers
  std::string trouble;        // why it cannot be judged; empty if it can
  bool waits = false;         // the trouble may end when all runs are done

  bool met() const;
  /// Returns whether it is not known yet: runs are missing, and no cell is known to miss it.
  bool open() const;
};

struct Findings {
  Results results;
  std::vector<std::size_t> measures;  // to be shown, in order; indices into Results::measures
  std::vector<double> largest;        // value of each of these in all runs; -infinity: none
  std::vector<CellFindings> cells;    // parallel to Results::cells
  /// For each run, the first one that it repeats bit by bit, itself if there is none: a run with
  /// the same seed, state hash and number of steps, in any cell. Indices into Results::runs.
  std::vector<std::size_t> originals;
  std::vector<Disagreement> disagreements;
  std::vector<Verdict> verdicts;

  std::size_t runs() const { return results.runs.size(); }
  /// Returns whether the run is done without success, in a world with goals.
  bool missed(const Run& run) const;
  /// Returns whether the value is only a lower bound, because the run was stopped or failed before
  /// it reached its goals: a value of its time, or of a formula that rises with it.
  bool is_censored(const Run& run, std::size_t measure) const;
  /// Returns whether any cell has goals.
  bool any_goals() const;
  std::size_t ended() const;
  std::size_t broken() const;
  std::size_t pending() const { return runs() - ended(); }
  /// The number of runs that are not in the database, because it holds only some of the shards.
  std::size_t missing() const { return results.all_runs > runs() ? results.all_runs - runs() : 0; }
  bool partial() const { return missing() > 0; }
  /// Returns whether all runs of the experiment are done, runs of the same seed are equal, and
  /// every expectation is met.
  bool good() const;
  /// Returns whether nothing is known to be wrong, but runs are missing: good() is not known yet.
  bool open() const;
};

/// The parts of the experiment that the report answers.
struct Questions {
  std::vector<std::string> measures;  // measures to show; none: all
  std::vector<experiment::Expectation> expectations;
};

/// Computes the findings. Leaves out measures to show that no run has.
Findings find(Results results, const Questions& questions);

}  // namespace elsie::report
