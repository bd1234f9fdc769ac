#include "step/teams.h"

#include <algorithm>
#include <cmath>

#include "elsie/world/colours.h"

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
    if (serves(charger, team) && distance(charger, place) <= charger.radius) {
      return charger.rate;
    }
  }
  return 0.0;
}

bool may_collect(const std::string& team, const world::Box& box) {
  return box.kind == world::BoxKind::resource && (box.team.empty() || box.team == team);
}

Teams::Teams(const world::World& world) : world_(world) {
  std::map<std::string_view, int> sizes;
  for (const world::Robot& robot : world.robots) {
    numbers_.push_back(sizes[robot.team]++);
  }
}

const std::vector<Colour>& Teams::resource_colours(const std::string& team) {
  const auto [known, is_new] = colours_.try_emplace(team);
  std::vector<Colour>& colours = known->second;
  if (!is_new) {
    return colours;
  }
  for (const world::Box& box : world_.boxes) {
    if (may_collect(team, box)) {
      const Colour colour = world::resource_colour(world_, box);
      if (std::find(colours.begin(), colours.end(), colour) == colours.end()) {
        colours.push_back(colour);
      }
    }
  }
  return colours;
}

}  // namespace elsie::simulation
