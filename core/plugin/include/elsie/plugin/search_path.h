// Where the host searches for plugin libraries.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace elsie::plugin {

/// The environment variable: directories separated by colons; empty ones are ignored.
inline constexpr const char* kPluginPathVariable = "ELSIE_PLUGIN_PATH";

struct SearchDirectory {
  std::filesystem::path path;         // a directory, or one library
  std::string origin;                 // "given", "ELSIE_PLUGIN_PATH", "next to the program"...
  std::filesystem::path source = {};  // of a library compiled from one file: messages name this
};

/// A list of directories without duplicates, in the order of first additions.
class DirectoryList {
 public:
  void add(const std::filesystem::path& directory, const std::string& origin);
  /// Adds the directories of an environment variable, separated by colons.
  void add_variable(const char* name);
  /// Adds `../below` seen from the folder of the running program, if there is such a directory.
  void add_beside_program(const std::filesystem::path& below);
  std::vector<SearchDirectory> take() && { return std::move(directories_); }

 private:
  std::vector<std::filesystem::path> canonical_;
  std::vector<SearchDirectory> directories_;
};

/// The directories in the order in which they are searched: `given` (on the command line), those of
/// the environment variable, `../lib/elsie/plugins` seen from the program, `elsie/plugins` seen
/// from libelsie. Directories that do not exist are kept, so that a report can name them. Only this
/// function reads the variable.
std::vector<SearchDirectory> default_search_path(std::span<const std::filesystem::path> given = {});

}  // namespace elsie::plugin
