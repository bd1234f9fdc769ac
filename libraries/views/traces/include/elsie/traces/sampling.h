// Periods as whole numbers of steps.
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

}  // namespace elsie::traces
