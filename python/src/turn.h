// Long work without Python's lock is done in turns. Between two of them its thread takes the lock
// and looks for signals, such as that of Ctrl-C:
//
//   while (!is_done()) {
//     for (Turn turn; !is_done() && !turn.is_over();) step();
//     look_for_signals();
//   }
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace elsie::python {

class Turn {
 public:
  /// It begins now. Copies end at the same time.
  Turn() : end_(Clock::now() + kLength) {}

  bool has_ended() const { return Clock::now() > end_; }
  /// The same, to be asked after each step: it looks at the clock after the first ones, and then
  /// seldom enough to cost nothing.
  bool is_over() {
    if (++steps_ < next_look_) return false;
    next_look_ += std::min(next_look_, kMostBetweenLooks);
    return has_ended();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kLength{50};
  static constexpr std::uint64_t kMostBetweenLooks = 16;

  Clock::time_point end_;
  std::uint64_t steps_ = 0, next_look_ = 1;
};

}  // namespace elsie::python
