#include "progress.h"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include <unistd.h>

#include "elsie/base/number_text.h"
#include "elsie/process/crash_report.h"
#include "elsie/simulation/simulation.h"

#include "command.h"
#include "repeated_request.h"

namespace elsie::program {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kRedraw = std::chrono::milliseconds(100);
constexpr int kBarWidth = 32;
constexpr std::uint64_t kStepsBetweenLooks = 64;  // between looks at the clock

// A signal handler can only reach a global of this kind.
volatile std::sig_atomic_t interrupted = 0;
RepeatedRequest request;

void interrupt(int) {
  const RepeatedRequest::Kind kind = request.come();
  interrupted = 1;
  if (kind == RepeatedRequest::Kind::second) {
    // The current work never ends.
    process::end_process(
        "was at work when the run was interrupted",
        "something outside of all plugins was at work when the run was interrupted", kOtherFailure);
  }
}

constexpr std::string_view kWipe = "\r\033[K";
volatile std::sig_atomic_t check_is_drawn = 0;

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

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

void end_at_once(int) {
  if (check_is_drawn != 0) {
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kWipe.data(), kWipe.size());
  }
  process::end_process("was at work when the program was interrupted",
                       "interrupted; no run was under way", kOtherFailure,
                       process::Stack::left_out);
}

}  // namespace

std::string bar_text(double part) {
  part = std::clamp(part, 0.0, 1.0);
  std::string bar(static_cast<std::size_t>(part * kBarWidth), '=');
  bar += '>';
  bar.resize(kBarWidth + 1, ' ');
  const std::string percent = base::fixed_text(100.0 * part, 0);
  return "[" + bar + "] " + std::string(3 - std::min<std::size_t>(3, percent.size()), ' ') +
         percent + " %";
}

void ProgressBar::started(const simulation::Simulation&) {
  start_ = Clock::now();
  last_drawn_ = start_;
}

void ProgressBar::stepped(const simulation::Simulation& simulation) {
  if (simulation.steps() % kStepsBetweenLooks != 0) {
    return;
  }
  const auto now = Clock::now();
  if (now - last_drawn_ < kRedraw) {
    return;
  }
  last_drawn_ = now;
  const double part = std::min(1.0, simulation.time_s() / simulation.time_limit_s());
  const double speed = simulation.time_s() / std::chrono::duration<double>(now - start_).count();
  std::fprintf(stderr, "\r%s  %s s  %s x real time ", bar_text(part).c_str(),
               base::fixed_text(simulation.time_s(), 1).c_str(),
               base::fixed_text(speed, 0).c_str());
  std::fflush(stderr);
}

void ProgressBar::ended(const simulation::Simulation&) {
  std::fwrite(kWipe.data(), 1, kWipe.size(), stderr);
  std::fflush(stderr);
}

CheckProgress::CheckProgress(bool shown)
    : shown_(shown && isatty(STDERR_FILENO) != 0), last_drawn_(Clock::now()) {}

CheckProgress::~CheckProgress() {
  if (check_is_drawn != 0) {
    std::fwrite(kWipe.data(), 1, kWipe.size(), stderr);
    std::fflush(stderr);
    check_is_drawn = 0;
  }
}

void CheckProgress::draw(std::size_t checked, std::size_t all) {
  if (!shown_ || Clock::now() - last_drawn_ < kRedraw) {
    return;
  }
  last_drawn_ = Clock::now();
  check_is_drawn = 1;
  std::fprintf(stderr, "\r%s  of %zu cells checked ",
               bar_text(static_cast<double>(checked) / static_cast<double>(all)).c_str(), all);
  std::fflush(stderr);
}

void end_at_once_when_interrupted() {
  for (const int signal : kSignals) {
    set_handler(signal, end_at_once, true);
  }
}

InterruptGuard::InterruptGuard() {
  interrupted = 0;
  request.forget();
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    // Ignored hang-ups (nohup) stay ignored; Ctrl-C also ends runs in the background of a script.
    before_[i] = set_handler(kSignals[i], interrupt, kSignals[i] == SIGHUP);
  }
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &before_[i], nullptr);
  }
}

void InterruptGuard::stepped(const simulation::Simulation&) {
  if (is_interrupted()) {
    throw Interrupted();
  }
}

bool InterruptGuard::is_interrupted() { return interrupted != 0; }

}  // namespace elsie::program
