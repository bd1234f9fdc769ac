// Two groups compared: effect sizes and exact tests.
//
// All tests are two-sided. Values of which only a bound is known are ordered as far as that goes
// (Gehan 1965): a bound is above every known value up to it, and nothing is known of two bounds.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "elsie/report/statistics.h"
#include "elsie/report/survival.h"

namespace elsie::report {

struct Effect {
  double value = 0.0;
  std::optional<Interval> interval;
};

struct RankTest {
  /// Cliff's delta (1993): how much more often a value of the first group is above one of the
  /// second than below, from -1 to 1. The interval is the asymmetric one of Cliff (1996), of groups
  /// without any overlap that of Feng and Cliff (2004); none for fewer than two values in a group.
  Effect delta;
  /// Of the test of Mann and Whitney (1947), with bounds that of Gehan: its permutation
  /// distribution, ties and bounds included.
  double p = 1.0;
  bool exact = true;  // else the normal approximation, with correction for continuity
};

/// Up to this many values in both groups together, the test is exact.
inline constexpr std::size_t kMostForExactRanks = 60;

/// Both groups must have values.
RankTest rank_test(std::span<const Observed> first, std::span<const Observed> second,
                   double confidence);

/// The difference of means in pooled standard deviations, corrected for small samples (Hedges
/// 1981), with the interval of its normal approximation (Hedges and Olkin 1985). None for fewer
/// than two values in a group, and without a spread above kRoundingOfRuns.
std::optional<Effect> hedges_g(std::span<const double> first, std::span<const double> second,
                               double confidence);

/// The odds of the first over those of the second, with the interval of Woolf (1955). Where one of
/// the four numbers is 0, each gets one half more (Haldane 1956, Anscombe 1956).
Effect odds_ratio(const Frequency& first, const Frequency& second, double confidence);

/// Fisher's exact test (1935): the probability of all tables with these margins that are at most as
/// probable as this one.
double fisher_test(const Frequency& first, const Frequency& second);

/// A test of paired differences.
struct PairTest {
  std::size_t above = 0, below = 0;  // differences that are not 0
  double p = 1.0;
  bool exact = true;
};

/// Wilcoxon's signed-rank test (1945). Differences of 0 are left out, equal ones share their rank.
/// Exact with up to kMostForExactSigns differences, and if all have the same size, where it is the
/// sign test; else the normal approximation.
PairTest signed_rank_test(std::span<const double> differences);

inline constexpr std::size_t kMostForExactSigns = 60;

/// The p-values so enlarged that, over all of them, the chance of any false rejection stays below
/// the level at which each is judged (Holm 1979). In the order of `p`.
std::vector<double> holm(std::span<const double> p);

}  // namespace elsie::report
