// Observing a simulation without changing it.
#pragma once

namespace elsie::simulation {

class Simulation;

/// Called by Simulation::run(). An observer sees a const simulation: the run is the same with and
/// without observers, bit for bit. An exception of an observer ends the run.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Called after the reset and the changes at time zero, before the first step.
  virtual void started(const Simulation&) {}
  /// Called after every step.
  virtual void stepped(const Simulation&) {}
  /// Called between two steps after plugins were replaced, or after an edit made a new world:
  /// sensors may list other numbers, and robots, behaviours and obstacles may have changed.
  virtual void replaced(const Simulation&) {}
  /// Called after the last step; when a plugin or an observer threw, in the handler of that.
  virtual void ended(const Simulation&) {}
};

}  // namespace elsie::simulation
