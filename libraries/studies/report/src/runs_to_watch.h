// Which runs the page plays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "elsie/report/findings.h"

namespace elsie::report {

/// A page plays no more runs, and no more of one cell that had no success: they are often alike.
inline constexpr std::size_t kMostWatched = 12;
inline constexpr std::size_t kMostOfCell = 3;

struct WatchedRun {
  std::size_t run = 0;  // index into Results::runs
  bool is_typical = false;
};

struct RunsToWatch {
  std::vector<WatchedRun> runs;  // by cell: the typical one, then those without success
  std::size_t typical = 0;       // of them
  std::size_t unsuccessful = 0;  // of them, whether typical or not
  /// Of how many: cells with a typical run, and runs without success.
  std::size_t all_typical = 0;
  std::size_t all_unsuccessful = 0;
  std::vector<std::size_t> untold;  // they would count, but have no trajectory: indices
};

/// Of each of these cells its typical_run(), and runs without success: the first of each cell in
/// the order of the seeds, then the second of each, then the third. If there are too many, at least
/// half are typical ones, of cells that are chosen evenly. `stored`: the ids of the runs that have
/// trajectories, ascending.
RunsToWatch runs_to_watch(const Findings& findings, const std::vector<std::size_t>& cells,
                          const std::vector<std::int64_t>& stored);

}  // namespace elsie::report
