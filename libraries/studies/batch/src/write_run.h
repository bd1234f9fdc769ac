// Writes the result of a run into the database.
#pragma once

#include <cstdint>

#include "elsie/batch/job.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// Writes in its own transaction. Returns false, and writes nothing, if the run is not pending.
bool write_run(sqlite::Connection& connection, std::int64_t run, const RunRecord& record);

}  // namespace elsie::batch
