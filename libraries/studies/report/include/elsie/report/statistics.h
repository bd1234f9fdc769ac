// Statistics of small samples, the runs of a cell.
//
// Results depend only on the arguments, bit by bit: the same database gives the same report.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "elsie/experiment/experiment.h"
#include "elsie/picture/axis.h"

namespace elsie::report {

using experiment::Relation;
using experiment::Statistic;
using picture::Interval;

/// Returns whether a value can be used: finite, and at most 1e150, so that squares and sums of many
/// such values are also finite. Other values count as missing.
bool is_usable(double value);

/// Summary statistics of a sample. All values must be usable.
struct Summary {
  std::size_t count = 0;  // at least 1
  double mean = 0.0;
  /// With divisor n - 1; none for a single value.
  std::optional<double> standard_deviation;
  double least = 0.0;
  double lower_quartile = 0.0;  // quantile() at 1/4
  double median = 0.0;          // quantile() at 1/2
  double upper_quartile = 0.0;  // quantile() at 3/4
  double largest = 0.0;

  double quartile_range() const { return upper_quartile - lower_quartile; }
};

/// None for an empty sample. Computes mean and standard deviation in two passes, corrected for the
/// rounding error of the first (Chan, Golub and LeVeque 1983).
std::optional<Summary> summary(std::span<const double> values);

/// The quantile of an ascending, nonempty sample, `part` in [0, 1]: linear between the order
/// statistics, the first at 0 and the last at 1. Definition 7 of Hyndman and Fan (1996), the
/// default of R, S and NumPy.
double quantile(std::span<const double> ascending, double part);

/// A statistic of a nonempty sample. A rate is the share of values other than 0; a single value has
/// no standard deviation.
std::optional<double> statistic_of(Statistic statistic, std::span<const double> values);

/// Wilson's score interval (1927) of a probability, from `successes` in `trials`; `confidence` in
/// (0, 1). Without trials: from 0 to 1.
Interval wilson_interval(std::size_t successes, std::size_t trials, double confidence);

/// The same for a rate that is not that of whole trials; `trials` above 0.
Interval wilson_interval_of_rate(double rate, double trials, double confidence);

/// The number of resamples of a bootstrap interval.
inline constexpr int kResamples = 4000;

/// The interval of a mean: bootstrap-t (Efron 1979; Hall 1988). The deviation of the mean of each
/// of kResamples samples, drawn with replacement, is divided by its own standard error; the
/// quantiles of these ratios replace Student's. Student's t is used with fewer than
/// kFewestForBootstrap values, and if so many resamples repeat one value that a quantile is
/// infinite. The interval reaches at most kFarthest times as far from the mean as Student's t,
/// because resamples of nearly equal values have almost no spread. None for fewer than two values.
/// `seed` and `path` select the stream of random numbers: see Random.
///
/// test_coverage.cpp shows how often it contains the mean at 95 %.
std::optional<Interval> mean_interval(std::span<const double> values, double confidence,
                                      std::uint64_t seed, std::string_view path);

inline constexpr double kFarthest = 4.0;

/// Resamples of smaller samples have too few values to estimate their spread.
inline constexpr std::size_t kFewestForBootstrap = 5;

/// The interval of a median: between two order statistics (Thompson 1936), so that it contains the
/// median at least as often as stated, for any distribution. None when the sample is too small: at
/// 95 %, fewer than six values. Values may be infinite. It is for judging a cell at any confidence;
/// the medians of times, some of which are only bounds, have that of survival_of().
std::optional<Interval> median_interval(std::span<const double> values, double confidence);

/// The percentile bootstrap interval of a statistic (Efron 1979; Efron and Tibshirani 1993, chapter
/// 13): its quantiles over kResamples samples of the same size. Too short for small samples: at 95
/// % and ten values, it contains the mean in 90 of 100 experiments. None for fewer than two values.
std::optional<Interval> bootstrap_interval(Statistic statistic, std::span<const double> values,
                                           double confidence, std::uint64_t seed,
                                           std::string_view path);

/// The interval that suits the statistic: mean_interval(), median_interval(), wilson_interval() for
/// a rate, bootstrap_interval() for others.
std::optional<Interval> interval_of(Statistic statistic, std::span<const double> values,
                                    double confidence, std::uint64_t seed, std::string_view path);

/// The values of two cells for one seed.
struct Pair {
  double cell = 0.0;
  double reference = 0.0;
};

/// The ratio or difference, by `relation` (not Relation::none), of a cell's statistic and that of
/// its reference. None without pairs, if a statistic is none, and for a ratio to 0.
std::optional<double> relation_of(Relation relation, Statistic statistic,
                                  std::span<const Pair> pairs);

/// The interval of relation_of(). Pairs are resampled, so that both cells always have the same
/// seeds. For means it is computed like mean_interval(), with the standard error of a difference or
/// of a ratio of means (delta method); for other statistics, by the percentile bootstrap. None if
/// the reference may be 0, that is, if too many resamples have no ratio.
std::optional<Interval> paired_interval(Relation relation, Statistic statistic,
                                        std::span<const Pair> pairs, double confidence,
                                        std::uint64_t seed, std::string_view path);

/// The frequency of an observed event.
struct Frequency {
  std::size_t hits = 0;
  std::size_t trials = 0;  // at least 1

  double rate() const { return static_cast<double>(hits) / static_cast<double>(trials); }
};

/// The interval of the difference or the ratio of two probabilities, from the Wilson intervals of
/// both, because a bootstrap shows no uncertainty if every run succeeded: Newcombe's method 10
/// (1998) for differences, that of Donner and Zou (2012) for ratios. Both assume independence: if
/// equal seeds tend to succeed together, the interval is wider than necessary. None for a ratio to
/// a rate that may be 0.
std::optional<Interval> interval_of_rates(Relation relation, const Frequency& cell,
                                          const Frequency& reference, double confidence);

/// Values that differ by at most this part of their size are taken as equal. Rounding begins at
/// 1e-16, but contacts amplify it from step to step: between levels without any effect, differences
/// of 1e-7 are seen.
inline constexpr double kRoundingOfRuns = 1e-6;

/// Whether values from `least` to `largest` differ by rounding only.
bool are_equal(double least, double largest);

/// Values outside of this interval are outliers (Tukey 1977): 1.5 quartile ranges beyond quartiles.
Interval tukey_fences(const Summary& summary);

/// The ends of a box plot's whiskers: the outermost values within the fences.
Interval whiskers(std::span<const double> ascending, const Interval& fences);

}  // namespace elsie::report
