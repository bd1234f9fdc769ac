// A file as a database of results: its schema, opening it, and the sentences when it is none.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "elsie/base/error.h"
#include "elsie/results/sqlite.h"

namespace elsie::results {

/// A file that is not the right one for what is asked; what() is a sentence that names it. Nothing
/// was written.
class DatabaseRefused : public base::BadInput {
 public:
  using base::BadInput::BadInput;
};

/// A database that could not be written or read (a full disk); what() is a sentence that names it.
/// What was written before is valid.
class DatabaseError : public base::Error {
 public:
  using base::Error::Error;
};

inline constexpr std::int64_t kApplicationId = 0x456C7369;  // "Elsi"
/// The version of the schema that this program reads and writes.
inline constexpr int kSchemaVersion = 2;

/// Opens a database that is there. Throws DatabaseRefused when there is no such file, when it is no
/// database of results or one of another version, was not begun, or is damaged; DatabaseError when
/// the system cannot read it.
///
/// All of it is read and checked: 0.05 s for a thousand runs with their trajectories, 27 MB.
sqlite::Connection open_to_write(const std::filesystem::path& file);

/// The same. One that was left in the mode in which it is written can be read where nothing can be
/// written, as long as its log is empty.
sqlite::Connection open_to_read(const std::filesystem::path& file);

/// Whether a batch would begin anew there: there is no file, or one with nothing in it.
bool is_vacant(const std::filesystem::path& file);

/// Makes a file without tables, or takes a vacant one. Throws DatabaseRefused.
sqlite::Connection make_database(const std::filesystem::path& file);

/// Makes the tables of schema.sql, with nothing in them. Within a transaction.
void make_schema(sqlite::Connection& connection);

/// What every connection that writes is to have set.
void prepare_for_writing(sqlite::Connection& connection);

/// Throws what an error of SQLite means for the user: DatabaseRefused when the file is damaged, or
/// DatabaseError: "the database 'x.sqlite' could not be written: the disk is full". `what`: "could
/// not be written".
[[noreturn]] void fail(const std::filesystem::path& file, const char* what,
                       const sqlite::Error& error);

/// DatabaseRefused for a damaged file; `where`: "in `runs`...", for those who repair it.
DatabaseRefused damaged(const std::filesystem::path& file, const std::string& where);

/// Calls `action`; errors of SQLite become those of fail().
template <class Action>
auto guarded(const std::filesystem::path& file, const char* what, Action action) {
  try {
    return action();
  } catch (const sqlite::Error& error) {
    fail(file, what, error);
  }
}

}  // namespace elsie::results
