// Numbers as recordings keep them.
#pragma once

#include <algorithm>
#include <cmath>

namespace elsie::files {

/// The number rounded to `decimals` decimals, 0 to 9; never a negative zero.
inline double rounded(double value, int decimals) {
  constexpr double kPowers[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
  const double power = kPowers[std::clamp(decimals, 0, 9)];
  constexpr double kWhole = 1e15;  // above it, doubles have hardly any decimals
  return std::abs(value) * power < kWhole ? std::round(value * power) / power + 0.0 : value;
}

}  // namespace elsie::files
