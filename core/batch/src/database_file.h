// Opening a file as a database of results, and the sentences when it is none.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/batch/results_database.h"

#include "sqlite.h"

namespace elsie::batch {

inline constexpr std::int64_t kApplicationId = 0x456C7369;  // "Elsi"

/// The text of schema.sql.
extern const char* const kSchema;

/// Opens one that is there. Throws DatabaseRefused.
sqlite::Connection open_results(const std::filesystem::path& file, sqlite::Connection::Mode mode);

/// Makes one with all tables and nothing in them. Throws DatabaseRefused.
sqlite::Connection make_results(const std::filesystem::path& file);

/// What every connection that writes is to have set.
void prepare_for_writing(sqlite::Connection& connection);

/// SQLite's error as a sentence about the file: "could not be written: the disk is full".
std::string sentence(const std::filesystem::path& file, const char* what,
                     const sqlite::Error& error);

/// Calls `action`; SQLite's errors become a DatabaseError: "the database 'x.sqlite' could not be
/// written: ...".
template <class Action>
auto guarded(const std::filesystem::path& file, const char* what, Action action) {
  try {
    return action();
  } catch (const sqlite::Error& error) {
    throw DatabaseError(sentence(file, what, error));
  }
}

}  // namespace elsie::batch
