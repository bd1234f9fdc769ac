// Who is at work: the calls into plugins' code that this thread is in.
//
//   {
//     const plugin::Call call({.plugin = "wander", .robot = "r1", .step = 50});
//     behavior.respond(now);  // whatever becomes of it: a handler of signals knows whose it was
//   }
//
// A plugin that crashes cannot say who it is. So everybody who calls one notes it before, for
// crash_report.h. A note costs a few nanoseconds and allocates nothing.
//
// A call also keeps the processor's way of computing (arithmetic.h) what it was: a plugin that
// changes how numbers are rounded would change the results of all others.
#pragma once

#include <atomic>
#include <cstdint>

#include "elsie/plugin/arithmetic.h"

namespace elsie::plugin {

/// What is known of a call. The texts must live as long as the call; all of it may be left out, and
/// is then looked for in the calls around it.
struct CallFacts {
  static constexpr std::uint64_t kNoStep = ~std::uint64_t{0};

  const char* plugin = nullptr;   // its name
  const char* id = nullptr;       // on the robot
  const char* robot = nullptr;    // id
  const char* library = nullptr;  // the file that the plugin comes from
  const char* file = nullptr;     // where the world asks for it
  int line = 0;
  std::uint64_t step = kNoStep;
  const char* doing = nullptr;  // when there is no step: "while it was made"
};

/// Notes a call for as long as it lives. Calls nest, and end in reverse order.
class Call {
 public:
  explicit Call(const CallFacts& facts) noexcept : facts_(facts), outer_(innermost_) {
    std::atomic_signal_fence(std::memory_order_release);
    innermost_ = this;
  }
  ~Call() {
    if (end_copy_) [[unlikely]] {
      end_copy_();
    }
    restore_arithmetic();
    if (start_ns_ != 0) {
      stop_clock();
    }
    innermost_ = outer_;
    std::atomic_signal_fence(std::memory_order_release);
  }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /// Undoes what the call has changed of the processor's way of computing; its end does so as well.
  /// Says what that was, as Arithmetic::difference_from() does; null: nothing.
  const char* restore_arithmetic() noexcept {
    const Arithmetic now = Arithmetic::now();
    return now == before_ ? nullptr : restore_from(now);
  }

  /// Whether fork() was called in it, in this thread, since watch_for_copies(). posix_spawn(),
  /// popen() and system(), which start a program, do not count.
  bool has_forked() const { return has_forked_; }
  /// From now on, a copy of the process that a plugin makes with fork() calls this when the plugin
  /// returns in it. Once, early, by a program.
  static void watch_for_copies(void (*end_copy)() noexcept);

  /// From now on the time that the call takes is measured, and a Watchdog looks at it.
  void start_clock() noexcept;
  /// How long it has taken, s, without the calls inside it. Zero unless the clock was started.
  double own_time_s() const noexcept;
  /// When its clock was started, ns on the steady clock; 0: it was not.
  std::int64_t begun_ns() const noexcept { return start_ns_; }
  /// For a call around it whose time or memory is measured: what was seen to in here.
  std::int64_t inner_bytes = 0;

  const CallFacts& facts() const { return facts_; }
  Call* outer() const { return outer_; }
  /// The call that this thread is in; null: none.
  static Call* innermost() noexcept { return innermost_; }
  /// Where another thread can read the innermost call of this one, with care: it may end meanwhile.
  static Call* const* place_of_innermost() noexcept { return &innermost_; }
  /// Has this thread, which is about to end the process, speak for another one.
  static void adopt(Call* innermost) noexcept { innermost_ = innermost; }

 private:
  void stop_clock() noexcept;
  const char* restore_from(const Arithmetic& now) noexcept;

  // Read by handlers of signals, which may not wait for memory of a thread's own to be made.
  __attribute__((tls_model("initial-exec"))) static constinit thread_local Call* innermost_;

  // Set in a copy of the process only.
  static void (*end_copy_)() noexcept;

  CallFacts facts_;
  Call* outer_;
  bool has_forked_ = false;
  const Arithmetic before_ = Arithmetic::now();
  std::int64_t start_ns_ = 0;  // on the steady clock; 0: not measured
  std::int64_t inner_ns_ = 0;  // of the calls inside it that are over
};

}  // namespace elsie::plugin
