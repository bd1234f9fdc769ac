// A batch that many machines do: what they share on disk. Beside the database of results, in a
// folder of the same name with "-shards" behind it:
//
//   cluster.json       how many shards, and of which experiment
//   job.sh             what a task of the job array does
//   shard-K.sqlite     the results of a shard
//   shard-K.json       how far it is
//   shard-K.log        what its task has printed
//
// A shard's database is opened by nobody else while its task is at work: on folders that several
// machines share, SQLite's log of what is being written is for one machine only
// (https://sqlite.org/wal.html).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "elsie/batch/plan.h"

namespace elsie::cluster {

/// How far the runs of a shard, or of all of them, are.
struct Count {
  std::int64_t runs = 0;
  std::int64_t ended = 0;
  std::int64_t failed = 0;  // of those ended
};

/// Writes how far a shard is; other processes see the file before or after it, nothing in between.
/// Throws std::runtime_error with a sentence.
void write_count(const std::filesystem::path& file, const Count& count);

class ShardFolder {
 public:
  /// Of several commands that follow one batch, the one that hands over tasks or makes one database
  /// of the parts: waits for the others. Held while it lives. Throws std::runtime_error with a
  /// sentence when the folder's file system knows no locks.
  class Turn {
   public:
    explicit Turn(const ShardFolder& folder);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    int descriptor_;
  };

  /// Where the folder of a database is.
  static std::filesystem::path beside(const std::filesystem::path& database);

  /// Makes the folder. `command`: elsie's batch command with the experiment and its plugins, to
  /// which shard and files are added. Throws batch::DatabaseRefused when there is one already or it
  /// cannot be made.
  static ShardFolder create(const std::filesystem::path& database, const batch::Plan& plan,
                            std::size_t shards, const std::vector<std::string>& command);
  /// Opens one to go on with it. Throws batch::DatabaseRefused when it is of another experiment, or
  /// something else.
  static ShardFolder open(const std::filesystem::path& database, const batch::Plan& plan);

  std::size_t shards() const { return shards_; }
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path script() const { return path_ / "job.sh"; }
  std::filesystem::path database(std::size_t shard) const;
  /// `shard`: a number, or what a scheduler puts one in for.
  std::filesystem::path log(const std::string& shard) const;
  /// What the array is called: the same for the same folder and experiment, and for no other.
  const std::string& name() const { return name_; }

  /// The job number of the array submitted last; empty: none was.
  const std::string& job() const { return job_; }
  void set_job(const std::string& job);

  /// What the tasks say of themselves: for those at work. Shards that have not begun count with
  /// their runs.
  Count count() const;
  /// The shards that have runs to be done. Opens the databases: for shards that nobody is at work
  /// on. `except`, ascending, are left out.
  std::vector<std::size_t> unfinished(const std::vector<std::size_t>& except = {}) const;
  /// How many runs of a shard are to be done; opens its database.
  std::int64_t pending(std::size_t shard) const;
  /// How many runs it has.
  std::int64_t runs(std::size_t shard) const;

  /// Makes one database of all. Throws what batch::merge() does.
  void merge_into(const std::filesystem::path& database) const;
  bool exists() const;
  /// Removes the folder with what is in it.
  void remove() const;

 private:
  ShardFolder(std::filesystem::path path, std::string fingerprint, std::size_t shards,
              std::int64_t all_runs);
  void write() const;

  std::filesystem::path path_;
  std::string fingerprint_;
  std::size_t shards_;
  std::int64_t all_runs_;
  std::string name_;
  std::string job_;
};

}  // namespace elsie::cluster
