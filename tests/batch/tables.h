// Reads a database of results.
#pragma once

#include <stdexcept>
#include <string>

#include <sqlite3.h>

namespace elsie::test {

/// The rows of a query as text: columns separated by |, a row on each line; null is "null".
inline std::string rows(const std::string& file, const std::string& sql) {
  sqlite3* handle = nullptr;
  std::string text;
  std::string problem;
  if (sqlite3_open(file.c_str(), &handle) == SQLITE_OK) {
    const auto add = [](void* to, int columns, char** values, char**) {
      for (int i = 0; i < columns; ++i) {
        *static_cast<std::string*>(to) +=
            std::string(i > 0 ? "|" : "") + (values[i] ? values[i] : "null");
      }
      *static_cast<std::string*>(to) += '\n';
      return 0;
    };
    sqlite3_exec(handle, sql.c_str(), add, &text, nullptr);
  }
  if (sqlite3_errcode(handle) != SQLITE_OK) {
    problem = sqlite3_errmsg(handle);
  }
  sqlite3_close(handle);
  if (!problem.empty()) {
    throw std::runtime_error(problem + ": " + sql);
  }
  return text;
}

/// Everything in a database except what depends on the clock: when runs ended, and how long they
/// took.
inline std::string all_tables(const std::string& file) {
  std::string text;
  for (const char* table :
       {"about", "factors", "stages", "files", "plugins", "cells", "cell_levels", "cell_plugins",
        "cell_files", "runs", "measures", "run_measures", "run_robots", "run_events",
        "trajectories", "curves", "timelines", "notes"}) {
    std::string columns;
    const std::string name(table);
    const std::string names = rows(file, "SELECT name FROM pragma_table_info('" + name + "')");
    for (std::size_t at = 0; at < names.size();) {
      const std::size_t end = names.find('\n', at);
      const std::string column = names.substr(at, end - at);
      at = end + 1;
      if (column != "ended" && column != "wall_s" && column != "created" && column != "log") {
        columns += (columns.empty() ? "" : ", ") +
                   (column == "content" ? std::string("hex(content)") : column);
      }
    }
    text += name + "\n" + rows(file, "SELECT " + columns + " FROM " + name + " ORDER BY 1, 2");
  }
  return text;
}

}  // namespace elsie::test
