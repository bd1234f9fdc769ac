// The chargers and resources of a team.
#pragma once

#include <optional>
#include <string>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// Returns the position of the nearest charger that serves the team.
std::optional<Vector2> nearest_charger(const world::World& world, const std::string& team,
                                       const Vector2& place);
/// Returns the charging rate for the team at a place, units per second, or 0.
double charger_rate(const world::World& world, const std::string& team, const Vector2& place);
/// Returns whether a robot of the team may collect the obstacle.
bool may_collect(const std::string& team, const world::Obstacle& obstacle);

}  // namespace elsie::simulation
