// Watching a simulation without touching it.
#pragma once

namespace elsie::simulation {

class Simulation;

/// Called by Simulation::run(). An observer sees a const simulation: whether one watches or not,
/// the run is the same, bit for bit. What an observer throws ends the run.
class Observer {
 public:
  virtual ~Observer() = default;
  /// After the reset and the changes for time zero, before the first step.
  virtual void started(const Simulation&) {}
  /// After every step.
  virtual void stepped(const Simulation&) {}
  /// Between two steps, when plugins were replaced or the world became another one by an edit:
  /// sensors may list other numbers than before, and robots, behaviours and boxes may be others.
  virtual void replaced(const Simulation&) {}
  /// After the last step; also when a plugin failed or an observer threw.
  virtual void ended(const Simulation&) {}
};

}  // namespace elsie::simulation
