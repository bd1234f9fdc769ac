// The results of one experiment in one SQLite file; docs/results-database.md describes it.
//
// One process writes it at a time: it holds a lock, beside the file, that goes when the process
// does. Others may read while it writes. A run is written in one transaction: whatever is killed
// when, a run is either pending or complete.
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

/// How far a cell has come.
struct CellCount {
  std::string label;
  std::int64_t pending = 0;
  std::int64_t done = 0;       // of these ended by themselves
  std::int64_t successes = 0;  // of those that are done
  std::int64_t failed = 0;     // fault, crash, hang, error
};

/// A run that did not end by itself.
struct FailedRun {
  std::int64_t id = 0;
  RunState state = RunState::error;
  std::string cell;
  std::uint64_t seed = 0;
  std::string message;
};

/// A seed that gave two different runs of one cell.
struct Disagreement {
  std::string cell;
  std::uint64_t seed = 0;
  std::vector<std::int64_t> runs;
};

/// All that it takes to do a run again.
struct StoredRun {
  Job job;  // without data files and libraries
  struct Data {
    std::string name;  // what the world's text calls it
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
  std::vector<Library> libraries;  // of plugins; in the order in which they are to be loaded
  std::vector<Library> program;    // deciding_libraries() when the batch began
  std::string elsie_version;
  std::string experiment;
  std::string cell;
  int repetition = 1;
  double wall_limit_s = 0.0;
  RunRecord record;  // only what stands in `runs`, and the measures, by name
};

class ResultsDatabase {
 public:
  /// Makes the file, and writes the plan. Throws DatabaseRefused when there is one already or it
  /// cannot be made, DatabaseError when it cannot be written.
  static ResultsDatabase create(const std::filesystem::path& file, const Plan& plan);
  /// Opens one to go on with it. Throws DatabaseRefused when it is no results database, is being
  /// written by another process, is damaged, or is of another experiment or shard. Runs of the plan
  /// that are not in it are added.
  static ResultsDatabase resume(const std::filesystem::path& file, const Plan& plan);
  /// Opens one to read it. Throws as results::open_to_read() does.
  static ResultsDatabase open(const std::filesystem::path& file);

  ResultsDatabase(ResultsDatabase&&) noexcept;
  ~ResultsDatabase();

  const std::filesystem::path& file() const;

  /// The runs to be done, in order.
  std::vector<std::int64_t> pending();
  /// Throws DatabaseError when the file was removed, renamed or replaced since it was opened;
  /// what() says where the results are, if they are anywhere.
  void require_in_place();
  /// What became of a pending run, which is pending no more. Throws DatabaseError, also when the
  /// file is not in its place any more.
  void write(std::int64_t run, const RunRecord& record);
  /// Makes pending again what did not end by itself. Returns how many there were.
  std::int64_t redo_failed();

  std::vector<CellCount> cells();
  std::vector<FailedRun> failed(std::size_t most);
  std::vector<Disagreement> disagreements();
  /// None: there is no such run.
  std::optional<StoredRun> run(std::int64_t id);
  /// Why run() gives none for a number, as a sentence: there is no such run, or another shard has
  /// it.
  std::string why_no_run(std::int64_t id);

 private:
  class Impl;
  explicit ResultsDatabase(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::batch
