#include "elsie/world/things.h"

#include <cmath>

#include "elsie/world/colours.h"

namespace elsie::world {

Things::Things(const World& world) : world_(world), floor_(world) {
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    const Obstacle& obstacle = world.obstacles[i];
    if (obstacle.kind == ObstacleKind::resource || obstacle.is_dynamic()) near_.push_back(i);
  }
  for (const Charger& charger : world.chargers) {
    if (charger.seen_by_range_sensors) boxes_.push_back(&charger);
  }
  for (const Lamp& lamp : world.lamps) {
    lamps_.push_back({lamp.id, {lamp.x, lamp.y, lamp.z}, lamp.intensity, lamp.colour});
  }
}

Thing Things::obstacle(const Obstacle& obstacle) const {
  if (obstacle.kind != ObstacleKind::resource) {
    return {Thing::Kind::obstacle, obstacle.id, {}, box_colour(world_, obstacle, kSeen)};
  }
  return {Thing::Kind::resource, obstacle.id, obstacle.team, resource_colour(world_, obstacle)};
}

Thing Things::charger(const Charger& charger) const {
  return {Thing::Kind::charger, charger.id, charger.team, kChargerColour,
          !charger.seen_by_range_sensors};
}

Thing Things::of(const Surface& surface) const {
  switch (surface.kind) {
    case Surface::Kind::nothing:
      return {};
    case Surface::Kind::floor:
      return {Thing::Kind::floor, {}, {}, world_.floor.colour.value_or(kPlainFloor)};
    case Surface::Kind::wall:
      return {Thing::Kind::wall, {}, {}, kSeen.wall};
    case Surface::Kind::robot:
      return robot(surface.index);
    case Surface::Kind::obstacle:
      break;
  }
  if (surface.index >= world_.obstacles.size()) {
    return charger(*boxes_[surface.index - world_.obstacles.size()]);
  }
  return obstacle(world_.obstacles[surface.index]);
}

Thing Things::robot(std::size_t index) const {
  const Robot& robot = world_.robots[index];
  return {Thing::Kind::robot, robot.id, robot.team, robot_colour(world_, robot)};
}

void Things::add_robot(std::size_t index, const Pose& from, const Pose& place, double radius_m,
                       std::vector<NearThing>& things) const {
  if (const double far = distance(from, place); far <= radius_m) {
    things.push_back({robot(index), {place.x, place.y}, far, bearing(from, place.x, place.y)});
  }
}

void Things::within(const Pose& from, double radius_m,
                    const std::function<std::optional<Vector2>(std::size_t)>& place_of,
                    std::vector<NearThing>& things) const {
  const auto add = [&](const Thing& thing, double x, double y) {
    if (const double far = std::hypot(x - from.x, y - from.y); far <= radius_m) {
      things.push_back({thing, {x, y}, far, bearing(from, x, y)});
    }
  };
  for (const std::size_t i : near_) {
    const Obstacle& each = world_.obstacles[i];
    if (!each.is_dynamic() && std::abs(each.x - from.x) > radius_m) continue;
    if (const auto place = place_of(i)) add(obstacle(each), place->x, place->y);
  }
  for (const Charger& each : world_.chargers) {
    add(charger(each), each.x, each.y);
  }
}

}  // namespace elsie::world
