// The logistic sigmoid 1 / (1 + exp(-x)), two at a time.
//
// Online training is one long chain of dependent operations, and most of it is this function: its
// latency matters, not its throughput. So: x = g + u with g a multiple of 1/256 and |u| <= 1/512;
// exp(-g) from two small tables; and for exp(-u) the Pade approximant
// (12 - 6u + u^2) / (12 + 6u + u^2), whose relative error there, |u|^5 / 720, is below 1e-16. Its
// denominator goes into the one division that is needed anyway:
//
//   1 / (1 + exp(-g) n/d) = d / (d + exp(-g) n)
//
// The relative error is below 1e-15. Beyond |x| = 63 the value is that at 63: 1, or 4e-28.
#pragma once

#include <array>

#include "lanes.h"

namespace elsie::neural::logistic_detail {

inline constexpr double kLargest = 63.0;
inline constexpr int kFineBits = 7;  // 128 multiples of 1/256 make 1/2
inline constexpr int kFine = 1 << kFineBits;
inline constexpr int kCoarse = 256;  // multiples of 1/2 from -64 to 63.5

/// exp(x) for |x| <= 1/2, by its series.
constexpr long double small_exponential(long double x) {
  long double sum = 0.0L, term = 1.0L;
  for (int i = 1; i < 30; ++i) {
    sum += term;
    term *= x / static_cast<long double>(i);
  }
  return sum;
}

/// exp(-i / 256).
inline constexpr auto kFineTable = [] {
  std::array<double, kFine> table{};
  for (int i = 0; i < kFine; ++i) {
    table[static_cast<std::size_t>(i)] =
        static_cast<double>(small_exponential(-static_cast<long double>(i) / 256.0L));
  }
  return table;
}();

/// exp(-i / 2) for i from 0 to 127, then for i from -128 to -1: in the order of the lower eight
/// bits of i.
inline constexpr auto kCoarseTable = [] {
  std::array<double, kCoarse> table{};
  const long double step = small_exponential(0.5L);
  long double power = 1.0L;
  for (std::size_t i = 0; i <= kCoarse / 2; ++i) {
    if (i < kCoarse / 2) {
      table[i] = static_cast<double>(1.0L / power);
    }
    if (i > 0) {
      table[kCoarse - i] = static_cast<double>(power);
    }
    power *= step;
  }
  return table;
}();

/// exp(-g) for the multiple g of 1/256 whose number is in the lower bits.
ELSIE_INLINE double exponential(std::int64_t bits) {
  const auto number = static_cast<std::uint64_t>(bits);
  return kCoarseTable[(number >> kFineBits) % kCoarse] * kFineTable[number % kFine];
}

/// For |x| <= 63.
ELSIE_INLINE Pair within(Pair x) {
  const Pair round = both(0x1.8p44);  // adding it rounds to multiples of 1/256
  const Pair rounded = x + round;
  const PairBits number = std::bit_cast<PairBits>(rounded);
  const Pair u = x - (rounded - round);
  const Pair even = both(12.0) + u * u;
  const Pair odd = both(6.0) * u;
  const Pair d = even + odd;
  const Pair n = even - odd;
  return d / (d + Pair{exponential(number[0]), exponential(number[1])} * n);
}

[[gnu::noinline]] inline Pair anywhere(Pair x) {
  const Pair most = both(kLargest), least = both(-kLargest);
  x = x > most ? most : x;
  x = x < least ? least : x;
  return within(x);
}

}  // namespace elsie::neural::logistic_detail

namespace elsie::neural {

ELSIE_INLINE Pair logistic(Pair x) {
  using logistic_detail::kLargest;
  constexpr std::int64_t kWithoutSign = 0x7fffffffffffffff;
  // Compared as integers, in parallel with the chain that the result depends on.
  const PairBits beyond =
      (std::bit_cast<PairBits>(x) & kWithoutSign) > std::bit_cast<std::int64_t>(kLargest);
  if ((beyond[0] | beyond[1]) != 0) [[unlikely]] {
    return logistic_detail::anywhere(x);
  }
  return logistic_detail::within(x);
}

}  // namespace elsie::neural
