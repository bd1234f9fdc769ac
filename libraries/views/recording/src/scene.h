// The world as a scene for viewers (foxglove.SceneUpdate).
#pragma once

#include <cstdint>
#include <span>

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

}  // namespace elsie::recording
