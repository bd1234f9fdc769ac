// Whether what is in a database is what was written.
#pragma once

#include <optional>
#include <string>

#include "elsie/results/sqlite.h"

namespace elsie::results {

/// What shows first that the file was damaged, for those who repair it; none: nothing does. SQLite
/// has no checksums: a number that was overwritten by another one is not found.
std::optional<std::string> damage(sqlite::Connection& connection);

}  // namespace elsie::results
