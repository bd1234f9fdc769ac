// Paths to attributes of a world: "robot[r1]/behavior[avoid_obstacle]/@priority".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// NAME, NAME[ID], NAME[NUMBER] (from 1) or NAME[*]; at the end of a path also NAME[+] or
/// NAME[+NUMBER], an element that is to be added.
struct PathStep {
  std::string name;
  std::string key;  // "" when there is none

  bool adds() const { return key.starts_with('+'); }
};

struct Path {
  std::vector<PathStep> steps;  // from the root, which is not named
  std::string attribute;        // "" when the path leads to an element
  bool from_attribute = false;  // it ends with /@ATTRIBUTE/@remove, and `attribute` is the first

  bool adds() const { return !steps.empty() && steps.back().adds(); }
};

/// Throws std::invalid_argument with a sentence.
Path parse_path(std::string_view text);

/// An element and its entry in the vocabulary: nested_element() for one that a plugin declares.
struct Place {
  Element* element;
  const ElementSpec* spec;
};
const ElementSpec& nested_element();

/// Puts an element that its parent holds once among the others, in the order of the vocabulary.
Element& add_in_order(const Place& parent, Element child);

/// Adds an element as the last step of a path says, to each element that the steps before it lead
/// to; a missing list is made. Throws std::invalid_argument with a sentence.
void add_element(Element& world, const Path& path, const Element& given);

/// The elements that the steps lead to. There is at least one, unless a robot's template could not
/// be read.
///
/// Groups may be left out: a member is called by its element's name or by its group's word for
/// it ("sensor" for any child of <sensors>, "obstacle", "goal" ...); "coordinator" is the one child
/// of <coordinator>. Elements that a plugin declares are called by their names, and what a
/// behaviour holds is called as in a robot. A path that begins with a part of a robot means that
/// part of every robot. An element that may stand only once is made when it is missing. Throws
/// std::invalid_argument with a sentence that says what is there instead.
std::vector<Place> find_places(Element& world, const Path& path);

}  // namespace elsie::world
