// How a plan differs from what a database was begun with.
#pragma once

#include <string>
#include <vector>

#include "elsie/batch/plan.h"
#include "elsie/results/sqlite.h"

#include "stages.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// What the database has and the plan lacks, in a few words each: "the seeds 3-5 (removed)".
std::vector<std::string> losses(const StoredGrid& stored, const Plan& plan);

/// What the plan has and the database lacks: "6 cells and 20 seeds"; "" for nothing.
std::string growth(const StoredGrid& stored, const Plan& plan);

/// The inputs of a plan that differ from those in the database, by name; files with the beginnings
/// of both hashes. Call it when they differ: if none of the inputs does, the text says that plugins
/// or their versions differ.
std::string difference(sqlite::Connection& connection, const StoredGrid& stored, const Plan& plan);

}  // namespace elsie::batch
