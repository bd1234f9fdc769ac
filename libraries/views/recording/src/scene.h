// The world as a scene for viewers (foxglove.SceneUpdate).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "elsie/recording/beams.h"
#include "elsie/simulation/simulation.h"

#include "format.h"

namespace elsie::recording {

/// True if a box may move and is therefore drawn in its own frame.
bool may_move(const world::Obstacle& box);

/// The whole current scene, which replaces the previous one. Robots, their segments, and boxes that
/// may move have their own frames, which transforms_message() moves. `robots`: places of those that
/// are shown.
Json scene_message(std::uint64_t time_ns, const simulation::Simulation& simulation,
                   std::span<const std::size_t> robots);

/// The places of their frames.
Json transforms_message(std::uint64_t time_ns, const simulation::Simulation& simulation,
                        std::span<const std::size_t> robots);

/// Beams as two lists of lines: free ones, and red ones that hit. The entity's metadata have a
/// digit for each beam, in their order: 1 if it hit.
Json beams_message(std::uint64_t time_ns, std::span<const RangeBeam> beams);
constexpr const char* kHits = "hits";

}  // namespace elsie::recording
