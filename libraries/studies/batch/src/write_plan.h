// Writes a plan into the database.
#pragma once

#include <cstddef>
#include <string>

#include "elsie/batch/plan.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// Creates the tables and writes everything except the runs. Call it in a transaction.
void write_plan(sqlite::Connection& connection, const Plan& plan);

/// Brings a database that has the first `known_stages` stages up to date: adds what the others
/// need, and renews what may change without changing a run. Call it in a transaction.
void renew_plan(sqlite::Connection& connection, const Plan& plan, std::size_t known_stages);

/// Adds the missing runs as pending.
void add_runs(sqlite::Connection& connection, const Plan& plan);

/// The current time, as "2026-01-31T12:00:00Z".
std::string utc_now();

}  // namespace elsie::batch
