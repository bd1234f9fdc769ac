#include "output_files.h"

#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

#include "elsie/recording/formats.h"

#include "command.h"

namespace elsie::program {

namespace fs = std::filesystem;

void require_writable(const fs::path& file, const char* option) {
  const std::string what = std::string(option) + ": cannot write '" + file.string() + "': ";
  std::error_code error;
  if (file.empty() || fs::is_directory(file, error)) {
    throw BadInput(what + (file.empty() ? "the name of a file is missing" : "it is a directory"));
  }
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw BadInput(what + "there is no folder '" + folder.string() + "'; make it first");
  }
  const bool exists = fs::exists(file, error);
  if (access(exists ? file.c_str() : folder.c_str(), W_OK) != 0) {
    throw BadInput(what + "permission denied");
  }
}

namespace {

/// Devices such as /dev/stdout have no suffix, and no contents to lose.
bool is_device(const fs::path& file) {
  std::error_code error;
  return fs::is_character_file(file, error) || fs::is_fifo(file, error);
}

/// The start of an existing file; empty if there is none.
std::string start_of(const fs::path& file) {
  std::error_code error;
  std::string start;
  if (fs::is_regular_file(file, error)) {
    start.resize(1024);
    std::ifstream in(file, std::ios::binary);
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(in.gcount()));
  }
  return start;
}

bool has(const std::string& start, std::string_view word) {
  return start.find(word) != std::string::npos;
}

/// True if a file that begins like this is one that this program writes with this suffix.
bool is_what_its_name_says(const std::string& start, const std::string& suffix) {
  if (suffix == ".png") {
    return start.rfind("\x89PNG", 0) == 0;
  }
  if (suffix == ".svg") {
    return has(start, "<svg");
  }
  if (suffix == ".html") {
    return has(start, "<!doctype html") || has(start, "<!DOCTYPE html") || has(start, "<html");
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

/// ".csv" alone is the name of a hidden file without a suffix.
void require_name(const fs::path& file, const char* option, std::string_view suffix) {
  if (file.filename() == suffix) {
    throw BadInput(std::string(option) + ": '" + file.string() +
                   "' lacks a name before its suffix; expected one such as run" +
                   std::string(suffix));
  }
}

[[noreturn]] void refuse_other(const fs::path& file, const char* option, const std::string& kind) {
  throw BadInput(std::string(option) + ": '" + file.string() + "' already exists and is not a " +
                 kind + "; remove it or choose another name");
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
  require_writable(file, option);
  const std::string start = start_of(file);
  if (!start.empty() && !is_what_its_name_says(start, file.extension().string())) {
    refuse_other(file, option, kind);
  }
}

void require_recording(const fs::path& file, const char* option) {
  for (const recording::Format& format : recording::formats()) {
    require_name(file, option, format.suffix);
  }
  const recording::Format* format = recording::format_of(file);
  if (!format && !is_device(file)) {
    throw BadInput(std::string(option) + ": a recording's name must end in " +
                   recording::suffixes(" or ") + ", but '" + file.string() + "' does not");
  }
  require_writable(file, option);
  const std::string start = start_of(file);
  if (!start.empty() && !(format && start.starts_with(format->mark) && has(start, format->maker))) {
    refuse_other(file, option, "recording");
  }
}

void require_picture(const fs::path& file, const char* option) {
  require_name(file, option, ".png");
  require_name(file, option, ".svg");
  if (file.extension() != ".png" && file.extension() != ".svg") {
    throw BadInput(std::string(option) + ": a picture's name must end in .png or .svg, but '" +
                   file.string() + "' does not");
  }
  require_replaceable(file, option, "picture");
}

}  // namespace elsie::program
