// Writes the result of a run into the database.
#pragma once

#include <string>

#include "elsie/batch/job.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// Holds the prepared statements.
class RunWriter {
 public:
  explicit RunWriter(sqlite::Connection& connection);

  /// Writes in its own transaction. Returns false, and writes nothing, if the run is not pending.
  bool write(std::int64_t run, const RunRecord& record);

 private:
  sqlite::Statement insert(const std::string& table, const std::string& columns);
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
