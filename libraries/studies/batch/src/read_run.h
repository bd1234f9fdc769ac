#pragma once

#include <optional>

#include "elsie/batch/results_database.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// Reads all data needed to repeat a run; none if there is no such run.
std::optional<StoredRun> read_run(sqlite::Connection& connection, std::int64_t id);

}  // namespace elsie::batch
