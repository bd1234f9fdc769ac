// Ends the process when a plugin does not return.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <stop_token>

#include <pthread.h>

#include "elsie/plugin/call.h"
#include "elsie/process/crash_report.h"
#include "elsie/process/process_end.h"

#include "reporting.h"

namespace elsie::process {

using plugin::Call;

namespace {

constexpr int kSignal = SIGVTALRM;

// Signal handlers can only reach globals.
std::atomic<std::int64_t> limit_ns{0};
std::atomic<int> status{0};
std::atomic<const char*> report{nullptr};

bool is_late(const Call* call) {
  return call && 1e9 * call->own_time_s() > static_cast<double>(limit_ns.load());
}

/// In the watched thread, whose stack it shows.
void end_if_late(int, siginfo_t*, void* context) {
  if (is_late(Call::innermost()) && may_report()) {
    write_report(report, place_of_fault(context));
    end_with(status);
  }
}

/// The time between looks: soon after the limit, but not wastefully often.
std::chrono::nanoseconds period() {
  return std::chrono::nanoseconds(std::clamp<std::int64_t>(limit_ns / 4, 1'000'000, 250'000'000));
}

/// Runs in its own thread. Sends the signal only once a call exceeds its limit, so that no other
/// call is interrupted.
void look_from_outside(const std::stop_token& stop, pthread_t watched, Call* const* place) {
  std::mutex mutex;
  std::condition_variable_any pause;
  std::unique_lock lock(mutex);
  while (!pause.wait_for(lock, stop, period(), [] { return false; }) && !stop.stop_requested()) {
    if (is_late(*place)) {
      pthread_kill(watched, kSignal);
    }
  }
}

}  // namespace

Watchdog::Watchdog(double limit_s, int exit_status, const char* what) {
  prepare_stack_trace();
  limit_ns = std::llround(1e9 * limit_s);
  status = exit_status;
  report = what;
  handle(kSignal, end_if_late, SA_ONSTACK | SA_RESTART);
  // Only the thread that runs plugins handles signals.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  outside_ = std::jthread(look_from_outside, pthread_self(), Call::place_of_innermost());
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Watchdog::~Watchdog() {
  outside_.request_stop();
  outside_.join();
  std::signal(kSignal, SIG_IGN);  // one may be pending
}

}  // namespace elsie::process
