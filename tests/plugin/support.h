// A folder for plugin libraries that a test puts together.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/plugin/host.h"

#include "folder.h"

namespace elsie::plugin::test {

/// The library of a fixture (a source file in tests/plugin/broken), where it was built.
std::filesystem::path fixture(const std::string& name);

std::vector<std::byte> bytes_of(const std::filesystem::path& file);
void write(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write(const std::filesystem::path& file, std::string_view text);

/// A folder for libraries.
class Folder : public elsie::test::Folder {
 public:
  /// Copies fixtures into the folder; the first form under the same name.
  Folder& with(const std::string& name);
  Folder& with(const std::string& name, const std::string& file_name);
};

/// A host that looks into these folders.
template <class... Folders>
Host host_of(const Folders&... folders) {
  return Host({SearchDirectory{folders.path(), "given"}...});
}

/// What the report says of a file, by its name; fails when it says nothing.
FileReport report_of(const Host& host, const std::string& file_name);

/// Whether the file is in memory as a library.
bool is_loaded(const std::filesystem::path& file);

/// The wheel rates that a behaviour answers to nothing.
WheelRates answer(Behavior& behavior);

}  // namespace elsie::plugin::test
