#include "step/touches.h"

#include "step/teams.h"

namespace elsie::simulation {
namespace {

/// If two bodies touch again within this time, it is the same collision.
constexpr double kSameCollision = 0.2;  // s

/// If the robot may collect the touched body, collects it, unless it has to carry it to a nest, and
/// returns true.
bool collects(const world::World& world, Robot& robot, const physics::Body& other,
              physics::Engine& engine) {
  if (other.kind != physics::BodyKind::obstacle || other.index >= world.obstacles.size()) {
    return false;
  }
  const world::Obstacle& obstacle = world.obstacles[other.index];
  if (!may_collect(robot.description().team, obstacle)) return false;
  if (obstacle.to_nest) return true;
  if (engine.has_obstacle(other.index)) {  // else another robot took it in the same step
    engine.remove_obstacle(other.index);
    robot.collect(obstacle.energy);
    robot.raise(events::Collected{obstacle.id});
  }
  return true;
}

events::Collision collision_with(const world::World& world, const physics::Body& body) {
  using With = events::Collision::With;
  switch (body.kind) {
    case physics::BodyKind::robot:
      return {With::robot, world.robots[body.index].id};
    case physics::BodyKind::obstacle:
      if (body.index >= world.obstacles.size()) {
        return {With::charger};
      }
      return {With::box, world.obstacles[body.index].id};
    case physics::BodyKind::wall:
      break;
  }
  return {With::wall};
}

}  // namespace

void Touches::handle(const world::World& world, Robots robots, physics::Engine& engine,
                     double time_s) {
  for (const physics::Touch& touch : engine.touches()) {
    if (touch.a.kind != physics::BodyKind::robot ||
        collects(world, *robots[touch.a.index], touch.b, engine)) {
      continue;
    }
    const auto [entry, is_new] = last_touch_.try_emplace({touch.a, touch.b}, time_s);
    if (is_new || time_s - entry->second > kSameCollision) {
      robots[touch.a.index]->collided(collision_with(world, touch.b));
      if (touch.b.kind == physics::BodyKind::robot) {
        robots[touch.b.index]->collided(collision_with(world, touch.a));
      }
    }
    entry->second = time_s;
  }
}

}  // namespace elsie::simulation
