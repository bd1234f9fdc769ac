// The attributes of a world in memory, by the paths that lead to them in its file.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/vocabulary.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

/// An attribute that a path leads to.
struct AttributePlace {
  std::string path;              // in full: "robot[r1]/behavior[roam]/@speed"
  std::string element;           // whose it is: "wander"
  Field field;                   // what may stand in it
  const Robot* robot = nullptr;  // that it belongs to; none for what belongs to no robot
  /// The plugin whose element it stands in, or in whose element that element stands; or none.
  const PluginUse* use = nullptr;
  /// Of a parameter in an element of the plugin's: the place of that element among
  /// PluginUse::elements.
  std::optional<std::size_t> nested;
  /// The attributes beside it that may change while a run goes on.
  std::vector<std::string> live;
};

/// Finds them, and understands texts that are given for them. For one thread at a time.
class Attributes {
 public:
  /// Both must stay where they are, and the world as it is, for as long as this lives. Data files
  /// are looked for beside the world's file, then in the current folder, then in
  /// `data_directories`.
  Attributes(const World& world, const plugin::Host& host,
             std::vector<std::string> data_directories = {});
  Attributes(Attributes&&) noexcept;
  Attributes& operator=(Attributes&&) noexcept;
  ~Attributes();

  /// The attributes that a path leads to, at least one, in the order of the file; paths are those
  /// of ReadOptions::overrides. Throws std::invalid_argument with a sentence that says what is
  /// there instead.
  std::vector<AttributePlace> find(std::string_view path) const;

  /// The value that a text stands for there, read as from a file: of a `file` parameter the
  /// absolute path. Throws std::invalid_argument with a sentence: "expected a number at least 0".
  ParameterValue read(const AttributePlace& place, std::string_view text) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The text that reads back as the same value.
std::string text_of(const ParameterValue& value);

}  // namespace elsie::world
