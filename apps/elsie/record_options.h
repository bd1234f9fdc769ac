// The options for recordings: --record and related ones.
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
  bool times = false;     // the time that each behaviour took; the simulation measures it
  bool images = false;    // the pictures of the cameras
  std::vector<std::string> robots{};  // ids; empty: see recording::RecorderOptions

  void add_to(CLI::App& command);
};

}  // namespace elsie::program
