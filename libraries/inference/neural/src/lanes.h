// Two numbers side by side.
//
// Most layers have two to eight neurons. Two doubles fit a register of every 64-bit processor, and
// a network of a few neurons gains nothing from more. The same operations in the same order give
// the same bits on every processor.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace elsie::neural {

using Pair = double __attribute__((vector_size(16)));
using PairBits = std::int64_t __attribute__((vector_size(16)));

#define ELSIE_INLINE [[gnu::always_inline]] inline

ELSIE_INLINE Pair load(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof(pair));
  return pair;
}
ELSIE_INLINE void store(double* to, Pair pair) { std::memcpy(to, &pair, sizeof(pair)); }
ELSIE_INLINE Pair both(double value) { return Pair{value, value}; }
ELSIE_INLINE Pair first_twice(Pair pair) { return Pair{pair[0], pair[0]}; }
ELSIE_INLINE Pair second_twice(Pair pair) { return Pair{pair[1], pair[1]}; }
/// The sum of the first pair, and that of the second.
ELSIE_INLINE Pair sums(Pair a, Pair b) { return Pair{a[0], b[0]} + Pair{a[1], b[1]}; }

/// The padded size of a layer in memory.
constexpr std::size_t padded(std::size_t size) { return (size + 1) / 2 * 2; }

}  // namespace elsie::neural
