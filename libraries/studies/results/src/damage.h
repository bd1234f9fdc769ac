// Checks a database for damage.
#pragma once

#include <optional>
#include <string>

#include "elsie/results/sqlite.h"

namespace elsie::results {

/// The first sign of damage, as a hint for repairing the file; none if there is no sign. SQLite has
/// no checksums: a number that was overwritten by another one is not found.
std::optional<std::string> damage(sqlite::Connection& connection);

}  // namespace elsie::results
