// The plan of a batch, made before its first run: each cell of the experiment as the complete text
// of a world, each file with its hash, each run with its number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/experiment/experiment.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::batch {

/// A part of an experiment's runs, for several machines. Run i (from 1) belongs to shard ((i - 1)
/// mod of) + 1.
struct Shard {
  std::size_t index = 1;  // from 1 to `of`
  std::size_t of = 1;

  bool has(std::int64_t run) const { return static_cast<std::size_t>(run - 1) % of + 1 == index; }
  /// "2/5"
  std::string text() const;
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// Parses "K/N" with K from 1 to N, such as "2/5"; returns none for other texts.
std::optional<Shard> parse_shard(std::string_view text);

enum class FileKind { data, library, world };
const char* to_string(FileKind kind);

struct PlannedFile {
  FileKind kind = FileKind::data;
  std::string path;      // absolute
  std::string sha256;    // 64 hexadecimal digits
  std::string content;   // only for data files
  std::size_t rank = 0;  // for libraries: position in the order in which the host found them
};

struct PlannedPlugin {
  std::string kind;  // for example "behavior"
  std::string name;
  std::string version;
  std::optional<std::size_t> file;  // index into Plan::files; none if linked into the program
};

struct PlannedCell {
  std::string label;
  std::string world;       // id of the world in the experiment
  std::string world_text;  // with templates merged, settings made, all data files named
  std::string world_file;  // absolute
  std::string sha256;      // of world_text
  // Of each of Plan::factors, the label of the level, and its place among the factor's levels.
  std::vector<std::string> levels;
  std::vector<std::size_t> places;
  std::set<std::size_t> program;     // deciding_libraries(): indices into Plan::files
  std::vector<std::size_t> plugins;  // indices into Plan::plugins, ascending
  struct Data {
    std::string name;      // name of the file in world_text
    std::size_t file = 0;  // index into Plan::files
  };
  std::vector<Data> data;  // sorted by name
  bool goals = true;       // the world has goals
  std::size_t place = 0;   // in the order of the experiment's grid
  /// SHA-256 over everything that affects its results: levels, world, data, plugins, libraries.
  /// Layouts that follow the seeds of the runs are not included; see Layout.
  std::string identity;
  /// From which its layouts are drawn; none: it has none, or they follow the seeds of the runs.
  std::optional<std::uint64_t> layout_seed;
  struct Layout {
    std::string world_text;
    std::string sha256;  // of world_text
  };
  /// If they follow the seeds: the world of each seed; world_text is that of the first.
  std::map<std::uint64_t, Layout> layouts;
};

struct PlannedRun {
  std::int64_t id = 0;   // from 1; first in the order of cells, seeds, repetitions, see Stage
  std::size_t cell = 0;  // index into Plan::cells
  std::uint64_t seed = 0;
  int repetition = 1;
};

/// The experiment as it was begun, or as it was each time that its database was extended.
struct Stage {
  std::size_t cells = 0;             // the first ones of Plan::cells
  std::vector<std::uint64_t> seeds;  // in the order of the file
  int repeats = 1;
  std::int64_t runs = 0;    // of this stage and those before it
  std::string fingerprint;  // as Plan::fingerprint
};

struct Plan {
  std::string elsie_version;
  std::string abi;  // the ABI word that plugins must match
  std::string experiment;
  std::string description;
  std::string file;                  // the experiment file
  std::string text;                  // its text
  std::vector<std::string> factors;  // the first one is "world"
  std::vector<PlannedFile> files;    // libelsie before all others
  std::vector<PlannedPlugin> plugins;
  std::vector<PlannedCell> cells;
  std::vector<Stage> stages;     // at least one
  std::vector<PlannedRun> runs;  // runs of the shard, by id
  std::int64_t all_runs = 0;     // runs of the experiment
  Shard shard;
  double wall_limit_s = 600.0;
  double trajectory_period_s = 0.5;
  /// SHA-256 over everything that affects the results: worlds, data, plugins, libraries of the
  /// program, seeds. Paths of files and the shard are not included.
  std::string fingerprint;

  /// The libraries of the program that affect any of its cells: indices into `files`.
  std::set<std::size_t> program() const;
  /// The libraries of a cell's plugins, in the order in which the host found them.
  std::vector<std::string> libraries(const PlannedCell& cell) const;
};

struct PlanOptions {
  std::string elsie_version;
  std::string text;  // text of the experiment file
  /// Folders in which data files are searched for, after the folder of the world's file.
  std::vector<std::string> data_directories;
  Shard shard;
};

/// Reads the world of every cell. Throws world::WorldError if a world has errors, and
/// std::runtime_error with a sentence if a file cannot be read.
///
/// A world's own wall limit is ignored in a batch, because its effect would depend on the number of
/// runs that share the machine. The experiment's wall limit ends runs that take too long.
Plan make_plan(const experiment::Experiment& experiment, const plugin::Host& host,
               const PlanOptions& options);

/// These runs of the plan, named by their numbers, in the order in which they are done: all cells
/// with the first seed, then all with the second..., repetitions last. A batch that is stopped has
/// whole seeds. Throws std::out_of_range for a number that the plan does not have.
std::vector<PlannedRun> in_order(const Plan& plan, const std::vector<std::int64_t>& runs);

/// The libraries that affect the runs of a world, in addition to those of its plugins: first
/// libelsie, then what it and its plugins use: the base, inference, the world's engine and what
/// that links to; if a robot has a camera, libelsie-render, which takes the pictures, and
/// libelsie-vision, which processes them; the library of layouts if the world has some. Throws
/// plugin::PluginError if the engine cannot be loaded.
std::vector<std::filesystem::path> deciding_libraries(const world::World& world,
                                                      const plugin::Host& host);

/// Checks whether a cell's files have changed since the plan was made.
class FileCheck {
 public:
  explicit FileCheck(const Plan& plan);

  /// Returns the first file of this cell that was changed or removed; none if all are unchanged.
  /// Reads a file only if its size or time differs. Throws std::runtime_error with a sentence when
  /// a file that is there cannot be read.
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
  std::vector<Stamp> stamps_;  // parallel to Plan::files
};

}  // namespace elsie::batch
