// Where the program finds plugins and data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elsie/build/source_build.h"
#include "elsie/build/watch.h"
#include "elsie/plugin/host.h"
#include "elsie/process/crash_report.h"
#include "elsie/world/reader.h"

namespace CLI {
class App;
}

namespace elsie::program {

/// The options of every subcommand that needs plugins.
struct PluginOptions {
  std::vector<std::string> directories;
  std::vector<std::string> files;  // libraries, or sources to compile

  void add_to(CLI::App& command);
  /// The same as words of a command line.
  std::vector<std::string> words() const;
};

/// Compiles a plugin's source, unless the cache has it. On a terminal a line on standard error says
/// so as long as it takes, unless the log is set to errors only. Throws what build_source() throws.
build::SourceBuild compiled(const std::filesystem::path& source);

/// Where plugins are looked for: libraries given by name, those given as source after compiling
/// them, then directories. Throws BadInput for what was given on the command line and cannot be
/// used.
std::vector<plugin::SearchDirectory> search_path(const PluginOptions& options);

/// Loads the plugins, those given as source after compiling them; warnings go to the log, unless it
/// is set to errors only. Throws BadInput for what was given on the command line and cannot be
/// used. A library that takes longer than `longest_s` (s) to be loaded, as by a static constructor
/// that does not return, ends the program. None: there is a LoadingLimit already.
plugin::Host load_plugins(const PluginOptions& options, std::optional<double> longest_s = 30.0);
/// "did not return within 30 s and was stopped": what a process::Watchdog says of a plugin.
std::string late_text(double limit_s);

/// While it lives, a library that takes longer than that to be loaded or unloaded in this thread,
/// or to make or destroy an object, ends the program: it may never return. So does every other call
/// of a plugin whose clock was started. Not under a debugger. One at a time.
class LoadingLimit {
 public:
  explicit LoadingLimit(double longest_s = 30.0);

 private:
  std::string late_;
  std::optional<process::Watchdog> watchdog_;
};
/// The same, and follows the files from then on.
std::unique_ptr<build::Watch> watch_plugins(const PluginOptions& options);

/// world::default_data_directories()
std::vector<std::string> data_directories();

/// How worlds are read here: with the data directories, and every plugin asked about its
/// parameters. `seed`: the run's, for layouts.
world::ReadOptions read_options(const std::vector<std::string>& overrides = {},
                                std::uint64_t seed = 1);

}  // namespace elsie::program
