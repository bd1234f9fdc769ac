// Samples of a run at equal intervals of simulated time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace elsie::traces {

/// The number of steps nearest to a period, at least one. Periods of any length are fine.
inline std::uint64_t steps_in(double period_s, double step_s) {
  constexpr double kForever = 1e15;  // steps; a run has fewer
  return static_cast<std::uint64_t>(std::clamp(std::round(period_s / step_s), 1.0, kForever));
}

/// Decides when a sample is due: one per period, the first at the first time that is queried. An
/// edit may change the length of the steps between two samples.
class Sampling {
 public:
  Sampling() = default;
  explicit Sampling(double period_s) : period_s_(period_s) {}

  double period_s() const { return period_s_; }
  /// Must be asked once for each time, in ascending order.
  bool is_due(double time_s) {
    constexpr double kNearly = 1e-6;  // periods; sums of steps have rounding errors
    const double number = std::floor(time_s / period_s_ + kNearly);
    if (number <= last_) {
      return false;
    }
    last_ = number;
    return true;
  }
  /// The time of the last sample, rounded to a whole number of periods.
  double last_s() const { return last_ * period_s_; }

 private:
  double period_s_ = 1.0;
  double last_ = -1.0;  // number of the last sample
};

}  // namespace elsie::traces
