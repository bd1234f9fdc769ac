// A plugin of one source file, compiled on the spot: no build system.
//
//   const build::SourceBuild built = build::build_source("my_behavior.cpp");
//   plugin::Host host({{built.library, "my_behavior.cpp"}});
//
// The system's compiler does it ($CXX, else c++), against the headers and the library that this
// program runs with: optimised, with line numbers for crash reports. The flags of $CXXFLAGS and
// $LDFLAGS come after our own and so prevail; libraries (-lname, also those of $LDLIBS) come after
// the source.
//
// What was compiled is kept in a cache: as long as the source, the headers it includes, the
// compiler and libelsie are the same, it is not compiled again. A library is kept only if no file
// that it was made from changed while the compiler ran; if one did, it is compiled again. Of each
// source the cache keeps the last kMostBuilds libraries, and nothing of what was not asked for in
// kCacheDays days.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "elsie/plugin/error.h"

namespace elsie::build {

struct SourceBuild {
  /// The library. Another content has another name, so that a new one can be loaded beside an old.
  std::filesystem::path library;
  /// The source and every header that it includes, but for the system's: what to watch.
  std::vector<std::filesystem::path> inputs;
  bool from_cache = false;
  /// What the compiler warned of when it made the library; "" for one from the cache.
  std::string warnings;
};

/// The compiler refused the source. what() has its messages as they are, and a last line that says
/// what was to be done.
class BuildError : public plugin::PluginError {
 public:
  using plugin::PluginError::PluginError;
  std::string message() const override { return what(); }
};

/// Whether a file's name says that it is C++ source: .cpp, .cc, .cxx.
bool is_source(const std::filesystem::path& file);

/// $ELSIE_CACHE, else elsie/ in $XDG_CACHE_HOME or ~/.cache, else in the folder for temporary
/// files.
std::filesystem::path cache_directory();

/// How many libraries of one source are kept.
inline constexpr std::size_t kMostBuilds = 16;
/// After how many days without use a source's libraries are removed, when another one is compiled.
inline constexpr int kCacheDays = 60;

/// Compiles the source unless the cache has it. `stop`: ends the compiler. `begins` is called
/// before it starts, and not at all for what the cache has. Throws BuildError, also when it was
/// stopped, and when its files were saved each of the few times that it was compiled;
/// plugin::PluginError when there is no such file, no compiler, no headers, or no place to write
/// to.
SourceBuild build_source(const std::filesystem::path& source,
                         const std::filesystem::path& cache = cache_directory(),
                         const std::stop_token& stop = {},
                         const std::function<void()>& begins = {});

}  // namespace elsie::build
