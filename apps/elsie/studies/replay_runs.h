// Repeats many runs of a database, and records them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "environment.h"
#include "record_options.h"

namespace elsie::program {

/// The options of `elsie replay --where`.
struct RunsAgainOptions {
  PluginOptions plugins;
  std::string database;
  std::string where;     // experiment::parse_where(), with the levels of run_labels() too
  RecordOptions record;  // at most one name, that of a folder
  bool table = false;    // a table next to each recording
  std::optional<std::size_t> workers;
  std::optional<double> wall_limit_s;
  bool quiet = false;
};

/// Repeats each run that matches in a process of its own, says whether the results are the same,
/// and returns the exit code: that of the worst of them. Throws BadInput before the first run.
int replay_runs(const RunsAgainOptions& options);

}  // namespace elsie::program
