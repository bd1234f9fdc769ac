// The results of one experiment in one SQLite file; docs/results-database.md describes it.
//
// Only one process at a time writes it. The writer holds a lock file next to it; the lock ends with
// the process. Others may read meanwhile. Each run is written in one transaction: even if a process
// is killed, each run is either pending or complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/batch/job.h"
#include "elsie/batch/plan.h"
#include "elsie/results/database_file.h"

namespace elsie::batch {

using results::DatabaseError;
using results::DatabaseRefused;

/// Counts of a cell's runs by state.
struct CellCount {
  std::string label;
  std::int64_t pending = 0;
  std::int64_t done = 0;       // runs that ended without a failure
  std::int64_t successes = 0;  // those of them with the outcome "success"
  std::int64_t failed = 0;     // runs that ended as fault, crash, hang or error
};

/// The seeds, and those that are complete: ended in every cell. Repetitions do not count.
struct SeedCount {
  std::int64_t all = 0;
  std::int64_t complete = 0;
};

/// A run that failed.
struct FailedRun {
  std::int64_t id = 0;
  RunState state = RunState::error;
  std::string cell;
  std::uint64_t seed = 0;
  std::string message;
};

/// A seed with two different results in one cell.
struct Disagreement {
  std::string cell;
  std::uint64_t seed = 0;
  std::vector<std::int64_t> runs;
};

/// All data needed to repeat a run.
struct StoredRun {
  Job job;  // without data files and libraries
  struct Data {
    std::string name;  // name in the world's text
    std::string path;
    std::string sha256;
    std::string content;
  };
  std::vector<Data> data;
  struct Library {
    std::string path;
    std::string sha256;
    std::vector<std::string> plugins;  // "behavior wander 1.0"
  };
  std::vector<Library> libraries;  // of plugins, in the order in which to load them
  std::vector<Library> program;    // those of all cells when the batch began
  std::string elsie_version;
  std::string experiment;
  std::string cell;
  int repetition = 1;
  double wall_limit_s = 0.0;
  RunRecord record;  // only the columns of `runs`, and the measures, sorted by name
};

class ResultsDatabase {
 public:
  /// Creates the file and writes the plan. Throws DatabaseRefused if the file already exists or
  /// cannot be created, DatabaseError if it cannot be written.
  static ResultsDatabase create(const std::filesystem::path& file, Plan plan);
  /// Opens a database to continue its batch, and adds runs of the plan that are missing in it.
  /// Throws DatabaseRefused if it is not a results database, is being written by another process,
  /// is damaged, or belongs to another experiment or shard.
  static ResultsDatabase resume(const std::filesystem::path& file, Plan plan);
  /// The same, but the plan may have more seeds, repetitions, levels and worlds, whose runs are
  /// added in one transaction. Runs that exist keep their numbers. Throws DatabaseRefused when
  /// anything that exists is gone or differs.
  static ResultsDatabase extend(const std::filesystem::path& file, Plan plan);
  /// Opens a database to read it. Throws as results::open_to_read() does.
  static ResultsDatabase open(const std::filesystem::path& file);

  ResultsDatabase(ResultsDatabase&&) noexcept;
  ~ResultsDatabase();

  const std::filesystem::path& file() const;
  /// The plan with the numbers that its runs have here; empty after open().
  const Plan& plan() const;
  /// The number of runs, in all shards, that extend() has added to the experiment.
  std::int64_t added_runs() const;

  /// Numbers of the pending runs, ascending.
  std::vector<std::int64_t> pending();
  /// Throws DatabaseError if the file was removed, renamed or replaced since it was opened; what()
  /// says where the results are now, if they still exist.
  void require_in_place();
  /// Writes the result of a pending run, which is then no longer pending. Throws DatabaseError,
  /// also if the file was moved or removed (see require_in_place()).
  void write(std::int64_t run, const RunRecord& record);
  /// Makes failed runs pending again. Returns their number.
  std::int64_t redo_failed();

  /// In the order of the experiment's grid.
  std::vector<CellCount> cells();
  SeedCount seeds();
  std::vector<FailedRun> failed(std::size_t most);
  std::vector<Disagreement> disagreements();
  /// Returns none if there is no such run.
  std::optional<StoredRun> run(std::int64_t id);
  /// Returns a sentence that says why run() does not find this run: it does not exist, or it
  /// belongs to another shard.
  std::string why_no_run(std::int64_t id);

 private:
  class Impl;
  static ResultsDatabase continue_in(const std::filesystem::path& file, Plan plan, bool extend);
  explicit ResultsDatabase(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::batch
