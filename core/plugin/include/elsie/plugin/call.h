// The calls into plugins that this thread is in.
//
//   {
//     const plugin::Call call({.plugin = &use.plugin, .robot = &robot.id, .step = 50});
//     behavior.respond(now);  // if this crashes, the signal handler knows whose code it was
//   }
//
// A plugin that crashes cannot report its name, so every caller notes it first for crash_report.h.
// A note takes a few nanoseconds and allocates nothing.
//
// A call also restores the floating-point settings (arithmetic.h): a plugin that changes how
// numbers are rounded would change the results of all others.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "elsie/plugin/arithmetic.h"

namespace elsie::plugin {

/// Facts about a call. The texts must live as long as the call. Missing facts are those of the
/// calls around it. Only crash reports read the names: in a crowd, each memory access is costly.
struct CallFacts {
  static constexpr std::uint64_t kNoStep = ~std::uint64_t{0};

  const std::string* plugin = nullptr;  // its name
  const std::string* id = nullptr;      // on the robot
  const std::string* robot = nullptr;   // id
  const char* library = nullptr;        // the file that contains the plugin
  const char* file = nullptr;           // of the world, where the plugin is named
  int line = 0;
  std::uint64_t step = kNoStep;
  double time_s = 0.0;          // of the step
  const char* doing = nullptr;  // without a step: "while it was made"
};

/// Notes a call during its lifetime. Calls nest and end in reverse order.
class Call {
 public:
  // Always inline: several calls for each decision of a robot.
  [[gnu::always_inline]] explicit Call(const CallFacts& facts) noexcept
      : facts_(facts), outer_(innermost_) {
    std::atomic_signal_fence(std::memory_order_release);
    innermost_ = this;
  }
  [[gnu::always_inline]] ~Call() {
    if (end_copy_) [[unlikely]] {
      end_copy_();
    }
    if (!is_over_) {
      restore_arithmetic();
    }
    if (start_ns_ != 0) {
      stop_clock();
    }
    innermost_ = outer_;
    std::atomic_signal_fence(std::memory_order_release);
  }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /// Restores the floating-point settings; the destructor does so, too. Returns what the call had
  /// changed, as Arithmetic::difference_from() does, or null.
  const char* restore_arithmetic() noexcept {
    const Arithmetic now = Arithmetic::now();
    return now == before_ ? nullptr : restore_from(now);
  }

  /// Does the same once the plugin has returned; the destructor then skips it.
  [[gnu::always_inline]] const char* end_arithmetic() noexcept {
    is_over_ = true;
    return restore_arithmetic();
  }

  /// Returns whether this thread called fork() during the call, since watch_for_copies().
  /// posix_spawn(), popen() and system() do not count.
  bool has_forked() const { return has_forked_; }
  /// From now on, a copy of the process that a plugin makes with fork() calls this function when
  /// the plugin returns. A program calls this once, early.
  static void watch_for_copies(void (*end_copy)() noexcept);

  /// From now on the call's time is measured, and a Watchdog sees it.
  void start_clock() noexcept;
  /// The time of the call without the calls inside it, s. Zero without start_clock().
  double own_time_s() const noexcept;
  /// Memory that was measured in this call, bytes, for measured calls around it.
  std::int64_t inner_bytes = 0;

  const CallFacts& facts() const { return facts_; }
  Call* outer() const { return outer_; }
  /// The call that this thread is in; null: none.
  static Call* innermost() noexcept { return innermost_; }
  /// Where other threads find this thread's innermost call, which may end at any time.
  static Call* const* place_of_innermost() noexcept { return &innermost_; }
  /// Lets other threads see the calls of this one, until it ends. For threads that share the work
  /// of a run.
  static void show_thread();
  /// The call that some shown thread is in, and may leave at any time; null: none is in a call. For
  /// signal handlers.
  static Call* of_shown_threads() noexcept;
  /// Gives this thread, which is about to end the process, the call of another thread.
  static void adopt(Call* innermost) noexcept { innermost_ = innermost; }

 private:
  void stop_clock() noexcept;
  const char* restore_from(const Arithmetic& now) noexcept;

  // Signal handlers read it, so it must not be allocated on first use.
  __attribute__((tls_model("initial-exec"))) static constinit thread_local Call* innermost_;

  // Set in a copy of the process only.
  static void (*end_copy_)() noexcept;

  CallFacts facts_;
  Call* outer_;
  bool has_forked_ = false;
  bool is_over_ = false;  // end_arithmetic() was called
  const Arithmetic before_ = Arithmetic::now();
  std::int64_t start_ns_ = 0;  // on the steady clock; 0: not measured
  std::int64_t inner_ns_ = 0;  // of the calls inside it that are over
};

}  // namespace elsie::plugin
