// Statistics of small samples: what the runs of a cell come to.
//
// Everything here is a function of its arguments alone, down to the last bit: the same results give
// the same report.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "elsie/experiment/experiment.h"

namespace elsie::report {

using experiment::Relation;
using experiment::Statistic;

/// From `low` to `high`, both included.
struct Interval {
  double low = 0.0;
  double high = 0.0;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Whether a value can be reckoned with: finite, and so far from the largest number, 1e150 at most,
/// that squares and sums of many such values are finite, too. Others count as no value.
bool is_usable(double value);

/// A sample in numbers. All values are usable.
struct Summary {
  std::size_t count = 0;  // at least 1
  double mean = 0.0;
  /// With n - 1 below the line; none for a single value.
  std::optional<double> standard_deviation;
  double least = 0.0;
  double lower_quartile = 0.0;  // quantile() at 1/4
  double median = 0.0;          // quantile() at 1/2
  double upper_quartile = 0.0;  // quantile() at 3/4
  double largest = 0.0;

  double quartile_range() const { return upper_quartile - lower_quartile; }
};

/// None for an empty sample. Mean and standard deviation in two passes with the rounding error of
/// the first taken back (Chan, Golub and LeVeque 1983).
std::optional<Summary> summary(std::span<const double> values);

/// The quantile of an ascending sample that is not empty, `part` in [0, 1]: linear between the
/// order statistics, the first at 0 and the last at 1. Definition 7 of Hyndman and Fan (1996),
/// which R, S and NumPy take unless told otherwise.
double quantile(std::span<const double> ascending, double part);

/// One number about a sample that is not empty. A rate is the part of the values that are not zero;
/// the standard deviation of a single value is none.
std::optional<double> statistic_of(Statistic statistic, std::span<const double> values);

/// Wilson's score interval (1927) for a probability of which `successes` of `trials` were seen;
/// `confidence` in (0, 1). For no trials: from 0 to 1.
Interval wilson_interval(std::size_t successes, std::size_t trials, double confidence);

/// How many resamples a bootstrap interval is made of.
inline constexpr int kResamples = 4000;

/// The interval of a mean: bootstrap-t (Efron 1979; Hall 1988). The mean of each of kResamples
/// samples, drawn with replacement, is measured in its own standard errors, and the quantiles of
/// these take the place of Student's. With fewer than kFewestForBootstrap values, and where so many
/// resamples are one value over and over that a quantile is infinite, Student's t itself; and never
/// farther from the mean than kFarthest times Student's t, as where resamples of values that are
/// nearly equal have next to no spread. None for fewer than two values. `seed` and `path` name the
/// stream of random numbers: see Random.
///
/// How often it holds the mean, at 95 %: test_coverage.cpp.
std::optional<Interval> mean_interval(std::span<const double> values, double confidence,
                                      std::uint64_t seed, std::string_view path);

inline constexpr double kFarthest = 4.0;

/// Below, resamples have too few values to tell their spread.
inline constexpr std::size_t kFewestForBootstrap = 5;

/// The interval of a median: between two order statistics (Thompson 1936), so that it holds the
/// median at least as often as it says, whatever the distribution. None when the sample is too
/// small for that: at 95 %, fewer than six values. Values may be infinite.
std::optional<Interval> median_interval(std::span<const double> values, double confidence);

/// The percentile bootstrap interval of a statistic (Efron 1979; Efron and Tibshirani 1993, chapter
/// 13): its quantiles over kResamples samples of the same size. Too short for small samples: for
/// the mean of ten values it holds at 95 % what it should in 90 of 100 experiments. None for fewer
/// than two values.
std::optional<Interval> bootstrap_interval(Statistic statistic, std::span<const double> values,
                                           double confidence, std::uint64_t seed,
                                           std::string_view path);

/// The interval that suits the statistic: mean_interval(), median_interval(), wilson_interval() of
/// a rate, and for those left, bootstrap_interval().
std::optional<Interval> interval_of(Statistic statistic, std::span<const double> values,
                                    double confidence, std::uint64_t seed, std::string_view path);

/// What two cells have for one seed.
struct Pair {
  double cell = 0.0;
  double reference = 0.0;
};

/// The statistic of a cell beside that of its reference: their ratio or difference, by `relation`
/// (not Relation::none). None without pairs, when the statistic is none, and for a ratio to 0.
std::optional<double> relation_of(Relation relation, Statistic statistic,
                                  std::span<const Pair> pairs);

/// The interval of relation_of(). The pairs are drawn, so that both cells always have the same
/// seeds. For means it is that of mean_interval(), with the standard error of a difference or of a
/// ratio of means (delta method); for other statistics the percentile bootstrap. None when the
/// ratio may be one to 0: when too many resamples have none.
std::optional<Interval> paired_interval(Relation relation, Statistic statistic,
                                        std::span<const Pair> pairs, double confidence,
                                        std::uint64_t seed, std::string_view path);

/// How often something was seen.
struct Frequency {
  std::size_t hits = 0;
  std::size_t trials = 0;  // at least 1

  double rate() const { return static_cast<double>(hits) / static_cast<double>(trials); }
};

/// For the difference or the ratio of two probabilities, from the Wilson intervals of both, as a
/// bootstrap knows of no doubt where every run succeeded: Newcombe's method 10 (1998) for
/// differences, that of Donner and Zou (2012) for ratios. Both take the two for independent of each
/// other: where equal seeds succeed together they are wider than need be. None for a ratio to a
/// rate that may be 0.
std::optional<Interval> interval_of_rates(Relation relation, const Frequency& cell,
                                          const Frequency& reference, double confidence);

/// Values outside of these are outliers: 1.5 quartile ranges beyond the quartiles (Tukey 1977).
Interval tukey_fences(const Summary& summary);

/// Where a box plot's whiskers end: the outermost values within the fences.
Interval whiskers(std::span<const double> ascending, const Interval& fences);

}  // namespace elsie::report
