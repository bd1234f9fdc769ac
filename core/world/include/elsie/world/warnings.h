// Warns of settings that are allowed, but that the physics may not simulate well.
#pragma once

#include <string>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::world {

/// A likely problem in a run and the setting that causes it.
struct Warning {
  enum class About { physics, robot, obstacle, no_effect };  // no_effect: harms nothing
  About about = About::physics;
  std::size_t index = 0;  // of World::robots or World::obstacles
  Location location;      // line 0: a default, or a world that was not read from a file
  std::string message;    // a sentence: what was found, its effect, sensible values

  /// "file:line: warning: message"
  std::string text() const;
};

/// The warnings of the world's engine. A world without warnings may still fail, and a world with
/// warnings may run well.
std::vector<Warning> warnings(const World& world);

/// The function that the library of an engine exports as `elsie_warn`: appends its warnings.
using EngineWarnings = void (*)(const World& world, std::vector<Warning>& warnings);

}  // namespace elsie::world
