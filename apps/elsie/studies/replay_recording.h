// Shows a recording of a run.
#pragma once

#include <optional>
#include <string>

#include "environment.h"

namespace elsie::program {

/// The options of `elsie replay` for a recording.
struct RecordingOptions {
  std::string recording;
  std::optional<std::string> picture;
  std::optional<std::string> world;  // file for the world with the run's edits
  std::optional<double> at;          // s; none: at the end
  int width = 1000;                  // of the picture, pixels
  bool json = false;
  PluginOptions plugins;  // for drawing and checking the world
};

/// Prints its contents, draws it, and returns the exit code. Throws BadInput.
int replay_recording(const RecordingOptions& options);

}  // namespace elsie::program
