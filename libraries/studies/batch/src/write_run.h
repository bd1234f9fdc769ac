// What became of a run, as rows of the database.
#pragma once

#include "elsie/batch/job.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// The statements, prepared once.
class RunWriter {
 public:
  explicit RunWriter(sqlite::Connection& connection);

  /// In a transaction of its own. False when the run is not pending: nothing is written then.
  bool write(std::int64_t run, const RunRecord& record);

 private:
  bool update(std::int64_t run, const RunRecord& record);
  void write_measures(std::int64_t run, const RunRecord& record);
  void write_events(std::int64_t run, const RunRecord& record);

  sqlite::Connection& connection_;
  sqlite::Statement run_;
  sqlite::Statement measure_;
  sqlite::Statement run_measure_;
  sqlite::Statement robot_;
  sqlite::Statement event_;
  sqlite::Statement trajectory_;
  sqlite::Statement curve_;
  sqlite::Statement timeline_;
  sqlite::Statement note_;
};

}  // namespace elsie::batch
