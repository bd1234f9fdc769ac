// Compiles a plugin of one source file without a build system.
//
//   const build::SourceBuild built = build::build_source("my_behavior.cpp");
//   plugin::Host host({{built.library, "my_behavior.cpp"}});
//
// Uses the system's compiler ($CXX, else c++) with the headers and the library of this program:
// optimised, with line numbers for crash reports. The flags of $CXXFLAGS and $LDFLAGS come after
// our own and so override them; libraries (-lname, also those of $LDLIBS) come after the source.
//
// A cache keeps compiled libraries while the source, the headers that it includes, the compiler and
// libelsie are unchanged. A library is kept only if none of its files changed while the compiler
// ran; otherwise it is compiled again. The cache keeps the last kMostBuilds libraries of each
// source, and removes a source's libraries after kCacheDays days without use.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "elsie/plugin/error.h"

namespace elsie::build {

struct SourceBuild {
  /// The library. Its name depends on its content, so that old and new ones can be loaded together.
  std::filesystem::path library;
  /// The source and every header that it includes, except the system's: the files to watch.
  std::vector<std::filesystem::path> inputs;
  bool from_cache = false;
  /// The compiler's warnings; "" for a library from the cache.
  std::string warnings;
};

/// The compiler refused the source. what() has its messages unchanged, and a last line that says
/// what to do.
class BuildError : public plugin::PluginError {
 public:
  using plugin::PluginError::PluginError;
  std::string message() const override { return what(); }
};

/// Whether a file's name is one of C++ source: .cpp, .cc, .cxx.
bool is_source(const std::filesystem::path& file);

/// $ELSIE_CACHE, else elsie/ in $XDG_CACHE_HOME or ~/.cache, else elsie-NUMBER in the folder for
/// temporary files, with the user's number. $XDG_CACHE_HOME and $HOME count if they are absolute.
std::filesystem::path cache_directory();

/// The number of libraries kept of one source.
inline constexpr std::size_t kMostBuilds = 16;
/// Libraries of a source that was not used for so many days are removed when another is compiled.
inline constexpr int kCacheDays = 60;

/// Compiles the source unless the cache has it. `stop` ends the compiler. `begins` is called before
/// it starts, and not for a library from the cache. Throws BuildError, also when it was stopped,
/// and when its files were saved during every one of a few attempts; plugin::PluginError when there
/// is no such file, no compiler, no headers, or no folder to write to, and when users other than
/// this one and root could write to the cache or replace it.
SourceBuild build_source(const std::filesystem::path& source,
                         const std::filesystem::path& cache = cache_directory(),
                         const std::stop_token& stop = {},
                         const std::function<void()>& begins = {});

}  // namespace elsie::build
