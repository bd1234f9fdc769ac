// A world in memory as the tree of a file, so that paths have the same meaning in both.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// The tree of a world: every element, with the attributes that differ from their defaults. Lists
/// of the world and their members are completed when a path leads into them, so that a path among
/// many robots costs little. The world must outlive the tree, and not change.
class WorldTree {
 public:
  /// The meaning of an element.
  struct Meaning {
    const ElementSpec* spec = nullptr;  // null for an element that a plugin declares
    DescribedObject described;          // its object, and the index of that in its list
    std::size_t holder = 0;             // the Element::object of the element around it
    std::size_t number = 0;             // from 1, among the elements there that have no id
    const Robot* robot = nullptr;       // the robot that it belongs to, if any
    std::size_t robot_index = 0;        // of that robot in the world
    const PluginUse* use = nullptr;     // whose element it is, or is nested in; null if none
    std::optional<PluginKind> kind;     // of that plugin
    std::vector<std::size_t> nested;    // the way to it from PluginUse::elements, or empty
    bool is_listed = false;             // true: it has a meaning even without attributes
  };

  explicit WorldTree(const World& world);
  WorldTree(const WorldTree&) = delete;
  WorldTree& operator=(const WorldTree&) = delete;

  const World& world() const { return world_; }
  /// The root of the tree as far as it is complete.
  Element& begun() { return root_; }
  /// The root of the complete tree.
  Element& root();
  /// Completes an element; not what may be completed later inside it.
  void complete(Element& element);
  /// Begins a robot anew, whose object has moved.
  void renew_robot(std::size_t index);
  /// The tree as text. It is taken apart, so that only one robot at a time needs memory.
  std::string text() && { return text(root_, 0); }
  /// `element` must have an Element::object.
  const Meaning& meaning(const Element& element) const { return meanings_[*element.object]; }
  /// The path of such an element: "robot[r1]/sensor[2]"; "" for the root.
  std::string path(const Element& element) const { return path(*element.object); }

 private:
  Element begin(const ElementSpec& spec, Meaning meaning, const std::string& id);
  void add_children(Element& element, const ElementSpec& spec, const void* object,
                    const Meaning& meaning);
  void add_declared(Element& element, const Meaning& meaning, const std::vector<ElementUse>& uses);
  std::string path(std::size_t meaning) const;
  std::string text(Element& element, std::size_t depth);

  const World& world_;
  const Location file_;            // the place of what keeps none of its own; without a line
  std::vector<Meaning> meanings_;  // Element::object is an index into it
  Element root_;
};

/// The same element, complete if it is one of a WorldTree.
Element& completed(Element& element);

}  // namespace elsie::world
