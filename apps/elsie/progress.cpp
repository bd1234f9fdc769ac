#include "progress.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string>

#include "elsie/simulation/simulation.h"

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kRedraw = std::chrono::milliseconds(100);
constexpr int kBarWidth = 32;
constexpr std::uint64_t kStepsBetweenLooks = 64;  // at the clock

// A signal handler can reach nothing but a global of this kind.
volatile std::sig_atomic_t interrupted = 0;
void interrupt(int) { interrupted = 1; }

}  // namespace

void ProgressBar::started(const elsie::simulation::Simulation&) {
  start_ = Clock::now();
  last_drawn_ = start_;
}

void ProgressBar::stepped(const elsie::simulation::Simulation& simulation) {
  if (simulation.steps() % kStepsBetweenLooks != 0) {
    return;
  }
  const auto now = Clock::now();
  if (now - last_drawn_ < kRedraw) {
    return;
  }
  last_drawn_ = now;
  const double part = std::min(1.0, simulation.time_s() / simulation.world().limits.time);
  const double speed = simulation.time_s() / std::chrono::duration<double>(now - start_).count();
  const int filled = static_cast<int>(part * kBarWidth);
  std::string bar(static_cast<std::size_t>(filled), '=');
  bar += '>';
  bar.resize(kBarWidth + 1, ' ');
  std::fprintf(stderr, "\r[%s] %3.0f %%  %.1f s  %.0f x real time ", bar.c_str(), 100.0 * part,
               simulation.time_s(), speed);
  std::fflush(stderr);
}

void ProgressBar::ended(const elsie::simulation::Simulation&) {
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

InterruptGuard::InterruptGuard() {
  interrupted = 0;
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

void InterruptGuard::stepped(const elsie::simulation::Simulation&) {
  if (interrupted) {
    throw Interrupted();
  }
}
