// The file of a results database: its schema, how to open it, and errors as sentences.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "elsie/base/error.h"
#include "elsie/results/sqlite.h"

namespace elsie::results {

/// The file cannot be used for the request; what() is a sentence that names it. Nothing was
/// written.
class DatabaseRefused : public base::BadInput {
 public:
  using base::BadInput::BadInput;
};

/// The database could not be written or read, for example on a full disk; what() is a sentence that
/// names it. Data written before stays valid.
class DatabaseError : public base::Error {
 public:
  using base::Error::Error;
};

inline constexpr std::int64_t kApplicationId = 0x456C7369;  // "Elsi"
/// The version of the schema that this program reads and writes.
inline constexpr int kSchemaVersion = 6;

/// Throws DatabaseRefused if there is no such file, or it cannot be read or is empty. Opens
/// nothing, because a reader of a pipe would wait.
void require_file(const std::filesystem::path& file);

/// Opens an existing database. Throws DatabaseRefused if there is no such file, or if it is not a
/// results database, has another version, was not begun, or is damaged; DatabaseError if the system
/// cannot read it.
///
/// The whole file is read and checked: 0.05 s for a thousand runs with their trajectories, 27 MB.
sqlite::Connection open_to_write(const std::filesystem::path& file);

/// The same for reading. A database that is still in WAL mode can be read in a read-only folder if
/// its log is empty.
sqlite::Connection open_to_read(const std::filesystem::path& file);

/// Returns whether a batch can begin in this file: it does not exist, or is empty.
bool is_vacant(const std::filesystem::path& file);

/// Creates a file without tables, or uses a vacant one. Throws DatabaseRefused.
sqlite::Connection make_database(const std::filesystem::path& file);

/// Creates the empty tables of schema.sql and run_fields.h. Call it in a transaction.
void make_schema(sqlite::Connection& connection);

/// Sets the options of every connection that writes.
void prepare_for_writing(sqlite::Connection& connection);

/// Throws the error for the user: DatabaseRefused if the file is damaged, else DatabaseError: "the
/// database 'x.sqlite' could not be written: the disk is full". `what`: "could not be written".
[[noreturn]] void fail(const std::filesystem::path& file, const char* what,
                       const sqlite::Error& error);

/// The error for a damaged file; `where` names the damaged place for repairs: "in `runs`...".
DatabaseRefused damaged(const std::filesystem::path& file, const std::string& where);

/// Calls `action`; converts errors of SQLite by fail().
template <class Action>
auto guarded(const std::filesystem::path& file, const char* what, Action action) {
  try {
    return action();
  } catch (const sqlite::Error& error) {
    fail(file, what, error);
  }
}

}  // namespace elsie::results
