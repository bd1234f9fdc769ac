// Reading worlds in tests.
#pragma once

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/reader.h"

#include "places.h"
#include "plugins.h"

namespace elsie::test {

inline const std::string kFolder = source_path("tests/world/");

inline const plugin::Host& host() {
  static const plugin::Host host = make_host();
  return host;
}

inline world::ReadOptions options(std::vector<std::string> edits = {}) {
  world::ReadOptions options;
  options.edits = std::move(edits);
  options.data_directories = {kFolder + "data"};
  options.check_plugins = true;
  return options;
}

/// A world with this inside of <world>; it is called world.xml and lies in tests/world/.
inline world::World read(const std::string& content, std::vector<std::string> edits = {}) {
  return world::parse_world("<world format=\"1\">" + content + "</world>", kFolder + "world.xml",
                            host(), options(std::move(edits)));
}

/// All that is wrong with such a world, a line each, without the folder; "" when nothing is.
inline std::string problems(const std::string& content, std::vector<std::string> edits = {}) {
  try {
    read(content, std::move(edits));
    return "";
  } catch (const world::WorldError& error) {
    std::string text = error.what();
    for (std::size_t at; (at = text.find(kFolder)) != std::string::npos;) {
      text.erase(at, kFolder.size());
    }
    return text;
  }
}

inline std::string text_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace elsie::test
