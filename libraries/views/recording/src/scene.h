// The world as things that viewers draw (foxglove.SceneUpdate).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "elsie/recording/beams.h"
#include "elsie/simulation/simulation.h"

#include "format.h"

namespace elsie::recording {

/// Whether a box is drawn in a frame of its own, because it may move.
bool may_move(const world::Box& box);

/// Everything that there is now, instead of all that was there. Robots, what they pull, and boxes
/// that may move are in frames of their own, which transforms_message() moves.
Json scene_message(std::uint64_t time_ns, const simulation::Simulation& simulation);

/// Where all frames are.
Json transforms_message(std::uint64_t time_ns, const simulation::Simulation& simulation);

/// Beams as two lists of lines, a pair of points each: those that are free, and, red, those that
/// hit. The entity's metadata have a digit for each beam, in their order: 1 where it hit.
Json beams_message(std::uint64_t time_ns, std::span<const RangeBeam> beams);
constexpr const char* kHits = "hits";

}  // namespace elsie::recording
