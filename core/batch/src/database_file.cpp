#include "database_file.h"

#include <system_error>

namespace elsie::batch {
namespace {

namespace fs = std::filesystem;

std::string name(const fs::path& file) { return "the database '" + file.string() + "' "; }

}  // namespace

std::string sentence(const fs::path& file, const char* what, const sqlite::Error& error) {
  const auto told = [&](const std::string& why) { return name(file) + what + ": " + why; };
  switch (error.code) {
    case SQLITE_FULL:
      return told("the disk is full, or the file may not grow further");
    case SQLITE_READONLY:
      return told("it, or its folder, is read-only");
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_AUTH: {
      const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
      std::error_code ignored;
      return told(!fs::is_directory(folder, ignored)
                      ? "there is no folder '" + folder.string() + "'; make it first"
                  : fs::is_directory(file, ignored) ? "it is a directory"
                                                    : "the system does not allow it");
    }
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return told("another program has locked it");
    case SQLITE_NOTADB:
      return told("it is no SQLite database");
    case SQLITE_IOERR:
      return told(std::string(error.what()) +
                  "; is the disk full, or may the file not grow further?");
    case SQLITE_CORRUPT:
      return told("it is damaged");
    default:
      return told(error.what());
  }
}

sqlite::Connection open_results(const fs::path& file, sqlite::Connection::Mode mode) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw DatabaseRefused("there is no database '" + file.string() + "'");
  }
  try {
    sqlite::Connection connection(file, mode);
    const std::int64_t id = connection.integer("PRAGMA application_id");
    const std::int64_t version = connection.integer("PRAGMA user_version");
    if (id != kApplicationId) {
      throw DatabaseRefused("'" + file.string() +
                            "' is an SQLite database, but none that `elsie batch` has written");
    }
    if (version != kSchemaVersion) {
      throw DatabaseRefused(name(file) + "has format " + std::to_string(version) +
                            ", but this program reads format " + std::to_string(kSchemaVersion) +
                            "; use the program that wrote it");
    }
    return connection;
  } catch (const sqlite::Error& error) {
    throw DatabaseRefused(sentence(file, "cannot be opened", error));
  }
}

sqlite::Connection make_results(const fs::path& file) {
  try {
    sqlite::Connection connection(file, sqlite::Connection::Mode::create);
    // One transaction with what follows would be better still; but these must be outside of one.
    connection.run("PRAGMA foreign_keys = ON");
    return connection;
  } catch (const sqlite::Error& error) {
    throw DatabaseRefused(sentence(file, "cannot be made", error));
  }
}

void prepare_for_writing(sqlite::Connection& connection) {
  connection.run(
      "PRAGMA foreign_keys = ON; PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
}

}  // namespace elsie::batch
