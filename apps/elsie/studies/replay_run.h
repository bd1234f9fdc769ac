// Repeats a run of a database.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "environment.h"
#include "run_views.h"

namespace elsie::program {

/// The options of `elsie replay` for a run of a database.
struct RunAgainOptions {
  PluginOptions plugins;
  std::string database;
  std::int64_t run = 0;
  ViewOptions views;
  std::optional<std::string> world;    // file for the world; then the run is not repeated
  std::optional<double> wall_limit_s;  // 0: none; by default that of the batch, if it was exceeded
  bool quiet = false;
  bool json = false;  // of what is printed about the world
};

/// Runs it again, reports whether the result is the same, and returns the exit code. Throws
/// BadInput, PluginFault and all other errors of a run.
int replay_run(const RunAgainOptions& options);

}  // namespace elsie::program
