// Where plugin libraries are looked for.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace elsie::plugin {

/// Name of the environment variable: directories separated by colons; empty ones are passed over.
inline constexpr const char* kPluginPathVariable = "ELSIE_PLUGIN_PATH";

struct SearchDirectory {
  std::filesystem::path path;  // or that of one library
  std::string origin;  // who asked for it: "given", "ELSIE_PLUGIN_PATH", "beside the program"...
  std::filesystem::path source = {};  // of a library that was compiled from one file: what messages
                                      // name in its place; else empty
};

/// The directories in the order in which they count: `given` (on the command line), those of the
/// environment variable, `../lib/elsie/plugins` seen from the program, `elsie/plugins` seen from
/// libelsie. One that is there twice is left out the second time. Directories that do not exist are
/// kept, so that a report can say so. This is the only place that reads the environment.
std::vector<SearchDirectory> default_search_path(std::span<const std::filesystem::path> given = {});

}  // namespace elsie::plugin
