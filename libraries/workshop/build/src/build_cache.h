// What sources were compiled to, on disk: a folder for each source and compiler.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "elsie/build/source_build.h"

#include "file_sight.h"

namespace elsie::build {

/// What one source was compiled to last, and from which contents.
class CacheEntry {
 public:
  /// `compiler`: the same text for the same result from the same source. Throws plugin::PluginError
  /// when the folder cannot be made.
  CacheEntry(const std::filesystem::path& source, const std::string& compiler,
             const std::filesystem::path& cache);

  /// The library, if nothing changed since.
  std::optional<SourceBuild> find() const;

  /// Where the compiler may write; another one for each process.
  std::filesystem::path scratch(const char* suffix) const;

  /// The files that the library was made from last time; none when there was none.
  std::vector<std::filesystem::path> last_inputs() const;

  /// Takes over the library that the compiler made of these files, as they were seen.
  SourceBuild keep(const std::filesystem::path& library, std::vector<std::filesystem::path> inputs,
                   const Sight& sight) const;

 private:
  void tidy(const std::filesystem::path& newest) const;

  std::filesystem::path cache_;
  std::filesystem::path folder_;
  std::string stem_;
};

}  // namespace elsie::build
