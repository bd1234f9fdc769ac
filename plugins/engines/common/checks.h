// Checks of the engine's input.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

#include "elsie/api/body.h"
#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

namespace elsie::physics {

/// Throws std::invalid_argument with the sentence if the condition does not hold.
void require(bool holds, const std::string& sentence);
inline void require(bool holds, const char* sentence) {  // in each step: makes no string
  if (!holds) [[unlikely]] {
    throw std::invalid_argument(sentence);
  }
}

// These throw std::invalid_argument with a sentence about the first impossible thing.

void check(const world::Arena& arena, const world::Physics& physics);
void check(const Pose& pose, double z);
void check(const world::Obstacle& box);
/// Of a robot with so many joints that can be set.
void check(std::span<const JointSetting> settings, std::size_t joints);
/// Whether one robot more can hold a box that has `holders` of the `hands` that move it.
void check_hold(world::ObstacleKind kind, bool is_present, int holders, int hands);
/// The arguments of Engine::drive_obstacle() for an obstacle of this kind.
void check_drive(world::ObstacleKind kind, const Vector2& position, const Vector2& velocity);

}  // namespace elsie::physics
