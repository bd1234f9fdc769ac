#include "record_options.h"

#include <CLI/CLI.hpp>

#include "arguments.h"

namespace elsie::program {

void RecordOptions::add_to(CLI::App& command) {
  command
      .add_option(
          "--record", files,
          "Record poses, commands, readings and every coordinator's decisions; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--record-rate", rate_hz, "Samples per simulated second and robot")
      ->needs("--record")
      ->check(positive_number())
      ->capture_default_str();
  command
      .add_flag("--record-times", times,
                "Record how long each behaviour takes, too (differs from run to run)")
      ->needs("--record");
  command.add_flag("--record-images", images, "Record what the cameras see, too; not in a table")
      ->needs("--record");
  command
      .add_option(
          "--record-robots", robots,
          "Record these robots in full: ids, separated by commas. Of the others record only "
          "the poses, and nothing in a table. Default: all, in a recording for viewers the "
          "first 1000")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->needs("--record")
      ->type_name("IDS");
}

}  // namespace elsie::program
