// A progress bar for a run, on a terminal.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string>

#include "elsie/simulation/observer.h"

namespace elsie::program {

/// "[=====>    ]  42 %": how much of something is done, from 0 to 1.
std::string bar_text(double part);

/// Draws "[=====>    ]  42 %  252.0 s  31 x real time" on standard error while a run goes on, and
/// wipes it at the end.
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
/// read, if that is a terminal and takes a while; wipes it at the end.
class CheckProgress {
 public:
  /// `shown`: false: nothing is drawn at all.
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
/// the program with exit code 4 and a word on the plugin that was at work, if one was: while worlds
/// are read and plugins made, and when a run is over, there is nothing to be kept. Signals that are
/// ignored stay so.
void end_at_once_when_interrupted();

/// Ends the run in order on these signals: throws Interrupted from the next step. While it lives,
/// the first of them does not end the process; one that comes half a second later or more does at
/// once, with a report of what was at work.
class InterruptGuard final : public simulation::Observer {
 public:
  InterruptGuard();
  ~InterruptGuard() override;
  void stepped(const simulation::Simulation& simulation) override;
  /// Whether the work is to end.
  static bool is_interrupted();

 private:
  /// A plugin may have blocked them.
  void let_signals_in();

  std::array<void (*)(int), 3> before_;
  bool has_warned_ = false;
};

/// The user ended the run.
class Interrupted {};

}  // namespace elsie::program
