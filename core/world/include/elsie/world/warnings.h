// Warns of settings that are allowed, but that the physics may not simulate well.
#pragma once

#include <string>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::world {

/// A likely problem in a run and the setting that causes it.
struct Warning {
  enum class About { physics, robot, box };
  About about = About::physics;
  std::size_t index = 0;  // of World::robots or World::boxes
  Location location;      // line 0: a default, or a world that was not read from a file
  std::string message;    // a sentence: what was found, its effect, sensible values

  /// "file:line: warning: message"
  std::string text() const;
};

/// Warns of contacts that are rigid (cfm or wheel_slip of 0) or so soft that bodies sink under
/// their own weight; an erp that overshoots; motors that overturn the robot; mass ratios beyond the
/// solver's precision; speeds at which a body passes through another in one step; moving boxes that
/// reach into walls; walls lower than wheels; robots that topple. A world without warnings may
/// still fail, and a world with warnings may run well.
std::vector<Warning> warnings(const World& world);

}  // namespace elsie::world
