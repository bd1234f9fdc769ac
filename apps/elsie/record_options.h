// What --record and its like ask for.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "elsie/simulation/simulation.h"

namespace CLI {
class App;
}

namespace elsie::program {

/// The options of every subcommand that runs one world.
struct RecordOptions {
  std::optional<std::string> file;  // .csv or .mcap
  double rate_hz = 10.0;            // samples per simulated second
  bool times = false;               // how long each behaviour took; the simulation measures it
  bool images = false;              // what the cameras see

  void add_to(CLI::App& command);
  /// Before any work is done. Throws BadInput.
  void check() const;
  /// Whether the world has what is to be recorded. Throws BadInput.
  void check(const simulation::Simulation& simulation) const;
  /// Writes the file, which is created at once; none when none was asked for.
  std::unique_ptr<simulation::Observer> recorder() const;
};

}  // namespace elsie::program
