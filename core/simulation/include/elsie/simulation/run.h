// A run whose caller makes the steps: Simulation::run() taken apart.
//
//   simulation::Run run(simulation, observers);
//   while (run.step()) look_at(simulation);
//   const simulation::RunResult result = run.end();
//
// It is the same run as that of Simulation::run(), with the world's own edits and rules, which
// Simulation::step() alone does not make. Between two steps the caller may edit the world.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "elsie/simulation/edit.h"
#include "elsie/simulation/observer.h"
#include "elsie/simulation/run_result.h"

namespace elsie::simulation {

class Simulation;

class Run {
 public:
  /// Makes the edits of time zero and calls Observer::started(). The arguments are those of
  /// Simulation::run(), and so are the errors; observers and simulation must outlive the run.
  explicit Run(Simulation& simulation, std::span<Observer* const> observers = {},
               std::span<const TimedEdit> edits = {},
               std::function<void(Simulation&)> before_control = {});
  /// Ends the run; errors of observers are lost.
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Makes a step, unless a goal or a limit has ended the run; returns whether it did. After an
  /// exception the run has ended, and every call throws that exception again.
  bool step();

  /// Calls Observer::ended(), once, and returns the result so far. Throws what an observer threw.
  RunResult end();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::simulation
