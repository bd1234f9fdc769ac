// Repeats a run of a database.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "environment.h"
#include "record_options.h"

namespace elsie::program {

/// The options of `elsie replay` for a run of a database.
struct RunAgainOptions {
  PluginOptions plugins;
  std::string database;
  std::int64_t run = 0;
  RecordOptions record;
  std::optional<std::string> explain;
  std::optional<std::string> picture;
  int width = 1000;                    // of the picture, pixels
  std::optional<double> wall_limit_s;  // 0: none; by default the batch's limit, if the run met it
  bool quiet = false;
};

/// Repeats the run, prints whether the result is the same, and returns the exit code. Throws
/// BadInput, PluginFault and other errors of runs.
int replay_run(const RunAgainOptions& options);

}  // namespace elsie::program
