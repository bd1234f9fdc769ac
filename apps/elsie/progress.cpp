#include "progress.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "elsie/base/number_text.h"
#include "elsie/simulation/simulation.h"

namespace elsie::program {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kBarWidth = 32;
constexpr std::uint64_t kStepsBetweenLooks = 64;  // between looks at the clock

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

void ProgressBar::started(const simulation::Simulation&) { start_ = Clock::now(); }

void ProgressBar::stepped(const simulation::Simulation& simulation) {
  if (simulation.steps() % kStepsBetweenLooks != 0 || !line_.is_due()) {
    return;
  }
  const double part = std::min(1.0, simulation.time_s() / simulation.time_limit_s());
  const double speed =
      simulation.time_s() / std::chrono::duration<double>(Clock::now() - start_).count();
  line_.draw(bar_text(part) + "  " + base::fixed_text(simulation.time_s(), 1) + " s  " +
             base::fixed_text(speed, 0) + " x real time");
}

void ProgressBar::ended(const simulation::Simulation&) { wipe_status(); }

void CheckProgress::draw(std::size_t checked, std::size_t all) {
  if (line_.is_due()) {
    line_.draw(bar_text(static_cast<double>(checked) / static_cast<double>(all)) + "  of " +
               std::to_string(all) + " cells checked");
  }
}

}  // namespace elsie::program
