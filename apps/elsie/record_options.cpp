#include "record_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "elsie/recording/formats.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "image_saver.h"

namespace elsie::program {

namespace {

/// A device has no suffix; it gets the first format.
const recording::Format& format_of(const std::string& file) {
  const recording::Format* format = recording::format_of(file);
  return format ? *format : recording::formats().front();
}

}  // namespace

void RecordOptions::add_to(CLI::App& command) {
  std::string help = "Record poses, commands, readings and every coordinator's decisions;";
  for (const recording::Format& format : recording::formats()) {
    help += " " + std::string(format.suffix) + ": " + std::string(format.description) + ";";
  }
  command.add_option("--record", files, help + " may be repeated")
      ->type_name("FILE" + recording::suffixes("|FILE"))
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
}

void RecordOptions::check() const {
  for (std::size_t i = 0; i < files.size(); ++i) {
    require_recording(files[i], "--record");
    if (std::find(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(i), files[i]) !=
        files.begin() + static_cast<std::ptrdiff_t>(i)) {
      throw BadInput("--record: '" + files[i] + "' is given twice");
    }
  }
  const auto takes_images = [](const std::string& file) { return format_of(file).images; };
  if (images && std::none_of(files.begin(), files.end(), takes_images)) {
    throw BadInput("--record-images: " + std::string(format_of(files.front()).description) +
                   " has no place for pictures; expected --record FILE" +
                   recording::suffixes(" or FILE", true));
  }
}

void RecordOptions::check(const simulation::Simulation& simulation) const {
  if (images) {
    require_cameras(simulation, "--record-images");
  }
}

std::vector<std::unique_ptr<simulation::Observer>> RecordOptions::recorders() const {
  std::vector<std::unique_ptr<simulation::Observer>> all;
  for (const std::string& file : files) {
    all.push_back(format_of(file).recorder(file, {rate_hz, images, times, "elsie " ELSIE_VERSION}));
  }
  return all;
}

}  // namespace elsie::program
