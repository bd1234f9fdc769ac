// A little of SQLite: statements that read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace elsie::report {

/// A connection that reads, within one transaction: what others write meanwhile is not seen. Throws
/// ResultsError, as all here.
class Connection {
 public:
  explicit Connection(const std::string& file);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  sqlite3* handle() const { return handle_; }
  const std::string& file() const { return file_; }
  /// For the last call that failed.
  [[noreturn]] void fail() const;

 private:
  bool open(bool immutable);

  std::string file_;
  sqlite3* handle_ = nullptr;
};

/// A query and its rows.
class Query {
 public:
  Query(const Connection& connection, const std::string& sql);
  ~Query();
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  Query& bind(int place, std::int64_t value);  // the first place is 1
  /// To the next row; false after the last.
  bool next();

  // Of the row, by column from 0.
  bool null(int column) const;
  std::int64_t integer(int column) const;
  double number(int column) const;
  std::string text(int column) const;  // "" for null
  std::optional<std::int64_t> optional_integer(int column) const;
  std::optional<double> optional_number(int column) const;

 private:
  const Connection& connection_;
  sqlite3_stmt* statement_ = nullptr;
};

}  // namespace elsie::report
