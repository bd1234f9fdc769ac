// What a batch is going to do, settled before the first run begins: every cell of the experiment
// as the text of a world that needs nothing else, every file by its hash, every run by its number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/experiment/experiment.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::batch {

/// A part of an experiment's runs, for several machines: run i (from 1) is of shard
/// ((i - 1) mod of) + 1.
struct Shard {
  std::size_t index = 1;  // from 1 to `of`
  std::size_t of = 1;

  bool has(std::int64_t run) const { return static_cast<std::size_t>(run - 1) % of + 1 == index; }
  /// "2/5"
  std::string text() const;
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// "2/5" as a shard. None when it is none: K from 1 to N.
std::optional<Shard> parse_shard(std::string_view text);

enum class FileKind { data, library, world };
const char* to_string(FileKind kind);

struct PlannedFile {
  FileKind kind = FileKind::data;
  std::string path;      // absolute
  std::string sha256;    // 64 hexadecimal digits
  std::string content;   // of data files
  std::size_t rank = 0;  // of libraries: in which order the host found them
};

struct PlannedPlugin {
  std::string kind;  // "behavior"
  std::string name;
  std::string version;
  std::optional<std::size_t> file;  // place in Plan::files; none: linked into the program
};

struct PlannedLevel {
  std::size_t factor = 0;  // place in Plan::factors
  std::string label;
  std::size_t place = 0;  // among the factor's levels
};

struct PlannedCell {
  std::string label;
  std::string world;       // its id in the experiment
  std::string world_text;  // templates merged in, settings made, every data file named
  std::string world_file;  // absolute
  std::string sha256;      // of world_text
  std::vector<PlannedLevel> levels;
  std::vector<std::size_t> plugins;  // places in Plan::plugins, ascending
  struct Data {
    std::string name;      // what world_text calls it
    std::size_t file = 0;  // place in Plan::files
  };
  std::vector<Data> data;  // by name
  bool goals = true;       // the world has some
};

struct PlannedRun {
  std::int64_t id = 0;   // from 1, in the order of the grid: cell, seed, repetition
  std::size_t cell = 0;  // place in Plan::cells
  std::uint64_t seed = 0;
  int repetition = 1;
};

struct Plan {
  std::string elsie_version;
  std::string abi;  // the word that plugins must match
  std::string experiment;
  std::string description;
  std::string file;                  // of the experiment
  std::string text;                  // of that file
  std::vector<std::string> factors;  // the first one is "world"
  std::vector<PlannedFile> files;    // first those of the program, libelsie before all others
  std::size_t program_files = 0;     // how many of them: deciding_libraries()
  std::vector<PlannedPlugin> plugins;
  std::vector<PlannedCell> cells;
  std::vector<PlannedRun> runs;  // of the shard
  std::int64_t all_runs = 0;     // of the experiment
  Shard shard;
  double wall_limit_s = 600.0;
  double trajectory_period_s = 0.5;
  /// SHA-256 over everything that decides what comes out of the runs: worlds, data, plugins,
  /// the program's libraries, seeds. Where the files are has no part in it, nor has the shard.
  std::string fingerprint;

  /// The libraries that a cell's plugins come from, in the order in which the host found them.
  std::vector<std::string> libraries(const PlannedCell& cell) const;
};

struct PlanOptions {
  std::string elsie_version;
  std::string text;  // of the experiment file
  /// Where data files are looked for when they are not beside the world's file.
  std::vector<std::string> data_directories;
  Shard shard;
};

/// Reads the world of every cell. Throws world::WorldError when one of them is wrong, and
/// std::runtime_error with a sentence when a file cannot be read.
///
/// A world's own limit of time on the clock does not count in a batch: what it ends would depend on
/// how many runs share the machine. The experiment's wall limit ends a run that takes too long.
Plan make_plan(const experiment::Experiment& experiment, const plugin::Host& host,
               const PlanOptions& options);

/// The libraries that decide the result of a run, besides those of its plugins: libelsie, which is
/// the first, and those that it and its plugins compute with (the base, inference, the views, which
/// take the pictures of cameras, and ODE).
std::vector<std::filesystem::path> deciding_libraries();

/// Looks whether a cell's files are still what they were when the plan was made.
class FileCheck {
 public:
  explicit FileCheck(const Plan& plan);

  /// The first file of this cell that has changed or gone; none: all are as they were. Reads a file
  /// only when its size or time differs.
  std::optional<std::string> changed(std::size_t cell);

 private:
  struct Stamp {
    std::int64_t size = -1;
    std::int64_t time_ns = 0;
    std::uint64_t inode = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  static Stamp stamp_of(const std::string& path);
  bool is_changed(std::size_t file);

  const Plan& plan_;
  std::vector<Stamp> stamps_;  // of Plan::files
};

}  // namespace elsie::batch
