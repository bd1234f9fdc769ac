// Runs that a user watches and works on: at the pace of the clock, with plugins that are replaced
// when they change on disk.
#pragma once

#include <chrono>

#include "elsie/build/watch.h"
#include "elsie/simulation/observer.h"

namespace elsie::simulation {
class Simulation;
}

namespace elsie::program {

/// Slows the run down to a number of simulated seconds per second.
class Pacer final : public simulation::Observer {
 public:
  explicit Pacer(double speed) : speed_(speed) {}

  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;

 private:
  double speed_;
  std::chrono::steady_clock::time_point start_;
};

/// Replaces changed plugins in the simulation and reports it on standard error: new ones unless
/// `quiet`, and always those that cannot be used, whose old versions stay in use. Costs nothing
/// while nothing has changed.
void replace_what_changed(build::Watch& watch, simulation::Simulation& simulation, bool quiet);

}  // namespace elsie::program
