// What a trace keeps of a row: how it is rounded, and when it has changed.
#pragma once

#include <array>
#include <charconv>
#include <cstring>

#include "elsie/api/coordinator.h"

namespace elsie::traces {

inline constexpr int kDecimals = 3;
inline constexpr int kWeightDigits = 4;

/// The two rows say the same, to the last bit.
inline bool same(const TraceRow& a, const TraceRow& b) {
  return a.asked == b.asked && a.command == b.command && a.activation == b.activation &&
         a.strength == b.strength && a.weight == b.weight && a.share == b.share &&
         a.inhibited_by == b.inhibited_by &&
         (a.reason == b.reason || std::strcmp(a.reason, b.reason) == 0);
}

/// The number to a few significant digits, as it will be read back.
inline double shortened(double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, kWeightDigits)
                       .ptr;
  double result = 0.0;
  std::from_chars(digits.data(), end, result);
  return result + 0.0;
}

}  // namespace elsie::traces
