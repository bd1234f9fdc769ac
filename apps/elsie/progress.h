// A progress bar for a run, on a terminal.
#pragma once

#include <chrono>
#include <string>

#include "elsie/simulation/observer.h"

/// "[=====>    ]  42 %": how much of something is done, from 0 to 1.
std::string bar_text(double part);

/// Draws "[=====>    ]  42 %  252.0 s  31 x real time" on standard error while a run goes on, and
/// wipes it at the end.
class ProgressBar final : public elsie::simulation::Observer {
 public:
  void started(const elsie::simulation::Simulation& simulation) override;
  void stepped(const elsie::simulation::Simulation& simulation) override;
  void ended(const elsie::simulation::Simulation& simulation) override;

 private:
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_drawn_;
};

/// Ends the run in order when the user presses Ctrl-C (SIGINT) or the process is asked to terminate
/// (SIGTERM): throws Interrupted from the next step. While it lives, these signals do not end the
/// process.
class InterruptGuard final : public elsie::simulation::Observer {
 public:
  InterruptGuard();
  ~InterruptGuard() override;
  void stepped(const elsie::simulation::Simulation& simulation) override;
  /// Whether the work is to end.
  static bool is_interrupted();
};

/// The user ended the run.
class Interrupted {};
