// Paths to attributes of a world: "robot[r1]/behavior[avoid_obstacle]/@priority".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// NAME, NAME[ID], NAME[NUMBER] (from 1) or NAME[*].
struct PathStep {
  std::string name;
  std::string key;  // "" when there is none
};

struct Path {
  std::vector<PathStep> steps;  // from the root, which is not named
  std::string attribute;        // "" when the path leads to an element
};

/// Throws std::invalid_argument with a sentence.
Path parse_path(std::string_view text);

/// An element and its entry in the vocabulary: nested_element() for one that a plugin declares.
struct Place {
  Element* element;
  const ElementSpec* spec;
};
const ElementSpec& nested_element();

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
