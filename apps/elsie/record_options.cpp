#include "record_options.h"

#include <CLI/CLI.hpp>

#include "arguments.h"

namespace elsie::program {

void RecordOptions::add_to(CLI::App& command) {
  command
      .add_option("--record", file,
                  "Write poses, commands, readings and the coordinators' traces as a table, or as "
                  "an MCAP file for viewers and `elsie replay`")
      ->type_name("FILE.csv|FILE.mcap");
  command.add_option("--record-rate", rate_hz, "Samples per simulated second and robot")
      ->needs("--record")
      ->check(positive_number())
      ->capture_default_str();
  command
      .add_flag("--record-times", times,
                "Record how long each behaviour takes, too (differs from run to run)")
      ->needs("--record");
  command.add_flag("--record-images", images, "Record what the cameras see, too, in an MCAP file")
      ->needs("--record");
}

}  // namespace elsie::program
