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
#include <stop_token>

#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "elsie/files/emergency.h"
#include "elsie/plugin/call.h"
#include "elsie/process/crash_report.h"
#include "elsie/process/process_end.h"
#include "elsie/sharing/crew.h"

#include "reporting.h"

namespace elsie::process {

using plugin::Call;

namespace {

constexpr int kSignal = sharing::Crew::kQuestion;  // the question only comes when the process ends

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

/// Runs in its own thread. Sends the signal to the watched thread once a call exceeds its limit, so
/// that no other call is interrupted; if its handler does not run for a second, ends the process.
void look_from_outside(const std::stop_token& stop, pid_t watched, Call* const* place) {
  constexpr double kGrace = 1.0;                          // s
  constexpr auto kDeaf = std::chrono::milliseconds(150);  // of looks one after the other
  std::mutex mutex;
  std::condition_variable_any pause;
  std::unique_lock lock(mutex);
  const Call* before = nullptr;
  std::int64_t begun_before = 0;
  std::uint64_t looks_before = 0;
  std::chrono::nanoseconds deaf{0};
  while (!pause.wait_for(lock, stop, period(), [] { return false; })) {
    if (stop.stop_requested()) {
      return;
    }
    Call* const call = *place;
    const std::uint64_t looks_now = looks;
    // The same call, not a later one at the same place.
    const std::int64_t begun = call ? call->begun_ns() : 0;
    const double late_s =
        call ? call->own_time_s() - 1e-9 * static_cast<double>(limit_ns.load()) : 0.0;
    if (late_s > 0.0) syscall(SYS_tgkill, getpid(), watched, kSignal);
    const bool is_deaf =
        late_s > kGrace && call == before && begun == begun_before && looks_now == looks_before;
    // Not at the first look: threads of a stopped process resume in any order.
    deaf = is_deaf ? deaf + period() : std::chrono::nanoseconds(0);
    if (deaf > kDeaf && may_report()) {
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
  // Only the thread that runs plugins handles signals.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  outside_ = std::jthread(look_from_outside, static_cast<pid_t>(syscall(SYS_gettid)),
                          Call::place_of_innermost());
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Watchdog::~Watchdog() {
  outside_.request_stop();
  outside_.join();
  std::signal(kSignal, SIG_IGN);  // one may be pending
}

}  // namespace elsie::process
