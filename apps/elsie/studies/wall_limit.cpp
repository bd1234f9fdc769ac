#include "wall_limit.h"

#include <algorithm>
#include <cmath>
#include <csignal>

#include <sys/time.h>

#include "elsie/base/number_text.h"
#include "elsie/process/crash_report.h"
#include "elsie/simulation/simulation.h"

#include "command.h"

namespace elsie::program {
namespace {

constexpr double kGrace = 2.0;  // s, for the current step

// A signal handler can only reach a global of this kind.
volatile std::sig_atomic_t is_met = 0;

/// Sends SIGALRM after this time (s), to the thread of the run: helpers block signals.
void set_timer(double seconds) {
  constexpr long kMicro = 1'000'000;
  const long micros = seconds > 0.0 ? std::max(1L, std::lround(kMicro * seconds)) : 0L;
  itimerval times{};
  times.it_value.tv_sec = micros / kMicro;
  times.it_value.tv_usec = micros % kMicro;
  setitimer(ITIMER_REAL, &times, nullptr);
}

void limit_is_met(int) {
  if (is_met != 0) {
    process::end_process("did not return before the wall limit of the run",
                         "the run did not end before its wall limit", kPluginFailed);
  }
  is_met = 1;
  set_timer(kGrace);
}

}  // namespace

WallLimit::~WallLimit() { set_timer(0.0); }

void WallLimit::start_clock() const {
  if (limit_s_ <= 0.0) {
    return;
  }
  struct sigaction action {};
  action.sa_handler = limit_is_met;
  action.sa_flags = SA_ONSTACK | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGALRM, &action, nullptr);
  set_timer(limit_s_);
}

void WallLimit::stepped(const simulation::Simulation& simulation) {
  step_ = simulation.steps() - 1;
  time_s_ = next_s_;
  next_s_ = simulation.time_s();
  if (is_met != 0 && simulation.outcome() == simulation::Outcome::running) {
    throw WallLimitMet();
  }
}

void WallLimit::ended(const simulation::Simulation&) { set_timer(0.0); }

std::string WallLimit::what_happened() const {
  return "after " + base::number_text(limit_s_, 6) + " s on the clock it was in " +
         base::step_text(step_, time_s_) + " and went on";
}

}  // namespace elsie::program
