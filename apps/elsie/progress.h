// Progress bars on a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "elsie/simulation/observer.h"

#include "status_line.h"

namespace elsie::program {

/// "[=====>    ]  42 %": the part that is done, from 0 to 1.
std::string bar_text(double part);

/// Draws "[=====>    ]  42 %  252.0 s  31 x real time" on standard error during a run, and removes
/// it at the end.
class ProgressBar final : public simulation::Observer {
 public:
  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;
  void ended(const simulation::Simulation& simulation) override;

 private:
  std::chrono::steady_clock::time_point start_;
  StatusLine line_{true};
};

/// Draws "[=====>    ]  42 %  of 40000 cells checked" on standard error while an experiment is
/// read, if that takes a while; removes it at the end.
class CheckProgress {
 public:
  explicit CheckProgress(bool shown) : line_(shown) {}
  void draw(std::size_t checked, std::size_t all);

 private:
  StatusLine line_;
};

}  // namespace elsie::program
