// Reading an experiment file: XML in, a checked experiment out.
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

/// An experiment has at most this many runs, and this many cells: each of these is read before the
/// first run begins.
inline constexpr std::uint64_t kMostRuns = 10'000'000;
inline constexpr std::uint64_t kMostCells = 100'000;
/// A factor has at most this many levels.
inline constexpr std::size_t kMostLevels = 10'000;

struct ReadOptions {
  /// Where worlds, and what they name, are looked for when they are not beside the file that names
  /// them.
  std::vector<std::string> data_directories;
  /// Hears after each cell how many were read, and how many there are: reading 10,000 takes
  /// seconds.
  std::function<void(std::size_t read, std::size_t all)> progress;
};

/// Reads an experiment file and makes sure that it can be run: every cell's world is read with what
/// is set in it, and put together once, so that nothing of an experiment begins when one of its
/// cells is wrong. Throws world::WorldError with all the problems of the file; what is wrong with a
/// setting is told where the experiment file sets it, what is wrong in a world where the world says
/// it, and in which cells.
Experiment read_experiment(const std::string& file, const plugin::Host& host,
                           const ReadOptions& options = {});

/// The same for text that is in memory; `file` is what it is called in messages, and its folder is
/// where worlds are looked for first.
Experiment parse_experiment(std::string_view text, const std::string& file,
                            const plugin::Host& host, const ReadOptions& options = {});

/// What an experiment asks, for those who have its runs already: the same without a look at its
/// worlds, which need not be there, nor need the plugins that settings name. WorldUse::file is
/// empty. Throws as parse_experiment() does, but for mistakes that only worlds would show.
Experiment parse_outline(std::string_view text, const std::string& file);

/// The world of a cell, with all that is set in it. Throws world::WorldError, for the files may
/// have changed since the experiment was read.
world::World read_cell(const Experiment& experiment, const Cell& cell, const plugin::Host& host,
                       const ReadOptions& options = {});

}  // namespace elsie::experiment
