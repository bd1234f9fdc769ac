#include "elsie/report/comparisons.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "distributions.h"

namespace elsie::report {

namespace {

constexpr double kTied = 1e-9;

// A group, sorted: how many of it are surely above or below a value.
class Sorted {
 public:
  explicit Sorted(std::span<const Observed> group) {
    for (const Observed& one : group) {
      (one.bound ? bounds_ : known_).push_back(one.value);
    }
    std::sort(known_.begin(), known_.end());
    std::sort(bounds_.begin(), bounds_.end());
  }

  // How many of the group are below the value, less how many are above.
  long dominance(const Observed& of) const {
    const long upto = std::upper_bound(known_.begin(), known_.end(), of.value) - known_.begin();
    if (of.bound) {
      return upto;
    }
    const long below = std::lower_bound(known_.begin(), known_.end(), of.value) - known_.begin();
    const long bounds = bounds_.end() - std::lower_bound(bounds_.begin(), bounds_.end(), of.value);
    return below - (std::ssize(known_) - upto) - bounds;
  }

  // How many of the group are surely above or below the value.
  long decided(const Observed& of) const {
    const long upto = std::upper_bound(known_.begin(), known_.end(), of.value) - known_.begin();
    if (of.bound) {
      return upto;
    }
    const long below = std::lower_bound(known_.begin(), known_.end(), of.value) - known_.begin();
    const long bounds = bounds_.end() - std::lower_bound(bounds_.begin(), bounds_.end(), of.value);
    return below + (std::ssize(known_) - upto) + bounds;
  }

 private:
  std::vector<double> known_, bounds_;
};

// The probability that the sum of `drawn` of the scores, whose sum is 0, is as far from 0.
double exact_p(const std::vector<long>& scores, std::size_t drawn, long sum) {
  const long reach = std::accumulate(scores.begin(), scores.end(), 0L,
                                     [](long all, long score) { return all + std::abs(score); });
  const auto width = static_cast<std::size_t>(2 * reach + 1);
  // ways[k][s]: the number of ways to draw k scores with the sum s - reach.
  std::vector<std::vector<double>> ways(drawn + 1, std::vector<double>(width, 0.0));
  ways[0][static_cast<std::size_t>(reach)] = 1.0;
  std::size_t done = 0;
  for (const long score : scores) {
    for (std::size_t k = std::min(drawn, ++done); k > 0; --k) {
      for (std::size_t s = 0; s < width; ++s) {
        if (ways[k - 1][s] > 0.0) {
          ways[k][static_cast<std::size_t>(static_cast<long>(s) + score)] += ways[k - 1][s];
        }
      }
    }
  }
  double all = 0.0, far = 0.0;
  for (std::size_t s = 0; s < width; ++s) {
    all += ways[drawn][s];
    far += std::abs(static_cast<long>(s) - reach) >= std::abs(sum) ? ways[drawn][s] : 0.0;
  }
  return std::min(1.0, far / all);
}

double square(double value) { return value * value; }

// Cliff (1996): the variance of delta, and its interval, which stays within -1 and 1.
std::optional<Interval> delta_interval(double delta, std::span<const Observed> first,
                                       std::span<const Observed> second, double confidence) {
  if (first.size() < 2 || second.size() < 2) {
    return std::nullopt;
  }
  const auto m = static_cast<double>(first.size()), n = static_cast<double>(second.size());
  const Sorted of_first(first), of_second(second);
  double rows = 0.0, columns = 0.0, decided = 0.0;
  for (const Observed& one : first) {
    rows += square(static_cast<double>(of_second.dominance(one)) / n - delta);
    decided += static_cast<double>(of_second.decided(one));
  }
  for (const Observed& one : second) {
    columns += square(-static_cast<double>(of_first.dominance(one)) / m - delta);
  }
  const double all = decided - m * n * delta * delta;  // sum of squares of single comparisons
  const double least = (1.0 - delta * delta) / (m * n - 1.0);
  const double variance =
      std::max(least, (n * n * rows + m * m * columns - all) / (m * n * (m - 1.0) * (n - 1.0)));
  const double z = normal_reach(confidence);
  if (std::abs(delta) >= 1.0 - kTied) {
    const double fewer = std::min(m, n);
    const double near = (fewer - z * z) / (fewer + z * z);
    return delta > 0.0 ? Interval{near, 1.0} : Interval{-1.0, -near};
  }
  const double below = 1.0 - delta * delta + z * z * variance;
  const double reach =
      z * std::sqrt(variance) * std::sqrt(square(1.0 - delta * delta) + z * z * variance);
  return Interval{std::max(-1.0, (delta - delta * delta * delta - reach) / below),
                  std::min(1.0, (delta - delta * delta * delta + reach) / below)};
}

// Twice the ranks of the sizes, with mean ranks for equal ones: whole numbers.
std::vector<long> double_ranks(const std::vector<double>& sizes) {
  std::vector<double> sorted = sizes;
  std::sort(sorted.begin(), sorted.end());
  std::vector<long> ranks;
  for (const double size : sizes) {
    const double slack = kTied * size;  // differences that differ by rounding are equal
    const auto from = std::lower_bound(sorted.begin(), sorted.end(), size - slack);
    const auto to = std::upper_bound(sorted.begin(), sorted.end(), size + slack);
    ranks.push_back((from - sorted.begin()) + (to - sorted.begin()) + 1);
  }
  return ranks;
}

}  // namespace

RankTest rank_test(std::span<const Observed> first, std::span<const Observed> second,
                   double confidence) {
  std::vector<Observed> all(first.begin(), first.end());
  all.insert(all.end(), second.begin(), second.end());
  const Sorted pooled(all);
  std::vector<long> scores;
  for (const Observed& one : all) {
    scores.push_back(pooled.dominance(one));
  }
  const long sum = std::accumulate(scores.begin(), scores.begin() + std::ssize(first), 0L);
  const auto m = static_cast<double>(first.size()), n = static_cast<double>(second.size());
  RankTest test;
  test.delta.value = static_cast<double>(sum) / (m * n);
  test.delta.interval = delta_interval(test.delta.value, first, second, confidence);
  double squares = 0.0;
  for (const long score : scores) {
    squares += square(static_cast<double>(score));
  }
  test.exact = all.size() <= kMostForExactRanks;
  if (squares == 0.0) {
    test.p = 1.0;
  } else if (test.exact) {
    test.p = exact_p(scores, first.size(), sum);
  } else {
    const double variance = m * n / ((m + n) * (m + n - 1.0)) * squares;
    test.p = normal_two_sided(std::max(0.0, std::abs(static_cast<double>(sum)) - 1.0) /
                              std::sqrt(variance));
  }
  return test;
}

std::optional<Effect> hedges_g(std::span<const double> first, std::span<const double> second,
                               double confidence) {
  const auto a = summary(first), b = summary(second);
  if (!a || !b || !a->standard_deviation || !b->standard_deviation) {
    return std::nullopt;
  }
  const auto m = static_cast<double>(a->count), n = static_cast<double>(b->count);
  const double freedom = m + n - 2.0;
  const double pooled = std::sqrt(
      ((m - 1.0) * square(*a->standard_deviation) + (n - 1.0) * square(*b->standard_deviation)) /
      freedom);
  const double size = std::max(
      {std::abs(a->largest), std::abs(a->least), std::abs(b->largest), std::abs(b->least)});
  if (pooled <= kRoundingOfRuns * size) {
    return std::nullopt;
  }
  const double g = (1.0 - 3.0 / (4.0 * freedom - 1.0)) * (a->mean - b->mean) / pooled;
  const double reach =
      normal_reach(confidence) * std::sqrt((m + n) / (m * n) + g * g / (2.0 * (m + n)));
  return Effect{g, Interval{g - reach, g + reach}};
}

Effect odds_ratio(const Frequency& first, const Frequency& second, double confidence) {
  double a = static_cast<double>(first.hits), b = static_cast<double>(first.trials) - a;
  double c = static_cast<double>(second.hits), d = static_cast<double>(second.trials) - c;
  if (a * b * c * d == 0.0) {
    for (double* const number : {&a, &b, &c, &d}) {
      *number += 0.5;
    }
  }
  const double ratio = a * d / (b * c);
  const double reach =
      std::exp(normal_reach(confidence) * std::sqrt(1.0 / a + 1.0 / b + 1.0 / c + 1.0 / d));
  return {ratio, Interval{ratio / reach, ratio * reach}};
}

double fisher_test(const Frequency& first, const Frequency& second) {
  const auto m = static_cast<double>(first.trials), n = static_cast<double>(second.trials);
  const auto hits = static_cast<double>(first.hits + second.hits);
  const auto log_choose = [](double of, double chosen) {
    return std::lgamma(of + 1.0) - std::lgamma(chosen + 1.0) - std::lgamma(of - chosen + 1.0);
  };
  const auto log_p = [&](double a) {
    return log_choose(m, a) + log_choose(n, hits - a) - log_choose(m + n, hits);
  };
  const double observed = log_p(static_cast<double>(first.hits));
  double sum = 0.0;
  for (double a = std::max(0.0, hits - n); a <= std::min(m, hits); a += 1.0) {
    // Tables that are as probable differ by rounding.
    if (log_p(a) <= observed + 1e-7) {
      sum += std::exp(log_p(a));
    }
  }
  return std::min(1.0, sum);
}

PairTest signed_rank_test(std::span<const double> differences) {
  PairTest test;
  std::vector<double> sizes;
  std::vector<int> signs;
  for (const double one : differences) {
    if (one != 0.0) {
      sizes.push_back(std::abs(one));
      signs.push_back(one > 0.0 ? 1 : -1);
      ++(one > 0.0 ? test.above : test.below);
    }
  }
  if (sizes.empty()) {
    return test;
  }
  const auto [least, largest] = std::minmax_element(sizes.begin(), sizes.end());
  if (*largest - *least <= kTied * *largest) {  // only the signs differ
    test.p = std::min(1.0, 2.0 * fair_at_most(std::min(test.above, test.below), sizes.size()));
    return test;
  }
  test.exact = sizes.size() <= kMostForExactSigns;
  const std::vector<long> ranks = double_ranks(sizes);
  long sum = 0, reach = 0;
  double squares = 0.0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    sum += signs[i] * ranks[i];
    reach += ranks[i];
    squares += square(static_cast<double>(ranks[i]));
  }
  if (!test.exact) {
    // A change of one sign changes the sum of double ranks by at least 4 for whole ranks.
    test.p = normal_two_sided(std::max(0.0, std::abs(static_cast<double>(sum)) - 2.0) /
                              std::sqrt(squares));
    return test;
  }
  // ways[s]: the part of all signs whose sum is s - reach.
  std::vector<double> ways(static_cast<std::size_t>(2 * reach + 1), 0.0);
  ways[static_cast<std::size_t>(reach)] = 1.0;
  for (const long rank : ranks) {
    std::vector<double> next(ways.size(), 0.0);
    for (std::size_t s = 0; s < ways.size(); ++s) {
      if (ways[s] > 0.0) {
        next[s + static_cast<std::size_t>(rank)] += 0.5 * ways[s];
        next[s - static_cast<std::size_t>(rank)] += 0.5 * ways[s];
      }
    }
    ways = std::move(next);
  }
  double far = 0.0;
  for (std::size_t s = 0; s < ways.size(); ++s) {
    far += std::abs(static_cast<long>(s) - reach) >= std::abs(sum) ? ways[s] : 0.0;
  }
  test.p = std::min(1.0, far);
  return test;
}

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, static_cast<double>(p.size() - i) * p[order[i]]);
    adjusted[order[i]] = std::min(1.0, largest);
  }
  return adjusted;
}

}  // namespace elsie::report
