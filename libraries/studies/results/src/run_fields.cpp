#include "elsie/results/run_fields.h"

#include <type_traits>

#include "elsie/results/sqlite.h"

namespace elsie::results {
namespace {

struct Binder {
  sqlite::Statement& statement;
  int& place;

  void operator()(const char*, RunState state) { statement.bind(place++, to_string(state)); }
  void operator()(const char*, const std::optional<Outcome>& outcome) {
    outcome ? statement.bind(place, simulation::to_string(*outcome)) : statement.bind_null(place);
    ++place;
  }
  template <class Value>
  void operator()(const char*, const Value& value) {
    statement.bind(place++, value);
  }
};

struct Reader {
  const sqlite::Statement& statement;
  int column;

  void operator()(const char*, RunState& state) { state = run_state(statement.text(column++)); }
  void operator()(const char*, std::optional<Outcome>& outcome) {
    outcome = outcome_of(statement.text(column++));
  }
  void operator()(const char*, std::string& text) { text = statement.text(column++); }
  void operator()(const char*, std::optional<std::string>& text) {
    text = statement.is_null(column) ? std::nullopt : std::optional(statement.text(column));
    ++column;
  }
  void operator()(const char*, std::optional<double>& number) {
    number = statement.optional_number(column++);
  }
  template <class Whole>
  void operator()(const char*, std::optional<Whole>& number) {
    const auto read = statement.optional_integer(column++);
    number = read ? std::optional(static_cast<Whole>(*read)) : std::nullopt;
  }
};

struct ColumnType {
  std::string operator()(RunState state) const {
    return std::string("TEXT NOT NULL DEFAULT '") + to_string(state) + "'";
  }
  std::string operator()(const std::string&) const { return "TEXT"; }
  template <class Value>
  std::string operator()(const std::optional<Value>&) const {
    return std::is_integral_v<Value>         ? "INTEGER"
           : std::is_floating_point_v<Value> ? "REAL"
                                             : "TEXT";
  }
};

}  // namespace

std::string field_names(const std::string& after) {
  std::string names;
  const RunFields any;
  for_each_field(any, [&](const char* name, const auto&) {
    names += (names.empty() ? "" : ", ") + (name + after);
  });
  return names;
}

std::string field_columns() {
  std::string columns;
  const RunFields initial;
  for_each_field(initial, [&](const char* name, const auto& value) {
    columns += std::string(columns.empty() ? "" : ", ") + name + ' ' + ColumnType()(value);
  });
  return columns;
}

std::optional<Outcome> outcome_of(const std::string& word) {
  for (const Outcome outcome : {Outcome::success, Outcome::failure, Outcome::time_limit}) {
    if (word == simulation::to_string(outcome)) {
      return outcome;
    }
  }
  return std::nullopt;
}

int bind_fields(sqlite::Statement& statement, int place, const RunFields& run) {
  for_each_field(run, Binder{statement, place});
  return place;
}

void read_fields(const sqlite::Statement& statement, int column, RunFields& run) {
  for_each_field(run, Reader{statement, column});
}

}  // namespace elsie::results
