// Versions of one plugin library, made without a compiler.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "elsie/build/private_copy.h"
#include "elsie/plugin/host.h"

#include "folder.h"
#include "places.h"

namespace elsie::test {

/// A folder with the library of plugins/versioned.cpp, one version after the other in one file.
class Versions {
 public:
  /// The file is this version from now on. `mode`: see versioned.cpp. `in_place`: the file is
  /// overwritten; otherwise another one takes its name.
  void write(int number, char mode = '-', bool in_place = false) const {
    std::string bytes = original();
    const std::size_t at = bytes.find("elsie-stamp:");
    const std::string digits = std::to_string(10000 + number).substr(1);
    bytes.replace(at + 12, 4, digits);
    bytes[at + 17] = mode;
    write(bytes, in_place);
  }
  void write(const std::string& bytes, bool in_place = false) const {
    const std::filesystem::path to = in_place ? file() : folder / "new";
    std::ofstream(to, std::ios::binary | std::ios::trunc) << bytes;
    if (!in_place) {
      std::filesystem::rename(to, file());
    }
  }
  static std::string original() {
    std::ifstream in(build_path("tests/simulation/plugins/versioned.so"), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::filesystem::path file() const { return folder / "versioned.so"; }
  plugin::Host host() const { return plugin::Host({{folder, "given"}}, build::private_copy); }
  plugin::Host renewed(const plugin::Host& host) const { return host.renewed({{folder, "given"}}); }

  /// How many versions are in memory.
  static std::size_t loaded() {
    std::set<std::string> files;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
      if (const auto at = line.find('/');
          at != std::string::npos && line.find("/versioned.so") != std::string::npos) {
        files.insert(line.substr(at));
      }
    }
    return files.size();
  }

  const Folder own;
  const std::filesystem::path folder = own.path();
};

}  // namespace elsie::test
