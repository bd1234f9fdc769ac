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
  std::optional<std::string> world;    // file for the world; the run is not made again then
  std::optional<double> wall_limit_s;  // 0: none; by default that of the batch, if it was met
  bool quiet = false;
};

/// Runs it again, says whether the result is the same, and returns the exit code. Throws BadInput,
/// PluginFault and what else may go wrong in a run.
int replay_run(const RunAgainOptions& options);

}  // namespace elsie::program
