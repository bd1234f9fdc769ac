#include "step/teams.h"

#include <cmath>

namespace elsie::simulation {
namespace {

bool serves(const world::Charger& charger, const std::string& team) {
  return charger.team.empty() || charger.team == team;
}

double distance(const world::Charger& charger, const Vector2& place) {
  return std::hypot(charger.x - place.x, charger.y - place.y);
}

}  // namespace

std::optional<Vector2> nearest_charger(const world::World& world, const std::string& team,
                                       const Vector2& place) {
  std::optional<Vector2> charger;
  double nearest = 0.0;
  for (const world::Charger& other : world.chargers) {
    const double away = distance(other, place);
    if (serves(other, team) && (!charger || away < nearest)) {
      charger = Vector2{other.x, other.y};
      nearest = away;
    }
  }
  return charger;
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
