// The files that machines share in a batch on a cluster. They are in a folder next to the database
// of results, of the same name followed by "-shards":
//
//   cluster.json       number of shards and fingerprint of the experiment
//   job.sh             script of a task of the job array
//   shard-K.sqlite     results of a shard
//   shard-K.json       counts of its runs
//   shard-K.log        output of its task
//   turn               lock of the commands that follow the batch
//
// No other process opens a shard's database while its task is running, because SQLite's write-ahead
// log does not work across machines (https://sqlite.org/wal.html).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "elsie/batch/plan.h"

namespace elsie::cluster {

/// Counts of the runs of a shard, or of all shards.
struct Count {
  std::int64_t runs = 0;
  std::int64_t ended = 0;
  std::int64_t failed = 0;  // runs that ended with a failure
};

/// Writes the counts of a shard in one piece: other processes see the old file or the new one.
/// Throws std::runtime_error with a sentence.
void write_count(const std::filesystem::path& file, const Count& count);

class ShardFolder {
 public:
  /// A lock for commands that follow the same batch: only one of them submits tasks or merges the
  /// databases, while the others wait. The object holds it until its destruction. Throws
  /// std::runtime_error with a sentence if the folder's file system does not support locks.
  class Turn {
   public:
    explicit Turn(const ShardFolder& folder);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    int descriptor_;
  };

  /// The path of a database's folder.
  static std::filesystem::path path_for(const std::filesystem::path& database);

  /// Creates the folder in one step: another command sees all its files, or none. `command` is
  /// elsie's batch command with the experiment and its plugins; the shard and its files are added
  /// to it. Throws batch::DatabaseRefused if the folder already exists or cannot be created.
  static ShardFolder create(const std::filesystem::path& database, const batch::Plan& plan,
                            std::size_t shards, const std::vector<std::string>& command);
  /// The existing folder, to continue its batch; none if there is none. Throws
  /// batch::DatabaseRefused if it belongs to another experiment, or is not a folder of shards.
  static std::optional<ShardFolder> find(const std::filesystem::path& database,
                                         const batch::Plan& plan);

  std::size_t shards() const { return shards_; }
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path script() const { return path_ / "job.sh"; }
  std::filesystem::path database(std::size_t shard) const;
  /// `shard` is a number, or a scheduler's placeholder for a number.
  std::filesystem::path log(const std::string& shard) const;
  /// The name of the job array: it identifies folder and experiment.
  const std::string& name() const { return name_; }

  /// The number of the job array submitted last; empty if none was.
  const std::string& job() const { return job_; }
  void set_job(const std::string& job);

  /// The counts that the tasks write; they can be read while the tasks run. A shard that has not
  /// begun counts with its number of runs.
  Count count() const;
  /// The shards with pending runs, without those in `except` (ascending). Opens the databases, so
  /// no task may be running on these shards.
  std::vector<std::size_t> unfinished(const std::vector<std::size_t>& except = {}) const;
  /// The number of pending runs of a shard; opens its database.
  std::int64_t pending(std::size_t shard) const;
  /// The number of runs of a shard.
  std::int64_t runs(std::size_t shard) const;

  /// Merges the databases. Throws as batch::merge() does.
  void merge_into(const std::filesystem::path& database) const;
  bool exists() const;
  /// Removes the folder and its files in one step: another command sees all of them, or none.
  void remove() const;

 private:
  ShardFolder(std::filesystem::path path, std::string fingerprint, std::size_t shards,
              std::int64_t all_runs);
  void write(const std::filesystem::path& folder) const;

  std::filesystem::path path_;
  std::string fingerprint_;
  std::size_t shards_;
  std::int64_t all_runs_;
  std::string name_;
  std::string job_;
};

}  // namespace elsie::cluster
