#include "damage.h"

#include <algorithm>
#include <utility>

#include "elsie/results/hash.h"

namespace elsie::results {
namespace {

// Tables and columns with lists of JSON.
constexpr std::pair<const char*, const char*> kLists[] = {{"trajectories", "poses"},
                                                          {"trajectories", "touches"},
                                                          {"curves", "points"},
                                                          {"timelines", "behaviors"},
                                                          {"timelines", "episodes"}};

std::optional<std::string> broken_structure(sqlite::Connection& connection) {
  if (std::string found = connection.text("PRAGMA integrity_check(1)"); found != "ok") {
    std::replace(found.begin(), found.end(), '\n', ' ');  // "*** in database main ***\n..."
    return found;
  }
  sqlite::Statement keys(connection, "PRAGMA foreign_key_check");
  if (keys.next()) {
    return "a row of `" + keys.text(0) + "` names one of `" + keys.text(2) + "` that is not there";
  }
  return std::nullopt;
}

std::optional<std::string> broken_list(sqlite::Connection& connection, const std::string& table,
                                       const std::string& column) {
  sqlite::Statement rows(connection, "SELECT run_id FROM " + table + " WHERE CASE json_valid(" +
                                         column + ") WHEN 1 THEN json_type(" + column +
                                         ") <> 'array' ELSE 1 END LIMIT 1");
  return rows.next() ? std::optional("in `" + table + "` of run " +
                                     std::to_string(rows.integer(0)) + " a text is not a JSON list")
                     : std::nullopt;
}

std::optional<std::string> broken_text(sqlite::Connection& connection, const char* rows,
                                       const char* what) {
  sqlite::Statement texts(connection, rows);
  while (texts.next()) {
    if (sha256(texts.bytes(1)) != texts.bytes(2)) {
      return std::string(what) + " '" + texts.text(0) + "' does not match its hash";
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> damage(sqlite::Connection& connection) {
  if (auto found = broken_structure(connection)) {
    return found;
  }
  for (const auto& [table, column] : kLists) {
    if (auto found = broken_list(connection, table, column)) {
      return found;
    }
  }
  if (auto found = broken_text(connection, "SELECT label, world_text, sha256 FROM cells",
                               "the world of cell")) {
    return found;
  }
  if (auto found = broken_text(connection,
                               "SELECT label || ', seed ' || seed, layouts.world_text, "
                               "layouts.sha256 FROM layouts JOIN cells ON cells.id = cell_id",
                               "the world of cell")) {
    return found;
  }
  return broken_text(connection,
                     "SELECT path, content, sha256 FROM files WHERE content IS NOT NULL",
                     "the content of");
}

}  // namespace elsie::results
