#include "elsie/results/sqlite.h"

#include <algorithm>

#include <sqlite3.h>

namespace elsie::results::sqlite {
namespace {

/// Returns the path as a URI, in which '?', '#' and '%' are special.
std::string immutable_uri(const std::string& file) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string uri = "file:";
  for (const char c : file) {
    if (c == '?' || c == '#' || c == '%') {
      uri += {'%', kDigits[c >> 4], kDigits[c & 15]};
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

/// SQLite takes "file:x.db" for a URI, and ":memory:" for no file.
std::string as_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  return name.starts_with("file:") || name.starts_with(':') ? "./" + name : name;
}

/// "runs (id, seed) VALUES (?, ?)"
std::string row_of(const std::string& table, const std::string& columns) {
  std::string marks = "?";
  for (auto more = std::count(columns.begin(), columns.end(), ','); more > 0; --more) {
    marks += ", ?";
  }
  return table + " (" + columns + ") VALUES (" + marks + ")";
}

}  // namespace

bool Error::is_damage() const { return code == SQLITE_CORRUPT || code == SQLITE_NOTADB; }

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(Connection& connection, std::string_view sql) : connection_(&connection) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(connection.handle(), sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  statement_.reset(statement);
  check(code);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) {
    connection_->fail(code);
  }
}

Statement Statement::insert(Connection& connection, const std::string& table,
                            const std::string& columns) {
  return {connection, "INSERT INTO " + row_of(table, columns)};
}

Statement Statement::insert_or_ignore(Connection& connection, const std::string& table,
                                      const std::string& columns) {
  return {connection, "INSERT OR IGNORE INTO " + row_of(table, columns)};
}

void Statement::require_values(std::size_t count) const {
  if (const int wanted = sqlite3_bind_parameter_count(statement_.get());
      count != static_cast<std::size_t>(wanted)) {
    throw std::logic_error("a statement with " + std::to_string(wanted) + " values was given " +
                           std::to_string(count));
  }
}

Statement& Statement::bind(int place, std::string_view text) {
  check(sqlite3_bind_text64(statement_.get(), place, text.data() ? text.data() : "", text.size(),
                            SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind(int place, std::int64_t number) {
  check(sqlite3_bind_int64(statement_.get(), place, number));
  return *this;
}

Statement& Statement::bind(int place, double number) {
  check(sqlite3_bind_double(statement_.get(), place, number));
  return *this;
}

Statement& Statement::bind_null(int place) {
  check(sqlite3_bind_null(statement_.get(), place));
  return *this;
}

Statement& Statement::bind(int place, const Bytes& bytes) {
  const std::string_view value = bytes.value;
  check(sqlite3_bind_blob64(statement_.get(), place, value.data() ? value.data() : "", value.size(),
                            SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind_value(int place, const Statement& from, int column) {
  check(sqlite3_bind_value(statement_.get(), place,
                           sqlite3_column_value(from.statement_.get(), column)));
  return *this;
}

int Statement::columns() const { return sqlite3_column_count(statement_.get()); }

std::string Statement::column_names() const {
  std::string names;
  for (int column = 0; column < columns(); ++column) {
    names +=
        (names.empty() ? "" : ", ") + std::string(sqlite3_column_name(statement_.get(), column));
  }
  return names;
}

bool Statement::next() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) {
    return true;
  }
  if (code != SQLITE_DONE) {
    const Error error(code & 0xff, sqlite3_errmsg(connection_->handle()));
    sqlite3_reset(statement_.get());
    throw error;
  }
  sqlite3_reset(statement_.get());
  return false;
}

void Statement::run() {
  while (next()) {
  }
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::number(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string_view Statement::bytes(int column) const {
  const void* const bytes = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return bytes ? std::string_view(static_cast<const char*>(bytes), static_cast<std::size_t>(size))
               : std::string_view();
}

std::string Statement::text(int column) const { return std::string(bytes(column)); }

std::optional<std::int64_t> Statement::optional_integer(int column) const {
  return is_null(column) ? std::nullopt : std::optional(integer(column));
}

std::optional<double> Statement::optional_number(int column) const {
  return is_null(column) ? std::nullopt : std::optional(number(column));
}

void Connection::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

Connection::Connection(const std::filesystem::path& file, Mode mode) {
  const int flags = mode == Mode::create      ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
                    : mode == Mode::write     ? SQLITE_OPEN_READWRITE
                    : mode == Mode::immutable ? SQLITE_OPEN_READONLY | SQLITE_OPEN_URI
                                              : SQLITE_OPEN_READONLY;
  const std::string name = mode == Mode::immutable ? immutable_uri(as_file(file)) : as_file(file);
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &handle, flags, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) {
    fail(code);
  }
  sqlite3_busy_timeout(handle, 10'000);  // for readers and backups
}

void Connection::run(const std::string& sql) {
  const int code = sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) {
    fail(code);
  }
}

void Connection::try_to_run(const std::string& sql) noexcept {
  sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr);
}

std::int64_t Connection::changes() const { return sqlite3_changes64(handle_.get()); }

std::int64_t Connection::integer(std::string_view sql) {
  Statement statement(*this, sql);
  return statement.next() ? statement.integer(0) : 0;
}

std::string Connection::text(std::string_view sql) {
  Statement statement(*this, sql);
  return statement.next() ? statement.text(0) : std::string();
}

void Connection::fail(int code) const {
  throw Error(code & 0xff, handle_ ? sqlite3_errmsg(handle_.get()) : "out of memory");
}

Transaction::~Transaction() {
  if (open_) {
    connection_.try_to_run("ROLLBACK");  // a full disk may already have rolled it back
  }
}

void Transaction::commit() {
  connection_.run("COMMIT");
  open_ = false;
}

}  // namespace elsie::results::sqlite
