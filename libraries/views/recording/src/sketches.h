// What plugins draw, as scenes for viewers (foxglove.SceneUpdate), and read back from them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/sketch.h"
#include "elsie/simulation/simulation.h"

#include "format.h"

namespace elsie::recording {

/// An entity for each plugin, which vanishes after its lifetime if no other message renews it:
/// lines as one list for each role, points as spheres, arrows and texts. Its metadata list the
/// marks, so that they can be read back. `whose`: the robot, or "measures".
Json sketches_message(std::uint64_t time_ns, std::uint64_t lifetime_ns, const std::string& whose,
                      std::span<const simulation::PluginSketch> sketches);

/// The sketches of a message, in the world's frame, without their plugins. Throws Json::exception
/// or Unexpected for a message that Elsie did not write.
std::vector<Sketch> sketches_of(const Json& message);

}  // namespace elsie::recording
