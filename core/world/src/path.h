// Paths to attributes of a world: "robot[r1]/behavior[avoid_obstacle]/@priority".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/markup.h"
#include "elsie/world/problems.h"

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

/// The elements that the steps lead to, at least one; none only where a robot's template could not
/// be read.
///
/// The groups may be left out: a member is called by its element's name or by its group's word for
/// it ("sensor" for any child of <sensors>, "obstacle", "goal" ...); "coordinator" is the one child
/// of <coordinator>. Elements that a plugin declares are called by their names, and what a
/// behaviour holds as in a robot. What belongs to a robot means that of every robot when no robot
/// is named. An element that may stand only once and is not there is made (Element::kMade). Throws
/// std::invalid_argument with a sentence that says what is there instead.
std::vector<Element*> select(Element& world, const Path& path);

/// Whether an override must come before templates are merged: that of a robot's template, and those
/// that replace robots.
bool concerns_templates(const std::string& override);

/// Sets "PATH=VALUE" in the tree of a world, whose ids are complete.
void apply_override(Element& world, const std::string& override, Problems& problems);

}  // namespace elsie::world
