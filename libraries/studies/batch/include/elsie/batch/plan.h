// The plan of a batch, made before its first run: each cell of the experiment as the complete text
// of a world, each file with its hash, each run with its number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
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

/// Reads "2/5", K/N with K from 1 to N; none for other texts.
std::optional<Shard> parse_shard(std::string_view text);

enum class FileKind { data, library, world };
const char* to_string(FileKind kind);

struct PlannedFile {
  FileKind kind = FileKind::data;
  std::string path;      // absolute
  std::string sha256;    // 64 hexadecimal digits
  std::string content;   // only of data files
  std::size_t rank = 0;  // of libraries: position in the order in which the host found them
};

struct PlannedPlugin {
  std::string kind;  // for example "behavior"
  std::string name;
  std::string version;
  std::optional<std::size_t> file;  // index into Plan::files; none: linked into the program
};

struct PlannedLevel {
  std::size_t factor = 0;  // index into Plan::factors
  std::string label;
  std::size_t place = 0;  // index into the factor's levels
};

struct PlannedCell {
  std::string label;
  std::string world;       // id of the world in the experiment
  std::string world_text;  // templates merged, settings made, every data file named
  std::string world_file;  // absolute
  std::string sha256;      // of world_text
  std::vector<PlannedLevel> levels;
  std::vector<std::size_t> plugins;  // indices into Plan::plugins, ascending
  struct Data {
    std::string name;      // name of the file in world_text
    std::size_t file = 0;  // index into Plan::files
  };
  std::vector<Data> data;  // sorted by name
  bool goals = true;       // the world has goals
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
  std::int64_t id = 0;   // from 1, in the order of cells, seeds, repetitions
  std::size_t cell = 0;  // index into Plan::cells
  std::uint64_t seed = 0;
  int repetition = 1;
};

struct Plan {
  std::string elsie_version;
  std::string abi;  // the ABI word that plugins must match
  std::string experiment;
  std::string description;
  std::string file;                  // the experiment file
  std::string text;                  // its text
  std::vector<std::string> factors;  // the first one is "world"
  std::vector<PlannedFile> files;    // first those of the program, libelsie before all others
  std::size_t program_files = 0;     // how many of them: deciding_libraries()
  std::vector<PlannedPlugin> plugins;
  std::vector<PlannedCell> cells;
  std::vector<PlannedRun> runs;  // runs of the shard
  std::int64_t all_runs = 0;     // runs of the experiment
  Shard shard;
  double wall_limit_s = 600.0;
  double trajectory_period_s = 0.5;
  /// SHA-256 over everything that decides the results: worlds, data, plugins, the program's
  /// libraries, seeds. Paths of files and the shard are left out.
  std::string fingerprint;

  /// The libraries of a cell's plugins, in the order in which the host found them.
  std::vector<std::string> libraries(const PlannedCell& cell) const;
};

struct PlanOptions {
  std::string elsie_version;
  std::string text;  // text of the experiment file
  /// Where data files are searched for after the folder of the world's file.
  std::vector<std::string> data_directories;
  Shard shard;
};

/// Reads the world of every cell. Throws world::WorldError when a world is wrong, and
/// std::runtime_error with a sentence when a file cannot be read.
///
/// A world's own wall limit is ignored in a batch: where it ends a run would depend on the number
/// of runs that share the machine. The experiment's wall limit ends runs that take too long.
Plan make_plan(const experiment::Experiment& experiment, const plugin::Host& host,
               const PlanOptions& options);

/// The libraries that decide the result of a run, besides those of its plugins: libelsie, which is
/// the first, and those that it and its plugins compute with (the base, inference, the views, which
/// take the pictures of cameras, libelsie-vision, which works on them, the engines, and ODE).
std::vector<std::filesystem::path> deciding_libraries();

/// Looks whether a cell's files are still what they were when the plan was made.
class FileCheck {
 public:
  explicit FileCheck(const Plan& plan);

  /// The first file of this cell that was changed or removed; none: all are unchanged. Reads a file
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
  std::vector<Stamp> stamps_;  // parallel to Plan::files
};

}  // namespace elsie::batch
