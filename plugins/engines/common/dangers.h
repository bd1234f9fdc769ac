// Settings that more than one engine warns of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/warnings.h"

namespace elsie::physics {

// Each returns the sentence of a warning, if there is one. `name` begins it, and `effect` is what
// the engine makes of it: ", and topples".

/// Of a body that moves more than half of its size in a step.
std::optional<std::string> danger_of_speed(const std::string& name, double speed_m_s, double size_m,
                                           double step_s, const std::string& effect);
/// Of a robot whose middle is high above a narrow base.
std::optional<std::string> danger_of_height(const std::string& name, const world::Robot& robot,
                                            const std::string& effect);
/// Of a moving box whose path reaches into a wall of the arena.
std::optional<std::string> danger_of_path(const world::World& world, const world::Obstacle& box,
                                          const std::string& effect);

/// Of parameters that only other engines than the world's have, and of their places.
void add_idle_parameters(const world::World& world, std::vector<world::Warning>& warnings);

}  // namespace elsie::physics
