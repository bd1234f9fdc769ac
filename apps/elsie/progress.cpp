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

std::string bar_text(double part) {
  std::string bar(static_cast<std::size_t>(part * kBarWidth), '=');
  bar += '>';
  bar.resize(kBarWidth + 1, ' ');
  char percent[16];
  std::snprintf(percent, sizeof(percent), "%3.0f %%", 100.0 * part);
  return "[" + bar + "] " + percent;
}

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
  std::fprintf(stderr, "\r%s  %.1f s  %.0f x real time ", bar_text(part).c_str(),
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
  if (is_interrupted()) {
    throw Interrupted();
  }
}

bool InterruptGuard::is_interrupted() { return interrupted != 0; }
