#include "output_files.h"

#include <string>
#include <string_view>

#include "command.h"

namespace elsie::program {

namespace fs = std::filesystem;

namespace {

bool has(std::string_view start, std::string_view word) {
  return start.find(word) != std::string_view::npos;
}

/// True if a file that begins like this is one of this kind that this program writes with this
/// suffix.
bool is_what_its_name_says(std::string_view start, const std::string& suffix,
                           const std::string& kind) {
  if (suffix == ".png") {
    return start.starts_with("\x89PNG");
  }
  if (suffix == ".svg") {
    return has(start, "<svg");
  }
  if (suffix == ".html") {
    return has(start, "<meta name=\"generator\" content=\"elsie " + kind + "\">");
  }
  if (suffix == ".xml") {
    return has(start, "<testsuites");
  }
  if (suffix == ".json") {
    return start.front() == '{' && has(start, "\"runs\"");
  }
  if (suffix == ".tex") {
    return has(start, "\\toprule") && has(start, "booktabs");
  }
  // A table, by the first of its columns.
  return start.starts_with("run,cell,seed,") || start.starts_with("cell,runs,successes,");
}

}  // namespace

void require_database_name(const fs::path& file, const char* option) {
  if (file.extension() != ".sqlite" && file.extension() != ".sqlite3" &&
      file.extension() != ".db") {
    throw BadInput(std::string(option) +
                   ": expected a name that ends in .sqlite, .sqlite3 or .db, but '" +
                   file.string() + "' does not");
  }
}

void require_replaceable(const fs::path& file, const char* option, const char* kind) {
  files::require_replaceable(file, option, kind, [&](std::string_view start) {
    return is_what_its_name_says(start, file.extension().string(), kind);
  });
}

void require_picture(const fs::path& file, const char* option) {
  files::require_stem(file, option, ".png");
  files::require_stem(file, option, ".svg");
  if (file.extension() != ".png" && file.extension() != ".svg") {
    throw BadInput(std::string(option) + ": a picture's name must end in .png or .svg, but '" +
                   file.string() + "' does not");
  }
  require_replaceable(file, option, "picture");
}

}  // namespace elsie::program
