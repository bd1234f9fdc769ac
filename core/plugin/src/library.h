// A loaded plugin library.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/declaration.h"

#include "private_copy.h"

namespace elsie::plugin {

/// Keeps a library loaded until it is destroyed. All objects of the library's code must be
/// destroyed before.
class Library {
 public:
  struct System;  // what Boost.DLL knows of it

  Library(std::unique_ptr<System> system, std::string file, std::unique_ptr<PrivateCopy> copy);
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library();

  /// The file that messages name: the library, or the source that it was compiled from.
  const std::string& file() const { return file_; }

 private:
  std::unique_ptr<PrivateCopy> copy_;  // goes after what is loaded of it
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
};

/// Loads a file that was inspected and found to be a plugin library with this ABI word, and has it
/// declare its plugins. `known_as`: the file that crash reports name. `as_copy`: not the file
/// itself but a private copy, so that the file may be replaced. Throws nothing because of what the
/// library does, short of crashing.
LoadedLibrary load_library(const std::filesystem::path& file, const std::string& known_as,
                           std::string_view abi_word, bool as_copy);

}  // namespace elsie::plugin
