// Reads an experiment file and returns a checked experiment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/experiment/experiment.h"
#include "elsie/world/error.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::experiment {

/// The largest numbers of runs and of cells of an experiment: each cell is read before the first
/// run begins.
inline constexpr std::uint64_t kMostRuns = 10'000'000;
inline constexpr std::uint64_t kMostCells = 100'000;
/// The largest number of worlds whose layouts follow the seeds of their runs: each is drawn before
/// the first run begins.
inline constexpr std::uint64_t kMostLayouts = 100'000;
/// The largest number of levels of a factor.
inline constexpr std::size_t kMostLevels = 10'000;

struct ReadOptions {
  /// Folders in which worlds, and the files that they name, are searched for, after the folder of
  /// the file that names them.
  std::vector<std::string> data_directories;
  /// Called after each cell with the number of cells read and of all cells, because reading 10,000
  /// cells takes seconds.
  std::function<void(std::size_t read, std::size_t all)> progress;
};

/// Reads an experiment file and checks that it can be run: every cell's world is read with its
/// settings and built once, so that no run begins if one cell has an error. Throws
/// world::WorldError with all problems of the file. A problem with a setting has the line of the
/// setting; a problem in a world has the line of the world's file and the affected cells.
Experiment read_experiment(const std::string& file, const plugin::Host& host,
                           const ReadOptions& options = {});

/// The same for text in memory; `file` is its name in messages, and worlds are first searched for
/// in its folder.
Experiment parse_experiment(std::string_view text, const std::string& file,
                            const plugin::Host& host, const ReadOptions& options = {});

/// Reads an experiment whose runs are already done, without its worlds and without the plugins in
/// its settings. WorldUse::file is empty. Throws like parse_experiment(), except for errors that
/// are found only with the worlds.
Experiment parse_outline(std::string_view text, const std::string& file);

/// Returns the world of a cell with all its settings and with the layouts of a run with this seed.
/// Throws world::WorldError if it has errors, because files may have changed since the experiment
/// was read.
world::World read_cell(const Experiment& experiment, const Cell& cell, const plugin::Host& host,
                       const ReadOptions& options = {}, std::uint64_t seed = 1);

}  // namespace elsie::experiment
