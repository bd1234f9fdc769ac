// Settings of a world that are allowed, but that the physics cannot keep up with.
#pragma once

#include <string>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::world {

/// What is likely to go wrong in a run, and where it is set.
struct Warning {
  enum class About { physics, robot, box };
  About about = About::physics;
  std::size_t index = 0;  // of World::robots or World::boxes
  Location location;      // line 0: a default, or a world that was not read from a file
  std::string message;    // a sentence: what was found, what comes of it, what is sensible

  /// "file:line: warning: message"
  std::string text() const;
};

/// Looks for: contacts that are rigid (cfm or wheel_slip of 0) or so soft that bodies sink in under
/// their own weight; an erp that overshoots; motors that turn the robot over rather than its
/// wheels; masses that differ by more than the solver's precision allows; speeds that cross a body
/// in one step; moving boxes that reach into walls; walls that are lower than wheels; robots that
/// topple. A world without warnings may fail all the same, one with some may do well.
std::vector<Warning> warnings(const World& world);

}  // namespace elsie::world
