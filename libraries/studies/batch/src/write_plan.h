// A plan as rows of the database.
#pragma once

#include "elsie/batch/plan.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// Makes the tables, and writes all but the runs. Within a transaction.
void write_plan(sqlite::Connection& connection, const Plan& plan);

/// Adds the runs that are not there yet, as pending ones.
void add_runs(sqlite::Connection& connection, const Plan& plan);

/// "2026-01-31T12:00:00Z", now.
std::string utc_now();

}  // namespace elsie::batch
