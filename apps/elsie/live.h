// A run that somebody watches and works on: at the pace of the clock, with plugins that are
// replaced when they change on disk.
#pragma once

#include <chrono>

#include "elsie/build/watch.h"
#include "elsie/simulation/observer.h"

namespace elsie::simulation {
class Simulation;
}

namespace elsie::program {

/// Makes the run wait for the clock: so many simulated seconds a second, at most.
class Pacer final : public simulation::Observer {
 public:
  explicit Pacer(double speed) : speed_(speed) {}

  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;

 private:
  double speed_;
  std::chrono::steady_clock::time_point start_;
};

/// Puts what has changed on disk into the simulation, and tells the user of it on standard error:
/// of what is new unless `quiet`, of what cannot be used in any case. In that case the old plugins
/// go on. Costs nothing while nothing has changed.
void replace_what_changed(build::Watch& watch, simulation::Simulation& simulation, bool quiet);

}  // namespace elsie::program
