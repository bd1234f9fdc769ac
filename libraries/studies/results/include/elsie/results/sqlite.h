// A thin wrapper of SQLite: connections, prepared statements, transactions. It defines no tables.
#pragma once

#include <concepts>
#include <cstddef>
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

/// what() is SQLite's message. All functions here may throw it.
class Error : public std::runtime_error {
 public:
  Error(int result_code, const std::string& text) : std::runtime_error(text), code(result_code) {}

  /// Returns whether the file's contents are damaged; otherwise the disk or the system failed.
  bool is_damage() const;

  int code;  // SQLITE_FULL, SQLITE_READONLY...; primary result code
};

class Connection;

/// A value that is stored as bytes, not as text.
struct Bytes {
  std::string_view value;
};

/// A reusable prepared statement. Places of values count from 1, columns from 0.
class Statement {
 public:
  Statement(Connection& connection, std::string_view sql);
  /// Inserts a row with values for these columns: "run_id, robot".
  static Statement insert(Connection& connection, const std::string& table,
                          const std::string& columns);
  /// The same; a row that would violate a constraint is left out.
  static Statement insert_or_ignore(Connection& connection, const std::string& table,
                                    const std::string& columns);

  Statement& bind(int place, std::string_view text);
  Statement& bind(int place, const std::string& text) {
    return bind(place, std::string_view(text));
  }
  Statement& bind(int place, const char* text) { return bind(place, std::string_view(text)); }
  Statement& bind(int place, const Bytes& bytes);
  Statement& bind(int place, std::int64_t number);
  /// The 64 bits of an unsigned number are stored as a signed one.
  template <std::integral Whole>
  Statement& bind(int place, Whole number) {
    return bind(place, static_cast<std::int64_t>(number));
  }
  Statement& bind(int place, double number);
  Statement& bind_null(int place);
  template <class T>
  Statement& bind(int place, const std::optional<T>& value) {
    return value ? bind(place, *value) : bind_null(place);
  }

  /// Binds a column of another statement's row.
  Statement& bind_value(int place, const Statement& from, int column);

  /// Steps to the next row; false after the last one, when the statement may be bound again.
  bool next();
  /// Runs a statement that returns no rows.
  void run();
  /// The same with all its values, in order; throws std::logic_error if it has fewer or more.
  template <class First, class... Others>
  void run(const First& first, const Others&... others) {
    require_values(1 + sizeof...(others));
    int place = 0;
    bind(++place, first);
    (bind(++place, others), ...);
    run();
  }

  int columns() const;
  /// "id, seed"
  std::string column_names() const;
  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double number(int column) const;
  std::string text(int column) const;  // or bytes; "" for null
  /// The same without a copy; valid until the next row.
  std::string_view bytes(int column) const;
  std::optional<std::int64_t> optional_integer(int column) const;
  std::optional<double> optional_number(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  void check(int code) const;
  void require_values(std::size_t count) const;

  Connection* connection_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class Connection {
 public:
  enum class Mode {
    read,
    immutable,  // for reading without a lock or a log; nobody may write meanwhile
    write,
    create
  };

  Connection(const std::filesystem::path& file, Mode mode);

  /// Runs statements without parameters, one after another.
  void run(const std::string& sql);
  /// The same; errors are ignored.
  void try_to_run(const std::string& sql) noexcept;
  /// The first column of the first row.
  std::int64_t integer(std::string_view sql);
  std::string text(std::string_view sql);
  /// The number of rows that the last statement changed.
  std::int64_t changes() const;

  sqlite3* handle() const { return handle_.get(); }
  [[noreturn]] void fail(int code) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

/// A transaction, rolled back unless it is committed.
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
