// The memory that the process uses.
#pragma once

#include <algorithm>
#include <cstddef>

namespace elsie::testing {

/// Bytes allocated by the whole process and not freed yet.
std::size_t memory_in_use();

/// The increase of used memory by `action`, in bytes.
template <class Action>
double growth(Action action) {
  const std::size_t before = memory_in_use();
  action();
  return static_cast<double>(memory_in_use()) - static_cast<double>(before);
}

/// The lasting increase, which recurs each time: the allocator's lists of free blocks may take a
/// few rounds to fill. An increase of at most `least` bytes is not measured again.
template <class Action>
double steady_growth(double least, Action action) {
  constexpr int kRounds = 8;
  double smallest = growth(action);
  for (int i = 1; i < kRounds && smallest > least; ++i) {
    smallest = std::min(smallest, growth(action));
  }
  return smallest;
}

}  // namespace elsie::testing
