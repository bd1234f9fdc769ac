// Explains why a database cannot be resumed.
#pragma once

#include <string>

#include "elsie/batch/plan.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// Lists the inputs of a plan that differ from those in the database, by name; files with the
/// beginnings of both hashes. Call it when the fingerprints differ: if no input differs, the text
/// says that plugins, their versions or seeds differ.
std::string difference(sqlite::Connection& connection, const Plan& plan);

}  // namespace elsie::batch
