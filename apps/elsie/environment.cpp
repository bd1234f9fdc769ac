#include "environment.h"

#include <csignal>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stop_token>
#include <string_view>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "elsie/base/number_text.h"
#include "elsie/plugin/script.h"
#include "elsie/process/run_process.h"
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
                  "Plugin library, a plugin's one source file (.cpp), which is compiled first, or "
                  "one in Python (.py); comes before all others; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
}

std::vector<std::string> PluginOptions::words() const {
  std::vector<std::string> words;
  for (const std::string& directory : directories) {
    words.insert(words.end(), {"--plugin-path", directory});
  }
  for (const std::string& file : files) {
    words.insert(words.end(), {"--plugin", file});
  }
  return words;
}

namespace {

/// True if a debugger is at work, which may stop the program for any time.
bool is_traced() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("TracerPid:")) {
      return line.find_first_of("123456789") != std::string::npos;
    }
  }
  return false;
}

/// A --plugin, if it is a library, a source or a script.
fs::path checked(const std::string& file) {
  if (!build::is_source(file)) {
    if (!plugin::may_hold_plugins(file)) {
      throw BadInput("--plugin: '" + file +
                     "' should be a plugin library (.so), the source of one (.cpp), or a script "
                     "with plugins (.py)");
    }
    std::error_code error;  // of a link that leads back to itself, for example
    if (!fs::is_regular_file(file, error)) {
      throw BadInput("--plugin: there is no file '" + file + "'");
    }
  }
  return file;
}

/// A library that was named on the command line must be usable.
void require_loaded(const plugin::Host& host, const std::vector<std::string>& files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (const auto& file : host.report().directories[i].files) {
      if (file.status != plugin::FileStatus::loaded) {
        throw BadInput("--plugin: '" + files[i] + "' " + file.sentence);
      }
    }
  }
}

/// The places of plugins; sources are not compiled yet.
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
  const bool warns = spdlog::should_log(spdlog::level::warn);
  StatusLine line(warns);
  auto built = build::build_source(source, build::cache_directory(), {}, [&] {
    line.draw("compiling " + source.filename().string() + " ...");
  });
  wipe_status();
  if (warns) {
    std::cerr << built.warnings;
  }
  return built;
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

namespace {

/// The report of a process that crashed or was stopped while it loaded the file; "" if it ended.
/// Without the name in its first line, which may follow what the plugin has printed.
std::string try_to_load(const fs::path& file, const fs::path& known_as,
                        const std::stop_token& stop) {
  const auto ended = process::run_process({"/proc/self/exe", kLoadCommand, file.string(),
                                           known_as.string(), base::number_text(kLongestLoading_s)},
                                          stop, SIGKILL);
  constexpr int kBySignal = 128;
  if (!ended || (ended->exit_code != kPluginFailed && ended->exit_code < kBySignal)) {
    return "";
  }
  const std::string said = ended->output.substr(0, ended->output.find_last_not_of('\n') + 1);
  const std::string name = "elsie: plugin library '" + known_as.string() + "' ";
  const std::size_t at = said.find(name);
  return at == said.npos ? "could not be loaded by a process of its own\n" + said
                         : said.substr(at + name.size());
}

}  // namespace

std::unique_ptr<build::Watch> watch_plugins(const PluginOptions& options,
                                            const std::vector<fs::path>& drafts) {
  search_path(options);  // sources are compiled and in the cache then
  const LoadingLimit limit;
  auto watch = std::make_unique<build::Watch>(places_of(options), build::Watch::kPeriod, drafts,
                                              try_to_load);
  require_loaded(watch->host(), options.files);
  tell(watch->host().report());
  return watch;
}

int load_alone(const fs::path& file, const fs::path& known_as, double longest_s) {
  const LoadingLimit limit(longest_s);
  static const plugin::Host host({{file, "given", known_as}});  // never unloaded
  if (getpgrp() == getpid()) {
    std::signal(SIGTERM, SIG_IGN);
    kill(0, SIGTERM);
  }
  return kSuccess;
}

std::vector<std::string> data_directories() { return world::default_data_directories(); }

world::ReadOptions read_options(const std::vector<std::string>& edits, std::uint64_t seed) {
  world::ReadOptions options;
  options.seed = seed;
  options.edits = edits;
  options.data_directories = data_directories();
  options.check_plugins = true;
  return options;
}

std::vector<fs::path> read_files(const std::string& world,
                                 const std::map<std::string, std::string>& found,
                                 const PluginOptions& plugins) {
  std::vector<fs::path> files{world};
  for (const auto& [name, file] : found) {
    files.emplace_back(file);
  }
  files.insert(files.end(), plugins.files.begin(), plugins.files.end());
  return files;
}

}  // namespace elsie::program
