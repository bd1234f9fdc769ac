#include <cmath>
#include <vector>

#include <boost/math/distributions/binomial.hpp>
#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/report/statistics.h"

using namespace elsie::report;

namespace {

// NIST, Statistical Reference Datasets: univariate summary statistics.
std::vector<double> michelson() {
  return {299.85, 299.74, 299.90, 300.07, 299.93, 299.85, 299.95, 299.98, 299.98, 299.88,
          300.00, 299.98, 299.93, 299.65, 299.76, 299.81, 300.00, 300.00, 299.96, 299.96,
          299.96, 299.94, 299.96, 299.94, 299.88, 299.80, 299.85, 299.88, 299.90, 299.84,
          299.83, 299.79, 299.81, 299.88, 299.88, 299.83, 299.80, 299.79, 299.76, 299.80,
          299.88, 299.88, 299.88, 299.86, 299.72, 299.72, 299.62, 299.86, 299.97, 299.95,
          299.88, 299.91, 299.85, 299.87, 299.84, 299.84, 299.85, 299.84, 299.84, 299.84,
          299.89, 299.81, 299.81, 299.82, 299.80, 299.77, 299.76, 299.74, 299.75, 299.76,
          299.91, 299.92, 299.89, 299.86, 299.88, 299.72, 299.84, 299.85, 299.85, 299.78,
          299.89, 299.84, 299.78, 299.81, 299.76, 299.81, 299.79, 299.81, 299.82, 299.85,
          299.87, 299.87, 299.81, 299.74, 299.81, 299.94, 299.95, 299.80, 299.81, 299.87};
}

// NumAcc3 and NumAcc4 of the same source: a first value, then two others alternating.
std::vector<double> in_turns(double first, double a, double b) {
  std::vector<double> values{first};
  for (int i = 0; i < 500; ++i) {
    values.push_back(a);
    values.push_back(b);
  }
  return values;
}

}  // namespace

TEST_CASE("Mean and standard deviation are those that NIST certifies") {
  const auto light = *summary(michelson());
  CHECK(light.count == 100);
  CHECK(light.mean == Approx(299.852400000000).epsilon(1e-14));
  CHECK(*light.standard_deviation == Approx(0.0790105478190518).epsilon(1e-12));

  const auto stiff = *summary(std::vector{10000001.0, 10000003.0, 10000002.0});  // NumAcc1
  CHECK(stiff.mean == 10000002.0);
  CHECK(*stiff.standard_deviation == 1.0);

  const auto third = *summary(in_turns(1000000.2, 1000000.1, 1000000.3));  // NumAcc3
  CHECK(third.mean == Approx(1000000.2).epsilon(1e-15));
  CHECK(*third.standard_deviation == Approx(0.1).epsilon(1e-9));
  const auto fourth = *summary(in_turns(10000000.2, 10000000.1, 10000000.3));  // NumAcc4
  CHECK(fourth.mean == Approx(10000000.2).epsilon(1e-15));
  CHECK(*fourth.standard_deviation == Approx(0.1).epsilon(1e-8));
}

TEST_CASE("A sample's numbers do not depend on the order of its values") {
  std::vector<double> values = michelson();
  const auto before = *summary(values);
  std::vector<double> turned(values.rbegin(), values.rend());
  const auto after = *summary(turned);
  CHECK(before.mean == after.mean);
  CHECK(before.standard_deviation == after.standard_deviation);
  CHECK(mean_interval(values, 0.95, 1, "x") == mean_interval(turned, 0.95, 1, "x"));
}

TEST_CASE("Quartiles are those of Hyndman and Fan's definition 7") {
  // R: quantile(c(1, 2, 3, 4), type = 7) and quantile(c(15, 20, 35, 40, 50), c(.05, .3, .4), type =
  // 7)
  const std::vector<double> four{1, 2, 3, 4};
  CHECK(quantile(four, 0.25) == 1.75);
  CHECK(quantile(four, 0.5) == 2.5);
  CHECK(quantile(four, 0.75) == 3.25);
  const std::vector<double> five{15, 20, 35, 40, 50};
  CHECK(quantile(five, 0.05) == Approx(16.0));
  CHECK(quantile(five, 0.3) == Approx(23.0));
  CHECK(quantile(five, 0.4) == Approx(29.0));
  CHECK(quantile(five, 0.0) == 15.0);
  CHECK(quantile(five, 1.0) == 50.0);
  CHECK(quantile(std::vector{7.0}, 0.3) == 7.0);
}

TEST_CASE("Few values have few numbers") {
  CHECK_FALSE(summary(std::vector<double>{}));
  const auto one = *summary(std::vector{3.5});
  CHECK(one.mean == 3.5);
  CHECK(one.median == 3.5);
  CHECK_FALSE(one.standard_deviation);
  CHECK_FALSE(mean_interval(std::vector{3.5}, 0.95, 1, ""));
  CHECK_FALSE(bootstrap_interval(Statistic::maximum, std::vector{3.5}, 0.95, 1, ""));
  CHECK_FALSE(statistic_of(Statistic::standard_deviation, std::vector{3.5}));
}

TEST_CASE("Statistics of a sample") {
  const std::vector<double> values{4, 0, 2, 0, 9};
  CHECK(*statistic_of(Statistic::mean, values) == 3.0);
  CHECK(*statistic_of(Statistic::median, values) == 2.0);
  CHECK(*statistic_of(Statistic::minimum, values) == 0.0);
  CHECK(*statistic_of(Statistic::maximum, values) == 9.0);
  CHECK(*statistic_of(Statistic::rate, values) == Approx(0.6));
  CHECK(*statistic_of(Statistic::standard_deviation, values) == Approx(std::sqrt(14.0)));
}

TEST_CASE("Wilson's interval is that of Newcombe's table") {
  // Newcombe, "Two-sided confidence intervals for the single proportion" (1998), table I, method 3.
  const auto check = [](std::size_t successes, std::size_t trials, double low, double high) {
    const Interval interval = wilson_interval(successes, trials, 0.95);
    CHECK(interval.low == Approx(low).margin(5e-5));
    CHECK(interval.high == Approx(high).margin(5e-5));
  };
  check(81, 263, 0.2553, 0.3662);
  check(15, 148, 0.0624, 0.1605);
  check(0, 20, 0.0, 0.1611);
  check(1, 29, 0.0061, 0.1718);
  CHECK(wilson_interval(20, 20, 0.95).high == 1.0);
  CHECK(wilson_interval(20, 20, 0.95).low == Approx(1.0 - 0.1611).margin(5e-5));
  CHECK(wilson_interval(0, 0, 0.95) == Interval{0.0, 1.0});
  CHECK(wilson_interval(19, 20, 0.99).low < wilson_interval(19, 20, 0.95).low);
}

TEST_CASE("The bootstrap of zeros and ones is the binomial distribution") {
  // 12 of 30: the sum of a resample is binomial with n = 30, p = 0.4, whose quantiles are known.
  std::vector<double> values(30, 0.0);
  std::fill(values.begin(), values.begin() + 12, 1.0);
  const boost::math::binomial sums(30.0, 0.4);
  for (const double confidence : {0.8, 0.95, 0.99}) {
    const auto found = *bootstrap_interval(Statistic::mean, values, confidence, 42, "binomial");
    const double tail = 0.5 * (1.0 - confidence);
    // Within one success: the quantile of a sample may fall on the next step.
    CHECK(30.0 * found.low == Approx(quantile(sums, tail)).margin(1.01));
    CHECK(30.0 * found.high == Approx(quantile(complement(sums, tail))).margin(1.01));
  }
}

TEST_CASE("The bootstrap of a mean has the plug-in standard error") {
  // Efron and Tibshirani (1993), table 2.1, treated mice: mean 86.86, standard error 23.36 by the
  // formula with divisor n. Normal quantiles are close enough for 7 mice.
  const std::vector<double> mice{94, 197, 16, 38, 99, 141, 23};
  CHECK(*statistic_of(Statistic::mean, mice) == Approx(86.86).margin(5e-3));
  const auto interval = *bootstrap_interval(Statistic::mean, mice, 0.6827, 7, "mice");
  CHECK(0.5 * (interval.high - interval.low) == Approx(23.36).epsilon(0.06));
}

TEST_CASE("With few values, or with resamples that do not spread, Student's t takes over") {
  // Of {1, 2, 3}: mean 2, standard error 1/sqrt(3), t(0.975; 2) = 4.302653.
  const auto three = *mean_interval(std::vector<double>{1, 2, 3}, 0.95, 1, "");
  CHECK(three.low == Approx(2.0 - 4.302653 / std::sqrt(3.0)));
  CHECK(three.high == Approx(2.0 + 4.302653 / std::sqrt(3.0)));
  // One of six differs: a third of the resamples do not have it. t(0.975; 5) = 2.570582.
  const auto six = *mean_interval(std::vector<double>{0, 0, 0, 0, 0, 6}, 0.95, 1, "");
  CHECK(six.low == Approx(1.0 - 2.570582));
  CHECK(six.high == Approx(1.0 + 2.570582));
  // Three of five reach the same line: resamples of these alone have almost no spread.
  const auto line =
      *mean_interval(std::vector<double>{3.12, 4.00007, 2.93, 4.0006, 4.0003}, 0.95, 1, "");
  CHECK(line.low > 0.0);
  CHECK(line.high < 8.0);
  // Ten values with a spread have their own interval, longer towards the long tail.
  const std::vector<double> skewed{1.0, 1.1, 1.2, 1.3, 1.5, 1.7, 2.0, 2.5, 3.5, 6.0};
  const double mean = *statistic_of(Statistic::mean, skewed);
  const auto ten = *mean_interval(skewed, 0.95, 1, "");
  CHECK(ten.high - mean > 1.5 * (mean - ten.low));
}

TEST_CASE("Bootstrap intervals are the same for the same stream, and others for another") {
  const std::vector<double> values = michelson();
  const auto of = [&](std::uint64_t seed, const char* path) {
    return *bootstrap_interval(Statistic::median, values, 0.95, seed, path);
  };
  CHECK(of(1, "a") == of(1, "a"));
  const auto mean = [&](std::uint64_t seed, const char* path) {
    return *bootstrap_interval(Statistic::mean, values, 0.95, seed, path);
  };
  CHECK_FALSE(mean(1, "a") == mean(2, "a"));
  CHECK_FALSE(mean(1, "a") == mean(1, "b"));
}

TEST_CASE("Values that are all equal have an interval of no width") {
  const std::vector<double> values(20, 0.1);
  const auto interval = *mean_interval(values, 0.95, 1, "");
  CHECK(interval.low == Approx(0.1));
  CHECK(interval.low == interval.high);
}

TEST_CASE("Outliers are beyond Tukey's fences") {
  // Quartiles 2 and 4 of 1..5: the fences are 3 below and above them.
  const auto fences = tukey_fences(*summary(std::vector<double>{1, 2, 3, 4, 5}));
  CHECK(fences == Interval{-1.0, 7.0});
  const std::vector<double> sorted{-3, 1, 2, 3, 4, 5, 7, 8};
  CHECK(whiskers(sorted, fences) == Interval{1.0, 7.0});
}

TEST_CASE("Cells relative to each other: ratio and difference") {
  const std::vector<Pair> pairs{{2.0, 4.0}, {4.0, 8.0}};
  CHECK(*relation_of(Relation::ratio, Statistic::mean, pairs) == Approx(0.5));
  CHECK(*relation_of(Relation::difference, Statistic::mean, pairs) == Approx(-3.0));
  CHECK_FALSE(relation_of(Relation::ratio, Statistic::mean, std::vector<Pair>{}));
  CHECK_FALSE(relation_of(Relation::ratio, Statistic::mean, std::vector<Pair>{{0.0, 0.0}}));
}

TEST_CASE("There is no ratio to 0, and no interval with such an end") {
  const std::vector<Pair> to_zero{{3.0, 0.0}, {4.0, 0.0}, {-2.0, 0.0}};
  CHECK_FALSE(relation_of(Relation::ratio, Statistic::mean, to_zero));
  CHECK(*relation_of(Relation::difference, Statistic::mean, to_zero) == Approx(5.0 / 3.0));
  CHECK_FALSE(paired_interval(Relation::ratio, Statistic::mean, to_zero, 0.95, 1, "zero"));
  // 36 of 100 resamples, (19/20)^20, lack the only value other than 0.
  std::vector<Pair> rarely(20, {1.0, 0.0});
  rarely[7].reference = 1.0;
  CHECK(relation_of(Relation::ratio, Statistic::rate, rarely) == 20.0);
  CHECK_FALSE(paired_interval(Relation::ratio, Statistic::rate, rarely, 0.95, 1, "rarely"));
  CHECK(paired_interval(Relation::difference, Statistic::rate, rarely, 0.95, 1, "rarely"));
  // With half of the values there is an interval.
  for (std::size_t i = 0; i < 10; ++i) rarely[i].reference = 1.0;
  const auto interval =
      paired_interval(Relation::ratio, Statistic::rate, rarely, 0.95, 1, "rarely");
  REQUIRE(interval);
  CHECK(interval->low > 1.0);
  CHECK(interval->high < 10.0);
}

TEST_CASE("The difference of two rates has Newcombe's interval") {
  // Newcombe (1998), table II: 56 of 70 and 48 of 80, and 10 of 10 and 0 of 10.
  const auto some = *interval_of_rates(Relation::difference, {56, 70}, {48, 80}, 0.95);
  CHECK(some.low == Approx(0.0524).margin(5e-5));
  CHECK(some.high == Approx(0.3339).margin(5e-5));
  const auto all = *interval_of_rates(Relation::difference, {10, 10}, {0, 10}, 0.95);
  CHECK(all.low == Approx(0.6075).margin(5e-5));
  CHECK(all.high == Approx(1.0));
  // Even if every run succeeded, there is uncertainty.
  const auto same = *interval_of_rates(Relation::difference, {20, 20}, {20, 20}, 0.95);
  CHECK(same.low == Approx(-0.161).margin(5e-4));
  CHECK(same.high == Approx(0.161).margin(5e-4));
}

TEST_CASE("The ratio of two rates has an interval that holds it about as often as it says") {
  // If every run succeeded in both, the ratio is that of Wilson's ends.
  const auto same = *interval_of_rates(Relation::ratio, {20, 20}, {20, 20}, 0.95);
  const auto wilson = wilson_interval(20, 20, 0.95);
  CHECK(same.low == Approx(wilson.low));
  CHECK(same.high == Approx(1.0 / wilson.low).epsilon(0.01));
  CHECK(interval_of_rates(Relation::ratio, {0, 20}, {10, 20}, 0.95)->low == 0.0);
  CHECK_FALSE(interval_of_rates(Relation::ratio, {20, 20}, {0, 20}, 0.95));
  int hits = 0;
  constexpr int kExperiments = 2000;
  for (int i = 0; i < kExperiments; ++i) {
    elsie::Random random(static_cast<std::uint64_t>(i), "rates");
    Frequency cell{0, 20}, reference{0, 20};
    for (int run = 0; run < 20; ++run) {
      cell.hits += random.uniform() < 0.9 ? 1 : 0;
      reference.hits += random.uniform() < 0.6 ? 1 : 0;
    }
    const auto interval = interval_of_rates(Relation::ratio, cell, reference, 0.95);
    REQUIRE(interval);
    hits += interval->low <= 1.5 && 1.5 <= interval->high ? 1 : 0;
  }
  CHECK(hits > 0.92 * kExperiments);
  CHECK(hits < 0.985 * kExperiments);
}

TEST_CASE("What both cells share by seed does not widen their interval") {
  // Each cell varies between seeds far more than the cells differ.
  std::vector<Pair> pairs;
  std::vector<Pair> unpaired;
  elsie::Random random(5, "pairs");
  for (int i = 0; i < 20; ++i) {
    const double seed = random.normal(100.0, 20.0);
    pairs.push_back({seed + 1.0 + random.normal(0.0, 0.1), seed});
  }
  for (std::size_t i = 0; i < 20; ++i) {
    unpaired.push_back({pairs[i].cell, pairs[(i + 7) % 20].reference});
  }
  const auto tight =
      *paired_interval(Relation::difference, Statistic::mean, pairs, 0.95, 1, "pairs");
  CHECK(tight.low == Approx(1.0).margin(0.1));
  CHECK(tight.high == Approx(1.0).margin(0.1));
  const auto wide =
      *paired_interval(Relation::difference, Statistic::mean, unpaired, 0.95, 1, "pairs");
  CHECK(wide.high - wide.low > 50.0 * (tight.high - tight.low));
}
