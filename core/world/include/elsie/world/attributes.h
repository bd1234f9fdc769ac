// The attributes of a world in memory, found by the same paths as in its file.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/world/files.h"
#include "elsie/world/vocabulary.h"
#include "elsie/world/world_tree.h"

namespace elsie::world {

/// An attribute that a path leads to, and its element's meaning.
struct AttributeTarget : WorldTree::Meaning {
  std::string path;                          // "robot[r1]/behavior[roam]/@speed"
  std::string element;                       // the name of its element: "wander"
  Field field;                               // its type and range
  const AttributeSpec* attribute = nullptr;  // null for a parameter of a plugin
  /// The element's attributes that may change during a run.
  std::vector<std::string> live;
};

/// Finds attributes, parses values for them, and sets them. Only one thread at a time may use it.
class Attributes {
 public:
  /// The world and the host must outlive this object. Only set() may change the world. Data files
  /// are searched in the folder of the world's file, in the current folder, then in
  /// `data_directories`. `files` maps names of data files to paths that are used without a search.
  Attributes(const World& world, const plugin::Host& host,
             std::vector<std::string> data_directories = {},
             std::map<std::string, std::string> files = {})
      : world_(world),
        host_(host),
        files_(world.file, std::move(data_directories), "", std::move(files)) {}

  /// The attributes that a path leads to, at least one, in the order of the file. The syntax of
  /// paths is that of ReadOptions::edits. Throws std::invalid_argument with a sentence that
  /// lists what exists.
  std::vector<AttributeTarget> find(std::string_view path) const;

  /// Parses a text like the reader of world files; a `file` parameter becomes an absolute path.
  /// Throws std::invalid_argument with a sentence: "expected a number at least 0".
  ParameterValue read(const AttributeTarget& target, std::string_view text) const;

  /// Sets an attribute to this value, as read() reads it. The world must not be const, and must not
  /// share the robot with a copy of the world.
  void set(const AttributeTarget& target, std::string_view text) const;

  /// To be called when a robot of the world has moved in memory.
  void renew_robot(std::size_t index) {
    if (tree_) tree_->renew_robot(index);
  }

  /// The ids of the robots that a path leads to, or whose parts it leads to. Empty if the path
  /// leads to something else, or to nothing.
  std::vector<std::string> robots_at(std::string_view path) const;

  /// The tree of the world, as far as paths have completed it.
  std::unique_ptr<WorldTree> take_tree() {
    tree();
    return std::move(tree_);
  }

 private:
  WorldTree& tree() const { return *(tree_ ? tree_ : tree_ = std::make_unique<WorldTree>(world_)); }
  AttributeTarget target(const Element& element, const std::string& name) const;

  const World& world_;
  const plugin::Host& host_;
  Files files_;
  mutable std::unique_ptr<WorldTree> tree_;  // made at the first use
};

}  // namespace elsie::world
