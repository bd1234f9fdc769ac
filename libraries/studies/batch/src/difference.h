// Why a batch cannot go on with a database.
#pragma once

#include <string>

#include "elsie/batch/plan.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// Which of a plan's inputs differ from those that the database was begun with: each with its name,
/// and with the beginnings of both hashes where it is a file. Call it when the fingerprints differ:
/// where none of these inputs does, it says that plugins, their versions or seeds do.
std::string difference(sqlite::Connection& connection, const Plan& plan);

}  // namespace elsie::batch
