// Paths to attributes of a world: "robot[r1]/behavior[avoid_obstacle]/@priority".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// A step of a path: NAME, NAME[ID], NAME[NUMBER] (from 1), NAME[*] or NAME[ATTRIBUTE=VALUE]. The
/// last step may also be NAME[+] or NAME[+NUMBER], for an element that is to be added.
struct PathStep {
  std::string name;
  std::string key;  // "" when there is none

  bool adds() const { return key.starts_with('+'); }
  bool selects_by_value() const { return key.find('=') != std::string::npos; }
};

struct Path {
  std::vector<PathStep> steps;  // from the root, which is left out
  std::string attribute;        // "" when the path leads to an element
  bool from_attribute = false;  // the path ends in /@ATTRIBUTE/@remove; `attribute` is the former

  bool adds() const { return !steps.empty() && steps.back().adds(); }
};

/// Parses a path. Throws std::invalid_argument with a sentence.
Path parse_path(std::string_view text);

/// An element and its entry in the vocabulary, which is nested_element() if a plugin declares it.
struct Node {
  Element* element;
  const ElementSpec* spec;
};
const ElementSpec& nested_element();

/// Inserts an element that may occur only once into its parent, in the order of the vocabulary.
Element& add_in_order(const Node& parent, Element child);

/// Adds an element, as the last step of a path says, to each of the elements that the steps before
/// it lead to. Creates a missing list. Throws std::invalid_argument with a sentence.
void add_element(const std::vector<Node>& parents, const PathStep& step, const Element& given);

/// The elements that a path leads to: at least one, unless a step selects by an attribute's value,
/// or a robot's template could not be read.
///
/// Groups may be left out: a step names a member by its element or by the group's word for its
/// members ("sensor" for any child of <sensors>, "obstacle", "goal" ...); "coordinator" is the one
/// child of <coordinator>. Elements that a plugin declares have their own names, and the content of
/// a behaviour is named as in a robot. A path that begins with a part of a robot means that part of
/// every robot. A missing element that may occur only once is created. Throws
/// std::invalid_argument with a sentence that lists what exists instead.
std::vector<Node> find_nodes(Element& world, const Path& path);

}  // namespace elsie::world
