// Reads an experiment file: XML in, a checked experiment out.
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

/// The most runs that an experiment has, and below the most cells: each cell is read before the
/// first run begins.
inline constexpr std::uint64_t kMostRuns = 10'000'000;
inline constexpr std::uint64_t kMostCells = 100'000;
/// The most worlds whose layouts follow the seeds of their runs: each is drawn before the first run
/// begins.
inline constexpr std::uint64_t kMostLayouts = 100'000;
/// The most levels of a factor.
inline constexpr std::size_t kMostLevels = 10'000;

struct ReadOptions {
  /// Where worlds, and the files that they name, are searched for after the folder of the file that
  /// names them.
  std::vector<std::string> data_directories;
  /// Called after each cell with the numbers of cells read and of all cells: reading 10,000 takes
  /// seconds.
  std::function<void(std::size_t read, std::size_t all)> progress;
};

/// Reads an experiment file and checks that it can be run: every cell's world is read with its
/// settings and put together once, so that nothing is run when one cell is wrong. Throws
/// world::WorldError with all problems of the file. Problems with a setting have the line of the
/// setting, problems in a world have the line of the world's file, and the cells that have them.
Experiment read_experiment(const std::string& file, const plugin::Host& host,
                           const ReadOptions& options = {});

/// The same for a text in memory; `file` is its name in messages, and worlds are searched for in
/// its folder first.
Experiment parse_experiment(std::string_view text, const std::string& file,
                            const plugin::Host& host, const ReadOptions& options = {});

/// Reads an experiment whose runs are done already, without its worlds and without the plugins that
/// its settings name. WorldUse::file is empty. Throws as parse_experiment() does, except for
/// mistakes that only worlds would show.
Experiment parse_outline(std::string_view text, const std::string& file);

/// The world of a cell with all its settings, with the layouts of a run with this seed. Throws
/// world::WorldError, because files may have changed since the experiment was read.
world::World read_cell(const Experiment& experiment, const Cell& cell, const plugin::Host& host,
                       const ReadOptions& options = {}, std::uint64_t seed = 1);

}  // namespace elsie::experiment
