// Recognizes a second request to end.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace elsie::program {

/// Distinguishes a second request to end from an echo of the first: timeout(1), schedulers and
/// shells send a signal to a process and to its group, which is one request. For signal handlers.
class RepeatedRequest {
 public:
  enum class Kind { first, echo, second };

  Kind come() noexcept {
    using Clock = std::chrono::steady_clock;
    const std::int64_t now_ns =
        std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch())
            .count();
    std::int64_t first_ns = kNone;
    if (first_ns_.compare_exchange_strong(first_ns, now_ns)) {
      return Kind::first;
    }
    return now_ns - first_ns > kOneRequest_ns ? Kind::second : Kind::echo;
  }
  bool has_come() const noexcept { return first_ns_ != kNone; }
  void forget() noexcept { first_ns_ = kNone; }

 private:
  static constexpr std::int64_t kNone = -1;
  static constexpr std::int64_t kOneRequest_ns = 500'000'000;

  std::atomic<std::int64_t> first_ns_{kNone};
  static_assert(std::atomic<std::int64_t>::is_always_lock_free);
};

}  // namespace elsie::program
