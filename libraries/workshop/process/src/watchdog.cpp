// Ends the process when a plugin does not return.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <stop_token>

#include <pthread.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "elsie/files/emergency.h"
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
std::atomic<std::uint64_t> looks{0};  // counted by the handler, in the watched thread

void look(int, siginfo_t*, void* context) {
  ++looks;
  const Call* const call = Call::innermost();
  if (call && 1e9 * call->own_time_s() > static_cast<double>(limit_ns.load()) && may_report()) {
    write_report(report, place_of_fault(context));
    end_with(status);
  }
}

/// The time between looks: soon after the limit, but not wastefully often.
std::chrono::nanoseconds period() {
  return std::chrono::nanoseconds(std::clamp<std::int64_t>(limit_ns / 4, 1'000'000, 250'000'000));
}

/// Runs in its own thread: ends the process when the watched thread exceeds its limit in one call
/// by a second and its handler does not run.
void look_from_outside(const std::stop_token& stop, Call* const* place) {
  constexpr double kGrace = 1.0;  // s
  std::mutex mutex;
  std::condition_variable_any pause;
  std::unique_lock lock(mutex);
  const Call* before = nullptr;
  std::int64_t begun_before = 0;
  std::uint64_t looks_before = 0;
  int late = 0;  // in consecutive looks
  while (!pause.wait_for(
      lock, stop, std::max<std::chrono::nanoseconds>(period(), std::chrono::milliseconds(50)),
      [] { return false; })) {
    if (stop.stop_requested()) {
      return;
    }
    Call* const call = *place;
    const std::uint64_t looks_now = looks;
    // The same call, not a later one at the same place.
    const std::int64_t begun = call ? call->begun_ns() : 0;
    const bool is_late = call && call == before && begun == begun_before &&
                         looks_now == looks_before &&
                         call->own_time_s() > 1e-9 * static_cast<double>(limit_ns.load()) + kGrace;
    late = is_late ? late + 1 : 0;
    // Not at the first look: threads of a stopped process resume in any order.
    if (late > 2 && may_report()) {
      Call::adopt(call);
      char what[160] = "has blocked all signals, and ";
      std::strncat(what, report, sizeof(what) - std::strlen(what) - 1);
      write_culprit_and(what, nullptr);
      files::clean_up_in_emergency();
      end_with(status);
    }
    before = call;
    begun_before = begun;
    looks_before = looks_now;
  }
}

}  // namespace

Watchdog::Watchdog(double limit_s, int exit_status, const char* what) {
  prepare_stack_trace();
  limit_ns = std::llround(1e9 * limit_s);
  status = exit_status;
  report = what;
  handle(kSignal, look, SA_ONSTACK | SA_RESTART);
  sigevent event{};
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = kSignal;
  event._sigev_un._tid = static_cast<pid_t>(syscall(SYS_gettid));
  timer_t timer{};
  if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0) {
    throw std::runtime_error("cannot create the timer that stops plugins which do not return");
  }
  timer_ = timer;
  const std::int64_t period_ns = period().count();
  itimerspec times{};
  times.it_interval = {static_cast<time_t>(period_ns / 1'000'000'000),
                       static_cast<long>(period_ns % 1'000'000'000)};
  times.it_value = times.it_interval;
  timer_settime(timer, 0, &times, nullptr);
  // Only the thread that runs plugins handles signals.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  outside_ = std::jthread(look_from_outside, Call::place_of_innermost());
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Watchdog::~Watchdog() {
  timer_delete(timer_);
  std::signal(kSignal, SIG_IGN);  // one may be pending
}

}  // namespace elsie::process
