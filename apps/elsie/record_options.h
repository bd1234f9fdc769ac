// What --record and its like ask for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/simulation/simulation.h"

namespace CLI {
class App;
}

namespace elsie::program {

/// The options of every subcommand that runs one world.
struct RecordOptions {
  std::vector<std::string> files;
  double rate_hz = 10.0;  // samples per simulated second
  bool times = false;     // how long each behaviour took; the simulation measures it
  bool images = false;    // what the cameras see

  void add_to(CLI::App& command);
  /// Before any work is done. Throws BadInput.
  void check() const;
  /// Whether the world has what is to be recorded. Throws BadInput.
  void check(const simulation::Simulation& simulation) const;
  /// The recorders, one for each file. They create their files at once.
  std::vector<std::unique_ptr<simulation::Observer>> recorders() const;
};

}  // namespace elsie::program
