// Two groups compared.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/report/comparisons.h"

using namespace elsie::report;
using elsie::Random;

namespace {

std::vector<Observed> known(std::initializer_list<double> values) {
  std::vector<Observed> all;
  for (const double value : values) all.push_back({value, false});
  return all;
}

// 1, 0 or -1, by the definition.
int order(const Observed& a, const Observed& b) {
  if (a.bound && b.bound) return 0;
  if (a.bound) return a.value >= b.value ? 1 : 0;
  if (b.bound) return b.value >= a.value ? -1 : 0;
  return a.value > b.value ? 1 : a.value < b.value ? -1 : 0;
}

// The permutation test by drawing every group.
double by_all_groups(const std::vector<Observed>& all, std::size_t size) {
  const auto sum = [&](const std::vector<bool>& first) {
    int total = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < all.size(); ++j) {
        total += first[i] && !first[j] ? order(all[i], all[j]) : 0;
      }
    }
    return total;
  };
  std::vector<bool> group(all.size(), false);
  std::fill_n(group.begin(), size, true);
  const int observed = std::abs(sum(group));
  std::sort(group.begin(), group.end());
  int far = 0, count = 0;
  do {
    far += std::abs(sum(group)) >= observed ? 1 : 0;
    ++count;
  } while (std::next_permutation(group.begin(), group.end()));
  return double(far) / count;
}

}  // namespace

TEST_CASE("Fisher's exact test gives the published probabilities") {
  CHECK(fisher_test({3, 4}, {1, 4}) == Approx(0.4857).margin(5e-5));  // the lady, Fisher (1935)
  // SciPy 1.10, fisher_exact.
  CHECK(fisher_test({19, 20}, {12, 20}) == Approx(0.019656019656).epsilon(1e-9));
  CHECK(fisher_test({1, 10}, {11, 14}) == Approx(0.00275945618522).epsilon(1e-9));
  CHECK(fisher_test({0, 5}, {5, 5}) == Approx(2.0 / 252.0));  // by hand: 2 of 10 over 5
  CHECK(fisher_test({5, 5}, {5, 5}) == 1.0);
  CHECK(fisher_test({0, 3}, {0, 9}) == 1.0);
  CHECK(fisher_test({2000, 4000}, {2000, 4000}) == Approx(1.0));
}

TEST_CASE(
    "The odds ratio has the interval of Woolf, and is finite where one of four numbers is 0") {
  const Effect odds = odds_ratio({19, 20}, {12, 20}, 0.95);
  CHECK(odds.value == Approx(19.0 * 8.0 / 12.0));
  // By hand: the error of the logarithm is sqrt(1/19 + 1 + 1/12 + 1/8).
  CHECK(odds.interval->low == Approx(odds.value / std::exp(1.959964 * 1.122927)).epsilon(1e-5));
  CHECK(odds.interval->high == Approx(odds.value * std::exp(1.959964 * 1.122927)).epsilon(1e-5));
  CHECK(odds_ratio({5, 5}, {0, 5}, 0.95).value == Approx(121.0));  // 5.5 * 5.5 / (0.5 * 0.5)
  CHECK(odds_ratio({5, 5}, {5, 5}, 0.95).value == Approx(1.0));
}

TEST_CASE("The test of Mann and Whitney gives the published probability") {
  // Hollander and Wolfe (1973), page 69: permeability of a membrane. R: W = 35, p = 0.2544.
  const RankTest test =
      rank_test(known({0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46}),
                known({1.15, 0.88, 0.90, 0.74, 1.21}), 0.95);
  CHECK(test.exact);
  CHECK(test.p == Approx(0.2544122544).epsilon(1e-9));
  CHECK(test.delta.value == Approx(0.4));  // 35 of 50 above, 15 below
  CHECK(rank_test(known({4, 5, 6}), known({1, 2, 3}), 0.95).p == Approx(0.1));  // 2 of 20
  CHECK(rank_test(known({4, 5, 6}), known({1, 2, 3}), 0.95).delta.value == 1.0);
}

TEST_CASE("The rank test is the permutation test, with ties and with bounds") {
  const std::vector<std::vector<Observed>> samples = {
      known({1, 1, 2, 2, 3, 4, 4, 4, 5, 6}),
      {{3, false}, {5, true}, {2, false}, {5, true}, {4, false}, {1, false}, {5, true}, {3, false}},
      {{3, true},
       {5, false},
       {2, true},
       {9, true},
       {4, false},
       {1, false},
       {3, false},
       {3, false}}};
  for (const auto& all : samples) {
    const std::size_t size = all.size() / 2 - 1;
    const std::span<const Observed> whole(all);
    const RankTest test = rank_test(whole.first(size), whole.subspan(size), 0.95);
    CHECK(test.p == Approx(by_all_groups(all, size)).epsilon(1e-9));
    int above = 0;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = size; j < all.size(); ++j) above += order(all[i], all[j]);
    }
    CHECK(test.delta.value == Approx(double(above) / double(size * (all.size() - size))));
  }
}

TEST_CASE("With many values the approximation is close to the exact test") {
  Random random(3, "ranks");
  std::vector<Observed> first, second;
  for (int i = 0; i < 30; ++i) {
    first.push_back({random.normal(0.6, 1.0), false});
    second.push_back({random.normal(0.0, 1.0), false});
  }
  const RankTest exact = rank_test(first, second, 0.95);
  REQUIRE(exact.exact);
  second.push_back({0.1, false});
  const RankTest near = rank_test(first, second, 0.95);
  REQUIRE_FALSE(near.exact);
  CHECK(near.p == Approx(exact.p).epsilon(0.35));
}

TEST_CASE("The interval of Cliff's delta is that of its definition") {
  const auto first = known({1, 4, 4, 7, 9}), second = known({2, 3, 4, 5});
  const RankTest test = rank_test(first, second, 0.95);
  const double m = 5, n = 4, d = test.delta.value;
  double rows = 0, columns = 0, cells = 0;
  for (const Observed& a : first) {
    double mean = 0;
    for (const Observed& b : second) mean += order(a, b) / n;
    rows += (mean - d) * (mean - d);
  }
  for (const Observed& b : second) {
    double mean = 0;
    for (const Observed& a : first) {
      mean += order(a, b) / m;
      cells += (order(a, b) - d) * (order(a, b) - d);
    }
    columns += (mean - d) * (mean - d);
  }
  const double variance = (n * n * rows + m * m * columns - cells) / (m * n * (m - 1) * (n - 1));
  const double z = 1.959963985;
  const double below = 1 - d * d + z * z * variance;
  const double reach =
      z * std::sqrt(variance) * std::sqrt((1 - d * d) * (1 - d * d) + z * z * variance);
  CHECK(test.delta.interval->low == Approx((d - d * d * d - reach) / below));
  CHECK(test.delta.interval->high == Approx((d - d * d * d + reach) / below));
}

TEST_CASE("Groups without overlap still have an interval: three values prove little") {
  const RankTest test = rank_test(known({4, 5, 6}), known({1, 2, 3}), 0.95);
  // Feng and Cliff (2004): (n - z^2) / (n + z^2) for the smaller group.
  CHECK(test.delta.interval->low == Approx((3 - 3.841459) / (3 + 3.841459)).epsilon(1e-6));
  CHECK(test.delta.interval->high == 1.0);
  CHECK(rank_test(known({1, 2, 3}), known({4, 5, 6}), 0.95).delta.interval->low == -1.0);
}

TEST_CASE("Hedges' g is the difference in pooled deviations, less for few values") {
  const std::vector<double> a{1, 2, 3}, b{3, 4, 5};
  const auto g = hedges_g(a, b, 0.95);
  REQUIRE(g);
  CHECK(g->value == Approx(-1.6));  // by hand: -2 deviations of 1, times 1 - 3/15
  const double error = std::sqrt(6.0 / 9.0 + 1.6 * 1.6 / 12.0);
  CHECK(g->interval->low == Approx(-1.6 - 1.959964 * error));
  const std::vector<double> equal{2, 2, 2}, one{2};
  CHECK_FALSE(hedges_g(equal, equal, 0.95));
  CHECK_FALSE(hedges_g(a, one, 0.95));
  const std::vector<double> near{1.0, 1.0 + 1e-7, 1.0}, far{2.0, 2.0 - 1e-7, 2.0};
  CHECK_FALSE(hedges_g(near, far, 0.95));  // their spread is rounding
}

TEST_CASE("Wilcoxon's test gives the published probability for Darwin's plants") {
  // Fisher (1935), chapter 3: heights of crossed less self-fertilised plants, in eighths of an
  // inch.
  const std::vector<double> darwin{49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};
  const PairTest test = signed_rank_test(darwin);
  CHECK(test.exact);
  CHECK(test.above == 13);
  CHECK(test.p == Approx(0.041259765625).epsilon(1e-12));  // SciPy 1.10; W = 24
}

TEST_CASE("Differences of one size have the exact probability of their signs, however many") {
  std::vector<double> differences(13, 0.25);
  differences.insert(differences.end(), 2, -0.25);
  CHECK(signed_rank_test(differences).p == Approx(0.00738525390625));  // 2 (1 + 15 + 105) / 2^15
  differences.assign(kMostForExactSigns, 1.0);
  differences.insert(differences.end(), kMostForExactSigns, -1.0);
  CHECK(signed_rank_test(differences).exact);
  CHECK(signed_rank_test(differences).p == 1.0);
}

TEST_CASE("Differences of 0 are left out, and equal ones share their rank") {
  const std::vector<double> differences{0, 1, 1, -1, 2, 0};
  // Ranks 2, 2, 2, 4 of four differences: the sum is 6 of 10 or more in 8 of 16 signs.
  CHECK(signed_rank_test(differences).p == Approx(8.0 / 16.0));
  const std::vector<double> zeros{0, 0};
  CHECK(signed_rank_test(zeros).p == 1.0);
  CHECK(signed_rank_test({}).p == 1.0);
}

TEST_CASE("With many differences the approximation is close to the exact test") {
  Random random(4, "signs");
  std::vector<double> differences;
  for (std::size_t i = 0; i < kMostForExactSigns; ++i) differences.push_back(random.normal(0.3, 1));
  const double exact = signed_rank_test(differences).p;
  differences.push_back(0.01);
  CHECK_FALSE(signed_rank_test(differences).exact);
  CHECK(signed_rank_test(differences).p == Approx(exact).epsilon(0.1));
}

TEST_CASE("Holm's correction is the worked example, and never falls") {
  // By hand: 4 * 0.005, 3 * 0.01, 2 * 0.03, and no less for 0.04.
  const std::vector<double> p{0.01, 0.04, 0.03, 0.005};
  const std::vector<double> adjusted = holm(p);
  CHECK(adjusted[0] == Approx(0.03));
  CHECK(adjusted[1] == Approx(0.06));
  CHECK(adjusted[2] == Approx(0.06));
  CHECK(adjusted[3] == Approx(0.02));
  CHECK(holm(std::vector<double>{0.7, 0.9}) == std::vector<double>{1.0, 1.0});
  CHECK(holm({}).empty());
}
