#include "environment.h"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "elsie/base/number_text.h"
#include "elsie/recording/formats.h"
#include "elsie/world/data_directories.h"

#include "command.h"
#include "status_line.h"

namespace elsie::program {

namespace fs = std::filesystem;

void PluginOptions::add_to(CLI::App& command) {
  command
      .add_option("--plugin-path", directories,
                  "Directory with plugin libraries, searched before all others; may be repeated")
      ->type_name("DIR")
      ->allow_extra_args(false);
  command
      .add_option("--plugin", files,
                  "Plugin library, or a plugin's one source file (.cpp), which is compiled first; "
                  "comes before all others; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
}

namespace {

/// Whether a debugger is at work, which may hold the program for as long as it likes.
bool is_traced() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("TracerPid:")) {
      return line.find_first_of("123456789") != std::string::npos;
    }
  }
  return false;
}

/// A --plugin, if it is a library or a source.
fs::path checked(const std::string& file) {
  if (!build::is_source(file)) {
    if (fs::path(file).extension() != ".so") {
      throw BadInput("--plugin: '" + file +
                     "' should be a plugin library (.so) or the source of one (.cpp)");
    }
    std::error_code error;  // of a link that leads back to itself, for example
    if (!fs::is_regular_file(file, error)) {
      throw BadInput("--plugin: there is no file '" + file + "'");
    }
  }
  return file;
}

/// A file that was asked for by name must be of use.
void require_loaded(const plugin::Host& host, const std::vector<std::string>& files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (const auto& file : host.report().directories[i].files) {
      if (file.status != plugin::FileStatus::loaded) {
        throw BadInput("--plugin: '" + files[i] + "' " + file.sentence);
      }
    }
  }
}

/// Where plugins are looked for; sources as they are given.
std::vector<plugin::SearchDirectory> places_of(const PluginOptions& options) {
  std::vector<fs::path> extra;
  for (const std::string& directory : options.directories) {
    std::error_code error;
    if (!fs::is_directory(directory, error)) {
      throw BadInput("--plugin-path: '" + directory + "' is not a directory");
    }
    extra.emplace_back(directory);
  }
  std::vector<plugin::SearchDirectory> places;
  for (const std::string& file : options.files) {
    places.push_back({checked(file), "--plugin"});
  }
  for (auto& directory : plugin::default_search_path(extra)) {
    places.push_back(std::move(directory));
  }
  return places;
}

void tell(const plugin::Report& report) {
  for (const std::string& warning : report.warnings) {
    spdlog::warn(warning);
  }
  for (const auto& directory : report.directories) {
    for (const auto& file : directory.files) {
      spdlog::debug("{}: {}", file.path.string(), file.sentence.empty() ? "loaded" : file.sentence);
    }
  }
}

}  // namespace

std::string late_text(double limit_s) {
  return "did not return within " + base::seconds_text(limit_s) + " and was stopped";
}

build::SourceBuild compiled(const fs::path& source) {
  const bool shown = isatty(STDERR_FILENO) != 0 && spdlog::should_log(spdlog::level::warn);
  bool drawn = false;
  const auto begins = [&] {
    if (shown) {
      draw_status("compiling " + source.filename().string() + " ...");
      drawn = true;
    }
  };
  const auto wipe = [&] {
    if (drawn) {
      wipe_status();
    }
  };
  try {
    auto built = build::build_source(source, build::cache_directory(), {}, begins);
    wipe();
    if (!built.warnings.empty() && spdlog::should_log(spdlog::level::warn)) {
      std::cerr << built.warnings;
    }
    return built;
  } catch (...) {
    wipe();
    throw;
  }
}

std::vector<plugin::SearchDirectory> search_path(const PluginOptions& options) {
  auto places = places_of(options);
  for (auto& place : places) {
    if (build::is_source(place.path)) {
      place.source = place.path;
      place.path = compiled(place.source).library;
    }
  }
  return places;
}

LoadingLimit::LoadingLimit(double longest_s) : late_(late_text(longest_s)) {
  if (!is_traced()) {
    watchdog_.emplace(longest_s, kPluginFailed, late_.c_str());
  }
}

plugin::Host load_plugins(const PluginOptions& options, std::optional<double> longest_s) {
  const auto places = search_path(options);
  std::optional<LoadingLimit> limit;
  if (longest_s) {
    limit.emplace(*longest_s);
  }
  plugin::Host host(places);
  require_loaded(host, options.files);
  tell(host.report());
  return host;
}

std::unique_ptr<build::Watch> watch_plugins(const PluginOptions& options) {
  search_path(options);  // what it compiles is in the cache then
  const LoadingLimit limit;
  auto watch = std::make_unique<build::Watch>(places_of(options));
  require_loaded(watch->host(), options.files);
  tell(watch->host().report());
  return watch;
}

std::vector<std::string> data_directories() { return world::default_data_directories(); }

world::ReadOptions read_options(const std::vector<std::string>& overrides) {
  world::ReadOptions options;
  options.overrides = overrides;
  options.data_directories = data_directories();
  options.check_plugins = true;
  return options;
}

experiment::ReadOptions experiment_options() {
  experiment::ReadOptions options;
  options.data_directories = data_directories();
  return options;
}

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

/// Devices such as /dev/stdout have no suffix, and nothing to lose.
bool is_device(const fs::path& file) {
  std::error_code error;
  return fs::is_character_file(file, error) || fs::is_fifo(file, error);
}

/// The start of a file that is there already; empty when there is none.
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

/// Whether what a file begins with is what this program writes under such a name.
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
  return start.rfind("run,cell,seed,", 0) == 0;  // a table, by the first of its columns
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
  throw BadInput(std::string(option) + ": '" + file.string() + "' is there already and is no " +
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
  if (!start.empty() && !(format && start.starts_with(format->mark))) {
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
