// Intervals by resampling: how far a statistic of a small sample may be from its true value.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "elsie/base/random.h"

#include "distributions.h"
#include "samples.h"

namespace elsie::report {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-12;  // relative; a smaller spread is rounding

struct Estimate {
  double value = 0.0;
  double error = 0.0;  // standard error; 0: no spread
};

// The standard error of a mean whose values deviate from it by `deviation(i)`.
template <class Deviation>
double error_of_mean(std::size_t count, Deviation deviation) {
  double squares = 0.0, rest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double d = deviation(i);
    squares += d * d;
    rest += d;
  }
  const auto n = static_cast<double>(count);
  return std::sqrt(std::max(0.0, squares - rest * rest / n) / (n - 1.0) / n);
}

Estimate estimate(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  const double mean = *statistic_of(Statistic::mean, values);
  const double error =
      error_of_mean(values.size(), [&](std::size_t i) { return values[i] - mean; });
  return {mean, error > kRounding * largest ? error : 0.0};
}

// A difference of means, or a ratio of means with its error by the delta method.
std::optional<Estimate> estimate(Relation relation, std::span<const Pair> pairs) {
  const auto value = boundless_relation(relation, Statistic::mean, pairs);
  if (!value || !std::isfinite(*value)) {
    return std::nullopt;
  }
  const bool ratio = relation == Relation::ratio;
  const double factor = ratio ? *value : 1.0;
  double largest = 0.0, below = 0.0;
  for (const Pair& pair : pairs) {
    largest = std::max({largest, std::abs(pair.cell), std::abs(factor * pair.reference)});
    below += pair.reference / static_cast<double>(pairs.size());
  }
  const double error = error_of_mean(
      pairs.size(), [&](std::size_t i) { return pairs[i].cell - factor * pairs[i].reference; });
  return Estimate{*value,
                  error > kRounding * largest ? error / (ratio ? std::abs(below) : 1.0) : 0.0};
}

// Draws samples of the same size with replacement, and passes each to the visitor.
template <class Value, class Visitor>
void resample(std::span<const Value> values, std::uint64_t seed, std::string_view path,
              Visitor visit) {
  Random random(seed, path);
  std::vector<Value> sample(values.size());
  for (int i = 0; i < kResamples; ++i) {
    for (Value& value : sample) {
      value =
          values[static_cast<std::size_t>(random.uniform() * static_cast<double>(values.size()))];
    }
    visit(std::span<const Value>(sample));
  }
}

Interval student_interval(const Estimate& whole, std::size_t count, double tail) {
  const double reach = student_quantile(1.0 - tail, static_cast<double>(count - 1)) * whole.error;
  return {whole.value - reach, whole.value + reach};
}

// The bootstrap-t interval of an estimate. `unsure`: resamples may have no estimate; if too many
// resamples have none, there is no interval.
template <class Value, class Estimator>
std::optional<Interval> studentized(std::span<const Value> values, Estimator estimate, bool unsure,
                                    double confidence, std::uint64_t seed, std::string_view path) {
  if (values.size() < 2) {
    return std::nullopt;
  }
  const std::optional<Estimate> whole = estimate(values);
  if (!whole) {
    return std::nullopt;
  }
  const double tail = 0.5 * (1.0 - confidence);
  const bool few = values.size() < kFewestForBootstrap;
  if (!unsure && whole->error == 0.0) {
    return Interval{whole->value, whole->value};
  }
  if (!unsure && few) {
    return student_interval(*whole, values.size(), tail);
  }
  std::vector<double> found;  // error of each resample in standard errors
  found.reserve(kResamples);
  resample(values, seed, path, [&](std::span<const Value> sample) {
    const std::optional<Estimate> one = estimate(sample);
    if (!one) {
      return;
    }
    const double off = one->value - whole->value;
    if (one->error > 0.0) {
      found.push_back(off / one->error);
    } else {
      found.push_back(off > 0.0 ? kInfinity : off < 0.0 ? -kInfinity : 0.0);
    }
  });
  if (static_cast<double>(kResamples) - static_cast<double>(found.size()) > tail * kResamples) {
    return std::nullopt;
  }
  if (whole->error == 0.0) {
    return Interval{whole->value, whole->value};
  }
  if (!few) {
    std::sort(found.begin(), found.end());
    const double below = quantile(found, 1.0 - tail) * whole->error;
    const double above = -quantile(found, tail) * whole->error;
    if (std::isfinite(below) && std::isfinite(above)) {
      const Interval student = student_interval(*whole, values.size(), tail);
      const double farthest = kFarthest * (student.high - whole->value);
      return Interval{whole->value - std::min(below, farthest),
                      whole->value + std::min(above, farthest)};
    }
  }
  return student_interval(*whole, values.size(), tail);
}

}  // namespace

std::optional<Interval> mean_interval(std::span<const double> values, double confidence,
                                      std::uint64_t seed, std::string_view path) {
  const std::vector<double> sorted = ascending(values);  // the order of the runs must not matter
  return studentized<double>(
      sorted, [](std::span<const double> sample) { return std::optional(estimate(sample)); }, false,
      confidence, seed, path);
}

std::optional<Interval> median_interval(std::span<const double> values, double confidence) {
  const std::vector<double> sorted = ascending(values);
  if (sorted.empty()) {
    return std::nullopt;
  }
  // The number of values that may be cut off at each end: it is unlikely that more lie on one side
  // of the median.
  std::size_t cut = 0;
  while (2 * cut < sorted.size() && 2.0 * fair_at_most(cut, sorted.size()) <= 1.0 - confidence) {
    ++cut;
  }
  if (cut == 0) {
    return std::nullopt;
  }
  return Interval{sorted[cut - 1], sorted[sorted.size() - cut]};
}

std::optional<Interval> bootstrap_interval(Statistic statistic, std::span<const double> values,
                                           double confidence, std::uint64_t seed,
                                           std::string_view path) {
  if (values.size() < 2) {
    return std::nullopt;
  }
  const std::vector<double> sorted = ascending(values);
  if (sorted.front() == sorted.back()) {
    const double only = statistic_of(statistic, sorted).value_or(0.0);
    return Interval{only, only};
  }
  std::vector<double> found;
  found.reserve(kResamples);
  resample<double>(sorted, seed, path, [&](std::span<const double> sample) {
    found.push_back(statistic_of(statistic, sample).value_or(0.0));
  });
  std::sort(found.begin(), found.end());
  const double tail = 0.5 * (1.0 - confidence);
  return Interval{quantile(found, tail), quantile(found, 1.0 - tail)};
}

std::optional<Interval> interval_of(Statistic statistic, std::span<const double> values,
                                    double confidence, std::uint64_t seed, std::string_view path) {
  switch (statistic) {
    case Statistic::mean:
      return mean_interval(values, confidence, seed, path);
    case Statistic::median:
      return median_interval(values, confidence);
    case Statistic::rate:
      return wilson_interval(static_cast<std::size_t>(std::count_if(
                                 values.begin(), values.end(), [](double v) { return v != 0.0; })),
                             values.size(), confidence);
    default:
      return bootstrap_interval(statistic, values, confidence, seed, path);
  }
}

std::optional<Interval> paired_interval(Relation relation, Statistic statistic,
                                        std::span<const Pair> pairs, double confidence,
                                        std::uint64_t seed, std::string_view path) {
  if (statistic == Statistic::mean) {
    return studentized<Pair>(
        pairs, [&](std::span<const Pair> sample) { return estimate(relation, sample); },
        relation == Relation::ratio, confidence, seed, path);
  }
  if (pairs.size() < 2) {
    return std::nullopt;
  }
  std::vector<double> found;
  resample<Pair>(pairs, seed, path, [&](std::span<const Pair> sample) {
    if (const auto value = boundless_relation(relation, statistic, sample)) {
      found.push_back(*value);
    }
  });
  if (2 * found.size() < static_cast<std::size_t>(kResamples)) {
    return std::nullopt;
  }
  std::sort(found.begin(), found.end());
  const double tail = 0.5 * (1.0 - confidence);
  const Interval interval{quantile(found, tail), quantile(found, 1.0 - tail)};
  if (!std::isfinite(interval.low) || !std::isfinite(interval.high)) {
    return std::nullopt;
  }
  return interval;
}

}  // namespace elsie::report
