// The cache of compiled sources on disk: a folder for each source and compiler.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "elsie/build/source_build.h"

#include "file_sight.h"

namespace elsie::build {

/// The last library of one source, with the hashes of the files that it was made from.
class CacheEntry {
 public:
  /// `compiler`: a text that identifies the compiler and its flags. Throws plugin::PluginError when
  /// the folder cannot be made, or when other users could change what is in it.
  CacheEntry(const std::filesystem::path& source, const std::string& compiler,
             const std::filesystem::path& cache);

  /// The library, if neither it nor what it was made from has changed since.
  std::optional<SourceBuild> find() const;

  /// A file for the compiler to write; each process has its own.
  std::filesystem::path scratch(const char* suffix) const;

  /// The files that the last library was made from; empty without one.
  std::vector<std::filesystem::path> last_inputs() const;

  /// Stores the library that the compiler made of these files, with their hashes.
  SourceBuild keep(const std::filesystem::path& library, std::vector<std::filesystem::path> inputs,
                   const Sight& sight) const;

 private:
  void tidy(const std::filesystem::path& newest) const;

  std::filesystem::path cache_;
  std::filesystem::path folder_;
  std::string stem_;
};

}  // namespace elsie::build
