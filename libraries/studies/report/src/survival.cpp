#include "elsie/report/survival.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "distributions.h"

namespace elsie::report {

namespace {

constexpr double kHalf = 0.5;
constexpr double kNearHalf = 1e-9;  // of a product of fractions

Interval loglog_interval(double survival, double greenwood, double z) {
  if (survival <= 0.0 || survival >= 1.0) {
    return {survival, survival};
  }
  const double log = std::log(survival);
  const double reach = z * std::sqrt(greenwood) / std::abs(log);
  return {std::pow(survival, std::exp(reach)), std::pow(survival, std::exp(-reach))};
}

// The first time at which a curve is at most one half.
template <class Curve>
std::optional<double> first_half(const std::vector<SurvivalStep>& steps, Curve curve) {
  for (const SurvivalStep& step : steps) {
    if (curve(step) <= kHalf + kNearHalf) {
      return step.time;
    }
  }
  return std::nullopt;
}

std::optional<double> median_of(const std::vector<SurvivalStep>& steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].survival > kHalf + kNearHalf) {
      continue;
    }
    if (steps[i].survival >= kHalf - kNearHalf) {
      // Exactly one half until the next event, or to the end.
      const auto next = std::find_if(steps.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                     steps.end(), [](const auto& step) { return step.events > 0; });
      return next == steps.end() ? std::optional<double>() : 0.5 * (steps[i].time + next->time);
    }
    return steps[i].time;
  }
  return std::nullopt;
}

}  // namespace

std::size_t SurvivalCurve::at_risk(double time) const {
  for (const SurvivalStep& step : steps) {
    if (step.time >= time) {
      return step.at_risk;
    }
  }
  return 0;
}

SurvivalCurve survival_of(std::span<const Observed> times, double confidence, double copies) {
  std::vector<Observed> sorted(times.begin(), times.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const Observed& a, const Observed& b) { return a.value < b.value; });
  const double z = normal_reach(confidence);
  SurvivalCurve curve;
  double survival = 1.0, greenwood = 0.0;
  for (std::size_t i = 0; i < sorted.size();) {
    SurvivalStep step;
    step.time = sorted[i].value;
    step.at_risk = sorted.size() - i;
    for (; i < sorted.size() && sorted[i].value == step.time; ++i) {
      ++(sorted[i].bound ? step.cut_off : step.events);
    }
    const auto risk = static_cast<double>(step.at_risk), events = static_cast<double>(step.events);
    survival *= 1.0 - events / risk;
    if (step.events < step.at_risk) {
      greenwood += events / (risk * (risk - events));
    }
    step.survival = survival;
    step.interval = loglog_interval(survival, copies * greenwood, z);
    curve.steps.push_back(step);
  }
  curve.median = median_of(curve.steps);
  const auto low = first_half(curve.steps, [](const SurvivalStep& s) { return s.interval.low; });
  const auto high = first_half(curve.steps, [](const SurvivalStep& s) { return s.interval.high; });
  if (low) {
    curve.median_interval = Interval{*low, high.value_or(std::numeric_limits<double>::infinity())};
  }
  return curve;
}

}  // namespace elsie::report
