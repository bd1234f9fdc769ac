// The chargers, nests and resources of a team.
#pragma once

#include <optional>
#include <string>

#include "elsie/api/perception.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// Returns the position of the nearest charger that serves the team.
std::optional<Vector2> nearest_charger(const world::World& world, const std::string& team,
                                       const Vector2& place);
/// Returns the charging rate for the team at a place, units per second, or 0.
double charger_rate(const world::World& world, const std::string& team, const Vector2& place);
/// Returns the nearest nest in which the team delivers.
std::optional<NestView> nearest_nest(const world::World& world, const std::string& team,
                                     const Vector2& place);
/// Returns whether the place is in a nest of the team.
bool in_nest(const world::World& world, const std::string& team, const Vector2& place);
/// Returns whether a robot of the team may collect the obstacle, or carry it to a nest.
bool may_collect(const std::string& team, const world::Obstacle& obstacle);

}  // namespace elsie::simulation
