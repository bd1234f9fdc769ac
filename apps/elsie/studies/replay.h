// The options of elsie replay, and what it does with recordings, a run, and many runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "environment.h"
#include "run_views.h"

namespace elsie::program {

struct ReplayOptions {
  PluginOptions plugins;
  std::string file;  // a recording or a database
  std::optional<std::int64_t> run;
  std::optional<std::string>
      where;           // experiment::parse_where(), with the levels of run_labels() too
  bool table = false;  // with `where`: a table next to each recording
  std::optional<std::size_t> workers;
  ViewOptions views;                   // with `where`: recordings, in at most one folder
  std::optional<std::string> world;    // file for the world with the run's edits
  std::optional<double> at;            // s, for the picture of a recording; none: at its end
  std::optional<double> wall_limit_s;  // 0: none; by default that of the batch, if it was exceeded
  bool quiet = false;
  bool json = false;  // of what is printed about a recording or a world
};

/// Prints the contents of a recording, draws it, writes its world, and returns the exit code.
/// Throws BadInput.
int replay_recording(const ReplayOptions& options);

/// Runs `run` of a database again, reports whether the result is the same, and returns the exit
/// code; with `world`, writes its world instead. Throws BadInput, PluginFault and all other errors
/// of a run.
int replay_run(const ReplayOptions& options);

/// Repeats each run of a database that matches `where` in a process of its own, says whether the
/// results are the same, and returns the exit code: that of the worst of them. Throws BadInput
/// before the first run.
int replay_runs(const ReplayOptions& options);

}  // namespace elsie::program
