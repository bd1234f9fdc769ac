// What the engine refuses to work with.
#pragma once

#include <string>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

namespace elsie::physics {

/// Throws std::invalid_argument with the sentence unless it holds.
void require(bool holds, const std::string& sentence);

// These throw std::invalid_argument with a sentence about the first thing that is impossible.

void check(const world::Arena& arena, const world::Physics& physics);
void check(const Pose& pose, double z);
void check(const world::Box& box);

}  // namespace elsie::physics
