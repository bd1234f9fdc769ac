// A loaded plugin library.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/plugin/host.h"

namespace elsie::plugin {

/// Keeps a library loaded until it is destroyed. All objects of the library's code must be
/// destroyed before.
class Library {
 public:
  struct System;  // the library in Boost.DLL

  /// `kept`: its private copy, or null; released last.
  Library(std::unique_ptr<System> system, std::string file, std::shared_ptr<const void> kept);
  /// A script; `kept`: its classes.
  Library(std::string file, std::shared_ptr<const void> kept);
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library();

  /// The file that messages name: the library, or the source that it was compiled from.
  const std::string& file() const { return file_; }

 private:
  std::shared_ptr<const void> kept_;
  std::unique_ptr<System> system_;
  std::string file_;
};

/// The result of loading a library. Declarations hold functions of the library and are destroyed
/// before it.
struct LoadedLibrary {
  std::shared_ptr<const Library> library;
  std::vector<Declaration> declarations;
  std::string problem;  // a sentence if it was refused; then it is not loaded any more
  std::string warning;  // a sentence on a side effect of loading it; or ""
  std::string missing;  // of a script: a sentence, if there is no interpreter
};

/// Loads a file that was inspected and found to be a plugin library with this ABI word, and has it
/// declare its plugins. `known_as`: the file that crash reports name. `make_copy`: makes the copy
/// to load, or empty. Never throws because of the library; a library can still crash the process.
LoadedLibrary load_library(const std::filesystem::path& file, const std::string& known_as,
                           std::string_view abi_word, const MakeCopy& make_copy);

/// Whether a script has a class that is a plugin, by its text. Throws std::runtime_error when it
/// cannot be read.
bool declares_plugins(const std::filesystem::path& script);
/// Runs a script and has its plugins declared, if `make_copy` lets it. Never throws because of it.
LoadedLibrary load_script(const std::filesystem::path& file, const MakeCopy& make_copy);

}  // namespace elsie::plugin
