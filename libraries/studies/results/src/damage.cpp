#include "damage.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "elsie/results/hash.h"

namespace elsie::results {
namespace {

/// JSON with numbers only, or any.
enum class Content { numbers, any };

struct JsonColumn {
  const char* table;
  const char* column;
  Content content;
};
constexpr std::array<JsonColumn, 5> kJsonColumns{{{"trajectories", "poses", Content::numbers},
                                                  {"trajectories", "touches", Content::numbers},
                                                  {"curves", "points", Content::numbers},
                                                  {"timelines", "behaviors", Content::any},
                                                  {"timelines", "episodes", Content::any}}};

constexpr std::array<bool, 256> bytes_of(Content content) {
  std::array<bool, 256> allowed{};
  if (content == Content::numbers) {
    for (const char c : std::string_view("[]0123456789.,-+eE null")) {
      allowed[static_cast<unsigned char>(c)] = true;
    }
  } else {
    // JSON has no control characters; UTF-8 never has the bytes from 0xf5.
    for (std::size_t c = 0x20; c < 0xf5; ++c) {
      allowed[c] = true;
    }
  }
  return allowed;
}
constexpr std::array<bool, 256> kOfNumbers = bytes_of(Content::numbers);
constexpr std::array<bool, 256> kOfAny = bytes_of(Content::any);

/// Whether the text may be a JSON list: checks each byte, many times as fast as parsing.
bool may_be_list(std::string_view text, Content content) {
  const auto& allowed = content == Content::numbers ? kOfNumbers : kOfAny;
  return text.size() >= 2 && text.front() == '[' && text.back() == ']' &&
         std::all_of(text.begin(), text.end(),
                     [&](char c) { return allowed[static_cast<unsigned char>(c)]; });
}

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

std::optional<std::string> broken_list(sqlite::Connection& connection, const JsonColumn& column) {
  const std::string table = column.table;
  sqlite::Statement rows(connection,
                         "SELECT run_id, " + std::string(column.column) + " FROM " + table);
  while (rows.next()) {
    if (!may_be_list(rows.bytes(1), column.content)) {
      return "in `" + table + "` of run " + std::to_string(rows.integer(0)) +
             " stands what is no JSON list";
    }
  }
  return std::nullopt;
}

std::optional<std::string> broken_text(sqlite::Connection& connection, const char* rows,
                                       const char* what) {
  sqlite::Statement texts(connection, rows);
  while (texts.next()) {
    if (sha256(texts.bytes(1)) != texts.bytes(2)) {
      return std::string(what) + " '" + texts.text(0) + "' is not what its hash says";
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> damage(sqlite::Connection& connection) {
  if (auto found = broken_structure(connection)) {
    return found;
  }
  for (const JsonColumn& column : kJsonColumns) {
    if (auto found = broken_list(connection, column)) {
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
