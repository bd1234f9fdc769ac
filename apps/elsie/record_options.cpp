#include "record_options.h"

#include <filesystem>

#include <CLI/CLI.hpp>

#include "elsie/recording/csv_recorder.h"
#include "elsie/recording/mcap_recorder.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "image_saver.h"

namespace elsie::program {

namespace {

bool is_mcap(const std::filesystem::path& recording) { return recording.extension() == ".mcap"; }

}  // namespace

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

void RecordOptions::check() const {
  if (file) {
    require_recording(*file, "--record");
  }
  if (images && !is_mcap(*file)) {
    throw BadInput(
        "--record-images: a table has no place for pictures; expected --record FILE.mcap");
  }
}

void RecordOptions::check(const simulation::Simulation& simulation) const {
  if (images) {
    require_cameras(simulation, "--record-images");
  }
}

std::unique_ptr<simulation::Observer> RecordOptions::recorder() const {
  if (!file) {
    return nullptr;
  }
  if (is_mcap(*file)) {
    return std::make_unique<recording::McapRecorder>(
        *file, recording::McapOptions{rate_hz, images, times, "elsie " ELSIE_VERSION});
  }
  return std::make_unique<recording::CsvRecorder>(*file, rate_hz, times);
}

}  // namespace elsie::program
