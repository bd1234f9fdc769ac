#include "interrupts.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "elsie/process/crash_report.h"

#include "command.h"
#include "status_line.h"

namespace elsie::program {

namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
/// timeout(1), schedulers and shells send a signal to a process and to its group, which is one
/// request.
constexpr std::int64_t kOneRequest_ns = 500'000'000;
constexpr std::int64_t kNone = -1;

// A signal handler can only reach globals.
std::atomic<std::int64_t> first_ns{kNone};
std::atomic<int> to_write{-1};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

void interrupt(int) {
  using Clock = std::chrono::steady_clock;
  const int error = errno;
  const std::int64_t now_ns =
      std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch()).count();
  std::int64_t before_ns = kNone;
  if (first_ns.compare_exchange_strong(before_ns, now_ns)) {
    [[maybe_unused]] const ssize_t written = ::write(to_write, "!", 1);
  } else if (now_ns - before_ns > kOneRequest_ns) {
    // The current work never ends.
    wipe_status();
    process::end_process("was at work when the run was interrupted",
                         "interrupted twice; no plugin was at work", kOtherFailure);
  }
  errno = error;
}

void end_at_once(int) {
  wipe_status();
  process::end_process("was at work when the program was interrupted",
                       "interrupted; no run was under way", kOtherFailure,
                       process::Stack::left_out);
}

/// Sets a handler, or leaves the signal ignored if it is and `unless_ignored`. Returns what was set
/// before.
struct sigaction set_handler(int signal, void (*handler)(int), bool unless_ignored) {
  struct sigaction before {};
  sigaction(signal, nullptr, &before);
  if (before.sa_handler != SIG_IGN || !unless_ignored) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
  return before;
}

}  // namespace

void end_at_once_when_interrupted() {
  for (const int signal : kSignals) {
    set_handler(signal, end_at_once, true);
  }
}

InterruptGuard::InterruptGuard() {
  if (pipe2(ends_.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    throw std::runtime_error("signals cannot be waited for: " +
                             std::generic_category().message(errno));
  }
  first_ns = kNone;
  to_write = ends_[1];
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    // Ignored hang-ups (nohup) stay ignored; Ctrl-C also ends work in the background of a script.
    before_[i] = set_handler(kSignals[i], interrupt, kSignals[i] == SIGHUP);
  }
}

InterruptGuard::~InterruptGuard() {
  to_write = -1;
  close(ends_[0]);
  close(ends_[1]);
  if (is_interrupted()) {
    return;  // echoes of the signal may follow, and the work is already stopping
  }
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &before_[i], nullptr);
  }
}

void InterruptGuard::stepped(const simulation::Simulation&) {
  if (is_interrupted()) {
    throw Interrupted();
  }
}

bool InterruptGuard::is_interrupted() { return first_ns != kNone; }

}  // namespace elsie::program
