// Requests to end the program: Ctrl-C (SIGINT), SIGTERM, and a closed terminal (SIGHUP).
#pragma once

#include <array>
#include <csignal>

#include "elsie/simulation/observer.h"

namespace elsie::program {

/// From now on these signals end the program with exit code 4 and the name of the plugin at work,
/// if there is one: there is nothing to save while worlds are read and plugins made, or after a
/// run. Ignored signals stay ignored.
void end_at_once_when_interrupted();

/// While it lives, the first signal only makes a note: a run ends in order, by Interrupted from its
/// next step; work that waits for other processes sees a descriptor become readable. A signal that
/// comes at least half a second later ends the process at once, with a report of the plugin at
/// work, even if the object has been destroyed since the first one. Only one at a time.
class InterruptGuard final : public simulation::Observer {
 public:
  /// Throws std::runtime_error when there are no more descriptors.
  InterruptGuard();
  ~InterruptGuard() override;
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  void stepped(const simulation::Simulation& simulation) override;
  int descriptor() const { return ends_[0]; }
  /// True if a signal has come.
  static bool is_interrupted();

 private:
  std::array<int, 2> ends_;
  std::array<struct sigaction, 3> before_;
};

/// Thrown when the user ended the run.
class Interrupted {};

}  // namespace elsie::program
