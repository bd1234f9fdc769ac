// The attributes of a world in memory, by the paths that lead to them in its file.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/world/files.h"
#include "elsie/world/vocabulary.h"
#include "elsie/world/world_tree.h"

namespace elsie::world {

/// An attribute that a path leads to.
struct AttributePlace {
  std::string path;              // in full: "robot[r1]/behavior[roam]/@speed"
  std::string element;           // that has it: "wander"
  Field field;                   // its type and range
  const Robot* robot = nullptr;  // that it belongs to, if any
  /// The plugin whose element, or an element nested in it, has the attribute; or none.
  const PluginUse* use = nullptr;
  /// Of a parameter in an element of the plugin's: the place of that element among
  /// PluginUse::elements.
  std::optional<std::size_t> nested;
  /// The element's attributes that may change during a run.
  std::vector<std::string> live;
};

/// Finds attributes and reads texts for them. For one thread at a time.
class Attributes {
 public:
  /// The world and the host must outlive this object, and the world must not change. Data files are
  /// searched beside the world's file, in the current folder, then in `data_directories`; those in
  /// `files` by their names there.
  Attributes(const World& world, const plugin::Host& host,
             std::vector<std::string> data_directories = {},
             std::map<std::string, std::string> files = {})
      : world_(world),
        host_(host),
        files_(world.file, std::move(data_directories), "", std::move(files)) {}

  /// The attributes that a path leads to, at least one, in the order of the file. Paths are those
  /// of ReadOptions::overrides. Throws std::invalid_argument with a sentence that says what there
  /// is.
  std::vector<AttributePlace> find(std::string_view path) const;

  /// Reads a text as the reader of a world file does; a `file` parameter becomes an absolute path.
  /// Throws std::invalid_argument with a sentence: "expected a number at least 0".
  ParameterValue read(const AttributePlace& place, std::string_view text) const;

 private:
  AttributePlace place(const Element& element, const std::string& name) const;

  const World& world_;
  const plugin::Host& host_;
  Files files_;
  mutable std::optional<WorldTree> tree_;  // once it was needed
};

/// The ids of the robots that a path leads to, or to a part of which. Empty for a path to something
/// else, or to nothing.
std::vector<std::string> robots_at(const World& world, std::string_view path);

}  // namespace elsie::world
