// Reads experiments in tests.
#pragma once

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "elsie/experiment/reader.h"

#include "../world/plugins.h"
#include "places.h"

namespace elsie::test {

inline const std::string kFolder = source_path("tests/experiment/");

inline const plugin::Host& host() {
  static const plugin::Host host = make_host();
  return host;
}

inline experiment::ReadOptions options() {
  experiment::ReadOptions options;
  options.data_directories = {source_path("tests/world/data")};
  return options;
}

/// A message without the path of the folder of these tests, or of the sources.
inline std::string without_folder(std::string text) {
  for (const std::string& folder : {kFolder, source_path("") + "/"}) {
    for (std::size_t at; (at = text.find(folder)) != std::string::npos;) {
      text.erase(at, folder.size());
    }
  }
  return text;
}

inline experiment::Experiment parse(std::string_view text) {
  return experiment::parse_experiment(text, kFolder + "experiment.xml", host(), options());
}

inline const std::string kArena = "<worlds><world file='data/arena.xml'/></worlds>";
inline const std::string kTwoWorlds =
    "<worlds><world file='data/arena.xml'/><world file='data/clutter.xml'/></worlds>";

/// Reads an experiment with this content, with one seed by default; it is named experiment.xml in
/// tests/experiment/.
inline experiment::Experiment read(const std::string& content) {
  const bool has_seeds = content.find("<seeds") != std::string::npos;
  return parse("<experiment format='1'>" + content + (has_seeds ? "" : "<seeds from='1' to='1'/>") +
               "</experiment>");
}

/// All problems of such an experiment, a line each, without the folder; "" if there are none.
inline std::string problems(const std::string& content) {
  try {
    read(content);
    return "";
  } catch (const world::WorldError& error) {
    return without_folder(error.what());
  }
}

inline std::string text_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace elsie::test
