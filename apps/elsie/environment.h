// Finds and loads the program's plugins and data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
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
  /// The same options as words of a command line.
  std::vector<std::string> words() const;
};

/// Compiles a plugin's source, unless the cache has it. On a terminal, a line on standard error
/// says so meanwhile, unless the log is set to errors only. Throws what build_source() throws.
build::SourceBuild compiled(const std::filesystem::path& source);

/// The places of plugins: libraries given by name, then those given as source (after compiling
/// them), then directories. Throws BadInput if something given on the command line cannot be used.
std::vector<plugin::SearchDirectory> search_path(const PluginOptions& options);

/// A library that takes longer to be loaded will never be.
inline constexpr double kLongestLoading_s = 30.0;

/// Loads the plugins, those given as source after compiling them; warnings go to the log, unless it
/// is set to errors only. Throws BadInput if something given on the command line cannot be used. A
/// library that takes longer than `longest_s` (s) to be loaded, for example in a static
/// constructor, ends the program. None: there is a LoadingLimit already.
plugin::Host load_plugins(const PluginOptions& options,
                          std::optional<double> longest_s = kLongestLoading_s);
/// A process::Watchdog's message about a plugin: "did not return within 30 s and was stopped".
std::string late_text(double limit_s);

/// While it lives, a library that takes longer than that to be loaded or unloaded in this thread,
/// or to make or destroy an object, ends the program: it may never return. The same holds for all
/// other plugin calls whose clock was started. Inactive under a debugger. Only one at a time.
class LoadingLimit {
 public:
  explicit LoadingLimit(double longest_s = kLongestLoading_s);

 private:
  std::string late_;
  std::optional<process::Watchdog> watchdog_;
};
/// Loads the plugins likewise, and follows their files from then on. What changes is loaded by a
/// process of its own first.
std::unique_ptr<build::Watch> watch_plugins(const PluginOptions& options,
                                            const std::vector<std::filesystem::path>& drafts = {});

/// The work of that process, kLoadCommand. Ends what the library has left behind.
int load_alone(const std::filesystem::path& file, const std::filesystem::path& known_as,
               double longest_s);

/// world::default_data_directories()
std::vector<std::string> data_directories();

/// The options with which the program reads worlds: with the data directories, and with every
/// plugin asked about its parameters. `seed` is the run's, for layouts.
world::ReadOptions read_options(const std::vector<std::string>& edits = {}, std::uint64_t seed = 1);

/// What a subcommand with a world reads, for files::require_apart(): the world's file, the files
/// that it names (`found`: see ReadOptions), and the plugins given by name.
std::vector<std::filesystem::path> read_files(const std::string& world,
                                              const std::map<std::string, std::string>& found,
                                              const PluginOptions& plugins);

}  // namespace elsie::program
