#include "step/teams.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace elsie::simulation {
namespace {

/// Of a charger or a nest.
bool serves(const auto& place, const std::string& team) {
  return place.team.empty() || place.team == team;
}

double distance(const auto& there, const Vector2& place) {
  return std::hypot(there.x - place.x, there.y - place.y);
}

/// The nearest that serves the team; null: none.
template <class Place>
const Place* nearest(const std::vector<Place>& all, const std::string& team, const Vector2& place) {
  const Place* found = nullptr;
  double least = 0.0;
  for (const Place& other : all) {
    const double away = distance(other, place);
    if (serves(other, team) && (!found || away < least)) {
      found = &other;
      least = away;
    }
  }
  return found;
}

}  // namespace

std::optional<Vector2> nearest_charger(const world::World& world, const std::string& team,
                                       const Vector2& place) {
  const auto* const charger = nearest(world.chargers, team, place);
  return charger ? std::optional(Vector2{charger->x, charger->y}) : std::nullopt;
}

std::optional<NestView> nearest_nest(const world::World& world, const std::string& team,
                                     const Vector2& place) {
  const auto* const nest = nearest(world.nests, team, place);
  return nest ? std::optional(NestView{{nest->x, nest->y}, nest->radius}) : std::nullopt;
}

bool in_nest(const world::World& world, const std::string& team, const Vector2& place) {
  return std::any_of(world.nests.begin(), world.nests.end(), [&](const world::Nest& nest) {
    return serves(nest, team) && distance(nest, place) <= nest.radius;
  });
}

double charger_rate(const world::World& world, const std::string& team, const Vector2& place) {
  for (const world::Charger& charger : world.chargers) {
    if (serves(charger, team) && distance(charger, place) <= charger.radius) return charger.rate;
  }
  return 0.0;
}

bool may_collect(const std::string& team, const world::Obstacle& obstacle) {
  return obstacle.kind == world::ObstacleKind::resource &&
         (obstacle.team.empty() || obstacle.team == team);
}

}  // namespace elsie::simulation
