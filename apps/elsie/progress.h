// A progress bar for a run, on a terminal.
#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <string>

#include "elsie/simulation/observer.h"

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
  std::chrono::steady_clock::time_point last_drawn_;
};

/// Draws "[=====>    ]  42 %  of 40000 cells checked" on standard error while an experiment is
/// read, if that is a terminal and reading takes a while; removes it at the end.
class CheckProgress {
 public:
  /// `shown`: false draws nothing.
  explicit CheckProgress(bool shown);
  ~CheckProgress();
  CheckProgress(const CheckProgress&) = delete;
  CheckProgress& operator=(const CheckProgress&) = delete;

  void draw(std::size_t checked, std::size_t all);

 private:
  bool shown_;
  std::chrono::steady_clock::time_point last_drawn_;
};

/// From now on Ctrl-C (SIGINT), a request to terminate (SIGTERM) and a closed terminal (SIGHUP) end
/// the program with exit code 4 and the name of the plugin at work, if there is one: there is
/// nothing to save while worlds are read and plugins made, or after a run. Ignored signals stay
/// ignored.
void end_at_once_when_interrupted();

/// Ends the run in order on these signals: throws Interrupted from the next step. While it lives,
/// the first signal does not end the process; one that comes at least half a second later ends it
/// at once, with a report of the plugin at work.
class InterruptGuard final : public simulation::Observer {
 public:
  InterruptGuard();
  ~InterruptGuard() override;
  void stepped(const simulation::Simulation& simulation) override;
  /// True if a signal has come.
  static bool is_interrupted();

 private:
  std::array<struct sigaction, 3> before_;
};

/// Thrown when the user ended the run.
class Interrupted {};

}  // namespace elsie::program
