// Whether a database still holds what was written.
#pragma once

#include <optional>
#include <string>

#include "elsie/results/sqlite.h"

namespace elsie::results {

/// The first sign of damage, for those who repair the file; none: no sign. SQLite has no checksums:
/// a number that another one overwrote is not found.
std::optional<std::string> damage(sqlite::Connection& connection);

}  // namespace elsie::results
