#include "elsie/results/database_file.h"

#include <system_error>

#include <sqlite3.h>

#include "elsie/base/read_whole.h"
#include "elsie/results/run_fields.h"

#include "damage.h"

namespace elsie::results {

/// The text of schema.sql, without the fields of runs.
extern const char* const kSchema;

namespace {

namespace fs = std::filesystem;
using Mode = sqlite::Connection::Mode;

constexpr const char* kExpected = "expected a database that `elsie batch` has written";

std::string name(const fs::path& file) { return "the database '" + file.string() + "' "; }

/// Checks the program and the version in the first page.
void require_ours(sqlite::Connection& connection, const fs::path& file) {
  const std::int64_t id = connection.integer("PRAGMA application_id");
  const std::int64_t version = connection.integer("PRAGMA user_version");
  if (id != kApplicationId) {
    throw DatabaseRefused("'" + file.string() + "' is a database of another program; " + kExpected);
  }
  if (version != kSchemaVersion) {
    throw DatabaseRefused(name(file) + "has version " + std::to_string(version) +
                          " of the schema, and this program reads version " +
                          std::to_string(kSchemaVersion) + "; use the program that wrote it");
  }
}

void require_sound(sqlite::Connection& connection, const fs::path& file) {
  if (const auto where = damage(connection)) {
    throw damaged(file, *where);
  }
  if (connection.integer("SELECT count(*) FROM about") == 0) {
    throw DatabaseRefused(name(file) +
                          "was not begun: its batch ended before the runs were planned; remove it "
                          "and run `elsie batch` again");
  }
}

sqlite::Connection checked(sqlite::Connection connection, const fs::path& file) {
  require_ours(connection, file);
  try {
    require_sound(connection, file);
  } catch (const sqlite::Error& error) {
    if (error.code == SQLITE_ERROR) {  // a table or a column is missing
      throw damaged(file, error.what());
    }
    throw;
  }
  return connection;
}

/// A database in WAL mode in a read-only folder can be opened only with the promise that no process
/// writes it. It is complete only if its log is empty.
sqlite::Connection open_where_nothing_can_be_written(const fs::path& file) {
  for (const char* ending : {"-wal", "-journal"}) {
    const std::string log = file.string() + ending;
    std::error_code ignored;
    if (fs::exists(log, ignored) && fs::file_size(log, ignored) > 0) {
      throw DatabaseRefused("'" + file.string() + "' cannot be read where it is: its log '" + log +
                            "' is not written back, and its folder is read-only; copy both to "
                            "another folder");
    }
  }
  return checked(sqlite::Connection(file, Mode::immutable), file);
}

bool is_locked_folder(const sqlite::Error& error) {
  return error.code == SQLITE_CANTOPEN || error.code == SQLITE_READONLY;
}

std::string reason(const fs::path& file, const sqlite::Error& error) {
  switch (error.code) {
    case SQLITE_FULL:
      return "the disk is full, or the file may not grow further";
    case SQLITE_READONLY:
      return "it, or its folder, is read-only";
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_AUTH: {
      const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
      std::error_code ignored;
      return !fs::is_directory(folder, ignored)
                 ? "there is no folder '" + folder.string() + "'; make it first"
             : fs::is_directory(file, ignored) ? "it is a directory"
                                               : "the system does not allow it";
    }
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program has locked it";
    case SQLITE_IOERR:
      return std::string(error.what()) + "; is the disk full, or may the file not grow further?";
    default:
      return error.what();
  }
}

/// On opening, a damaged file is bad input; an error of the system is not.
[[noreturn]] void refuse(const fs::path& file, const char* what, const sqlite::Error& error) {
  if (error.code == SQLITE_NOTADB) {
    throw DatabaseRefused("'" + file.string() + "' is not an SQLite database; " + kExpected);
  }
  if (error.is_damage() || error.code == SQLITE_FULL || error.code == SQLITE_IOERR ||
      error.code == SQLITE_NOMEM) {
    fail(file, what, error);
  }
  throw DatabaseRefused(name(file) + what + ": " + reason(file, error));
}

}  // namespace

void require_file(const fs::path& file) {
  const std::string quoted = "'" + file.string() + "' ";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw DatabaseRefused("there is no database '" + file.string() +
                          "'; `elsie batch EXPERIMENT --database FILE` writes one");
  }
  if (const std::string why = base::why_unreadable(file); !why.empty()) {
    throw DatabaseRefused(quoted + why + "; " + kExpected);
  }
  if (fs::file_size(file, ignored) == 0) {
    throw DatabaseRefused(quoted + "is empty; " + kExpected);
  }
}

DatabaseRefused damaged(const fs::path& file, const std::string& where) {
  return DatabaseRefused(name(file) + "is damaged (" + where +
                         "), and its contents cannot be trusted; use a copy of it, or do its runs "
                         "again with another --database");
}

void fail(const fs::path& file, const char* what, const sqlite::Error& error) {
  if (error.is_damage()) {
    throw damaged(file, error.what());
  }
  throw DatabaseError(name(file) + what + ": " + reason(file, error));
}

sqlite::Connection open_to_write(const fs::path& file) {
  require_file(file);
  try {
    return checked(sqlite::Connection(file, Mode::write), file);
  } catch (const sqlite::Error& error) {
    refuse(file, "cannot be opened", error);
  }
}

sqlite::Connection open_to_read(const fs::path& file) {
  if (std::error_code ignored; fs::exists(file.string() + "-journal", ignored)) {
    is_vacant(file);  // removes the files of an interrupted start
  }
  require_file(file);
  try {
    try {
      return checked(sqlite::Connection(file, Mode::read), file);
    } catch (const sqlite::Error& error) {
      if (!is_locked_folder(error)) {
        throw;
      }
      return open_where_nothing_can_be_written(file);
    }
  } catch (const sqlite::Error& error) {
    refuse(file, "cannot be opened", error);
  }
}

bool is_vacant(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) {
    return true;
  }
  if (!fs::is_regular_file(file, error)) {
    return false;  // for example a device, which must not be written or removed
  }
  try {
    // In write mode, so that an incomplete transaction of a killed process is undone.
    sqlite::Connection connection(file, Mode::write);
    return connection.integer("PRAGMA application_id") == 0 &&
           connection.integer("SELECT count(*) FROM sqlite_schema") == 0;
  } catch (const sqlite::Error&) {
    return false;
  }
}

sqlite::Connection make_database(const fs::path& file) {
  try {
    sqlite::Connection connection(file, Mode::create);
    // This cannot be part of the following transaction.
    connection.run("PRAGMA foreign_keys = ON");
    return connection;
  } catch (const sqlite::Error& error) {
    refuse(file, "cannot be made", error);
  }
}

void make_schema(sqlite::Connection& connection) {
  std::string schema = kSchema;
  const std::string mark = "{run_fields}";
  schema.replace(schema.find(mark), mark.size(), field_columns());
  connection.run(schema);
  connection.run("PRAGMA application_id = " + std::to_string(kApplicationId) +
                 "; PRAGMA user_version = " + std::to_string(kSchemaVersion));
}

void prepare_for_writing(sqlite::Connection& connection) {
  connection.run(
      "PRAGMA foreign_keys = ON; PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
}

}  // namespace elsie::results
