#include "elsie/report/statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "distributions.h"
#include "samples.h"

namespace elsie::report {

namespace {

double mean_of(std::span<const double> values) {
  const auto count = static_cast<double>(values.size());
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  const double first = sum / count;
  double rest = 0.0;  // accumulated rounding error
  for (const double value : values) {
    rest += value - first;
  }
  return first + rest / count;
}

double deviation_of(std::span<const double> values, double mean) {
  double squares = 0.0, rest = 0.0;
  for (const double value : values) {
    squares += (value - mean) * (value - mean);
    rest += value - mean;
  }
  const auto count = static_cast<double>(values.size());
  return std::sqrt(std::max(0.0, squares - rest * rest / count) / (count - 1.0));
}

}  // namespace

std::vector<double> ascending(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

double quantile(std::span<const double> ascending, double part) {
  const double at = part * static_cast<double>(ascending.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), ascending.size() - 1);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  const double rest = at - static_cast<double>(below);
  // Equal neighbours give exactly their value, even infinite ones.
  if (rest == 0.0 || ascending[below] == ascending[above]) {
    return ascending[below];
  }
  return ascending[below] + rest * (ascending[above] - ascending[below]);
}

bool is_usable(double value) { return std::abs(value) <= 1e150; }

std::optional<Summary> summary(std::span<const double> values) {
  if (values.empty()) {
    return std::nullopt;
  }
  const std::vector<double> sorted = ascending(values);
  Summary result;
  result.count = sorted.size();
  // Sorted, so that the result does not depend on the order of the values.
  result.mean = std::clamp(mean_of(sorted), sorted.front(), sorted.back());
  if (sorted.size() > 1) {
    result.standard_deviation = deviation_of(sorted, result.mean);
  }
  result.least = sorted.front();
  result.lower_quartile = quantile(sorted, 0.25);
  result.median = quantile(sorted, 0.5);
  result.upper_quartile = quantile(sorted, 0.75);
  result.largest = sorted.back();
  return result;
}

std::optional<double> statistic_of(Statistic statistic, std::span<const double> values) {
  switch (statistic) {
    case Statistic::mean:
      return mean_of(values);
    case Statistic::median:
      return quantile(ascending(values), 0.5);
    case Statistic::standard_deviation:
      if (values.size() < 2) {
        return std::nullopt;
      }
      return deviation_of(values, mean_of(values));
    case Statistic::minimum:
      return *std::min_element(values.begin(), values.end());
    case Statistic::maximum:
      return *std::max_element(values.begin(), values.end());
    case Statistic::rate:
      return static_cast<double>(
                 std::count_if(values.begin(), values.end(), [](double v) { return v != 0.0; })) /
             static_cast<double>(values.size());
  }
  return std::nullopt;
}

Interval wilson_interval(std::size_t successes, std::size_t trials, double confidence) {
  if (trials == 0) {
    return {0.0, 1.0};
  }
  const auto n = static_cast<double>(trials);
  return wilson_interval_of_rate(static_cast<double>(successes) / n, n, confidence);
}

Interval wilson_interval_of_rate(double p, double n, double confidence) {
  const double z = normal_reach(confidence);
  const double shrink = 1.0 + z * z / n;
  const double middle = (p + z * z / (2.0 * n)) / shrink;
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n)) / shrink;
  // At the ends, the formula gives 0 and 1 up to rounding.
  return {p <= 0.0 ? 0.0 : std::max(0.0, middle - half),
          p >= 1.0 ? 1.0 : std::min(1.0, middle + half)};
}

std::optional<double> boundless_relation(Relation relation, Statistic statistic,
                                         std::span<const Pair> pairs) {
  if (pairs.empty()) {
    return std::nullopt;
  }
  std::vector<double> cell, reference;
  for (const Pair& pair : pairs) {
    cell.push_back(pair.cell);
    reference.push_back(pair.reference);
  }
  const auto above = statistic_of(statistic, cell), below = statistic_of(statistic, reference);
  if (!above || !below) {
    return std::nullopt;
  }
  if (relation == Relation::difference) {
    return *above - *below;
  }
  const double ratio = *above / *below;
  return std::isnan(ratio) ? std::nullopt : std::optional(ratio);
}

std::optional<double> relation_of(Relation relation, Statistic statistic,
                                  std::span<const Pair> pairs) {
  const auto value = boundless_relation(relation, statistic, pairs);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<Interval> interval_of_rates(Relation relation, const Frequency& cell,
                                          const Frequency& reference, double confidence) {
  const Interval own = wilson_interval(cell.hits, cell.trials, confidence);
  const Interval other = wilson_interval(reference.hits, reference.trials, confidence);
  const double p = cell.rate(), q = reference.rate();
  if (relation == Relation::difference) {
    return Interval{p - q - std::hypot(p - own.low, other.high - q),
                    p - q + std::hypot(own.high - p, q - other.low)};
  }
  // The ends r of the ratio are where p - r q is as far from 0 as both intervals together allow.
  const double above_low = own.low * (2.0 * p - own.low);
  const double above_high = own.high * (2.0 * p - own.high);
  const double below_high = other.high * (2.0 * q - other.high);
  const double below_low = other.low * (2.0 * q - other.low);
  if (below_low <= 0.0) {
    return std::nullopt;
  }
  const double root_low = std::sqrt(std::max(0.0, p * p * q * q - above_low * below_high));
  const double root_high = std::sqrt(std::max(0.0, p * p * q * q - above_high * below_low));
  const double low = p == 0.0 ? 0.0 : above_low / (p * q + root_low);
  return Interval{std::max(0.0, low), (p * q + root_high) / below_low};
}

bool are_equal(double least, double largest) {
  const double larger = std::max(std::abs(least), std::abs(largest));
  return least == largest || (std::isfinite(larger) && largest - least <= kRoundingOfRuns * larger);
}

Interval tukey_fences(const Summary& summary) {
  const double reach = 1.5 * summary.quartile_range();
  return {summary.lower_quartile - reach, summary.upper_quartile + reach};
}

Interval whiskers(std::span<const double> ascending, const Interval& fences) {
  const auto low = std::lower_bound(ascending.begin(), ascending.end(), fences.low);
  const auto high = std::upper_bound(ascending.begin(), ascending.end(), fences.high);
  if (low >= high) {
    return {ascending.front(), ascending.back()};
  }
  return {*low, *std::prev(high)};
}

}  // namespace elsie::report
