// What --record and its like ask for.
#pragma once

#include <string>
#include <vector>

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
};

}  // namespace elsie::program
