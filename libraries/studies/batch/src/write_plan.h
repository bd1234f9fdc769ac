// Writes a plan into the database.
#pragma once

#include "elsie/batch/plan.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// Creates the tables and writes everything except the runs. Call it in a transaction.
void write_plan(sqlite::Connection& connection, const Plan& plan);

/// Adds the missing runs as pending.
void add_runs(sqlite::Connection& connection, const Plan& plan);

/// The current time, as "2026-01-31T12:00:00Z".
std::string utc_now();

}  // namespace elsie::batch
