#include "sqlite.h"

#include <filesystem>

#include <sqlite3.h>

#include "elsie/report/results.h"

namespace elsie::report {

namespace {

// As a URI, whose special characters are '?', '#' and '%'.
std::string uri_of(const std::string& file, bool immutable) {
  std::string uri = "file:";
  for (const char c : file) {
    if (c == '?') {
      uri += "%3f";
    } else if (c == '#') {
      uri += "%23";
    } else if (c == '%') {
      uri += "%25";
    } else {
      uri += c;
    }
  }
  return uri + (immutable ? "?immutable=1" : "");
}

}  // namespace

Connection::Connection(const std::string& file) : file_(file) {
  if (open(false)) return;
  // A database in WAL mode in a folder that cannot be written to can be read only by those who
  // promise that nobody writes it meanwhile; and all of it only when nothing is left in its log.
  const int code = sqlite3_errcode(handle_) & 0xff;
  const bool locked_folder = code == SQLITE_CANTOPEN || code == SQLITE_READONLY;
  std::error_code error;
  const std::string log = file_ + "-wal";
  const bool log_is_empty =
      !std::filesystem::exists(log, error) || std::filesystem::file_size(log, error) == 0;
  if (locked_folder && log_is_empty && open(true)) return;
  const std::string message = sqlite3_errmsg(handle_);
  sqlite3_close(handle_);
  throw ResultsError(
      code == SQLITE_NOTADB
          ? "'" + file_ + "' is not a database; expected one that `elsie batch` has written"
      : locked_folder && !log_is_empty
          ? "'" + file_ +
                "' cannot be read where it is: its log is not written back, and its folder "
                "is read-only; copy both to another folder"
          : "cannot read the database '" + file_ + "': " + message);
}

// Whether the file could be opened and its first page read.
bool Connection::open(bool immutable) {
  sqlite3_close(handle_);
  handle_ = nullptr;
  const int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_PRIVATECACHE;
  if (sqlite3_open_v2(uri_of(file_, immutable).c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
    return false;
  }
  sqlite3_busy_timeout(handle_, 10000);
  return sqlite3_exec(handle_, "BEGIN; SELECT count(*) FROM sqlite_schema", nullptr, nullptr,
                      nullptr) == SQLITE_OK;
}

Connection::~Connection() { sqlite3_close(handle_); }

void Connection::fail() const {
  throw ResultsError("cannot read the database '" + file_ + "': " + sqlite3_errmsg(handle_));
}

Query::Query(const Connection& connection, const std::string& sql) : connection_(connection) {
  if (sqlite3_prepare_v2(connection.handle(), sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK) {
    connection.fail();
  }
}

Query::~Query() { sqlite3_finalize(statement_); }

Query& Query::bind(int place, std::int64_t value) {
  if (sqlite3_bind_int64(statement_, place, value) != SQLITE_OK) connection_.fail();
  return *this;
}

bool Query::next() {
  const int result = sqlite3_step(statement_);
  if (result != SQLITE_ROW && result != SQLITE_DONE) connection_.fail();
  return result == SQLITE_ROW;
}

bool Query::null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

std::int64_t Query::integer(int column) const { return sqlite3_column_int64(statement_, column); }

double Query::number(int column) const { return sqlite3_column_double(statement_, column); }

std::string Query::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return bytes ? std::string(bytes,
                             static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)))
               : "";
}

std::optional<std::int64_t> Query::optional_integer(int column) const {
  return null(column) ? std::nullopt : std::optional(integer(column));
}

std::optional<double> Query::optional_number(int column) const {
  return null(column) ? std::nullopt : std::optional(number(column));
}

}  // namespace elsie::report
