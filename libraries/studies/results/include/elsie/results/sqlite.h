// SQLite with owners: connections, prepared statements, transactions. As thin as it can be: the
// tables and what they mean are others' affair.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace elsie::results::sqlite {

/// what() is what SQLite says. Thrown by everything here that can fail.
class Error : public std::runtime_error {
 public:
  Error(int result_code, const std::string& text) : std::runtime_error(text), code(result_code) {}

  /// Whether the file is not what it should be, rather than the disk or the system.
  bool is_damage() const;

  int code;  // SQLITE_FULL, SQLITE_READONLY... without the extended part
};

class Connection;

/// Values are bound from 1, columns counted from 0. To be used again and again.
class Statement {
 public:
  Statement(Connection& connection, std::string_view sql);

  Statement& bind(int place, std::string_view text);
  Statement& bind(int place, const std::string& text) {
    return bind(place, std::string_view(text));
  }
  Statement& bind(int place, const char* text) { return bind(place, std::string_view(text)); }
  Statement& bind(int place, std::int64_t number);
  Statement& bind(int place, double number);
  Statement& bind_null(int place);
  Statement& bind_bytes(int place, std::string_view bytes);
  template <class T>
  Statement& bind(int place, const std::optional<T>& value) {
    return value ? bind(place, *value) : bind_null(place);
  }

  /// What stands in a column of another statement's row.
  Statement& bind_value(int place, const Statement& from, int column);

  /// The next row; false after the last one, and then it may be bound anew.
  bool next();
  /// For statements that give no rows.
  void run();

  int columns() const;
  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double number(int column) const;
  std::string text(int column) const;  // or bytes; "" for null
  /// The same without a copy: valid until the next row.
  std::string_view bytes(int column) const;
  std::optional<std::int64_t> optional_integer(int column) const;
  std::optional<double> optional_number(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  void check(int code) const;

  Connection* connection_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class Connection {
 public:
  enum class Mode {
    read,
    immutable,  // read, and nobody writes meanwhile: without a lock, or a log of what is written
    write,
    create
  };

  Connection(const std::filesystem::path& file, Mode mode);

  /// Statements without values, one after another.
  void run(const std::string& sql);
  /// The same; what goes wrong does not matter.
  void try_to_run(const std::string& sql) noexcept;
  /// The first column of the first row.
  std::int64_t integer(std::string_view sql);
  std::string text(std::string_view sql);
  /// How many rows the last statement changed.
  std::int64_t changes() const;

  sqlite3* handle() const { return handle_.get(); }
  [[noreturn]] void fail(int code) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

/// Writes; undone unless it is committed.
class Transaction {
 public:
  explicit Transaction(Connection& connection) : connection_(connection) {
    connection_.run("BEGIN IMMEDIATE");
  }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();

 private:
  Connection& connection_;
  bool open_ = true;
};

}  // namespace elsie::results::sqlite
