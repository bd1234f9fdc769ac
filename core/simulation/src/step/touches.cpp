#include "step/touches.h"

#include "step/teams.h"

namespace elsie::simulation {
namespace {

/// Bodies that touch again within this time are still the same collision.
constexpr double kSameCollision = 0.2;  // s

}  // namespace

void Touches::handle(const std::vector<std::unique_ptr<Robot>>& robots, physics::Engine& engine,
                     double time_s) {
  for (const physics::Touch& touch : engine.touches()) {
    if (touch.a.kind == physics::BodyKind::robot &&
        !collects(*robots[touch.a.index], touch.b, engine)) {
      collide(robots, touch, time_s);
    }
  }
}

/// Whether the touch is a robot's with a resource that it may take; then it does.
bool Touches::collects(Robot& robot, const physics::Body& other, physics::Engine& engine) const {
  if (other.kind != physics::BodyKind::box || other.index >= world_.boxes.size()) {
    return false;
  }
  const world::Box& box = world_.boxes[other.index];
  if (!may_collect(robot.description().team, box)) {
    return false;
  }
  if (engine.has_box(other.index)) {  // else another robot took it in the same step
    engine.remove_box(other.index);
    robot.collect(box.energy);
    robot.raise(events::Collected{box.id});
  }
  return true;
}

void Touches::collide(const std::vector<std::unique_ptr<Robot>>& robots,
                      const physics::Touch& touch, double time_s) {
  const auto [entry, is_new] = last_touch_.try_emplace({touch.a, touch.b}, time_s);
  if (is_new || time_s - entry->second > kSameCollision) {
    robots[touch.a.index]->count_collision();
    robots[touch.a.index]->raise(collision_with(touch.b));
    if (touch.b.kind == physics::BodyKind::robot) {
      robots[touch.b.index]->count_collision();
      robots[touch.b.index]->raise(collision_with(touch.a));
    }
  }
  entry->second = time_s;
}

events::Collision Touches::collision_with(const physics::Body& body) const {
  using With = events::Collision::With;
  switch (body.kind) {
    case physics::BodyKind::robot:
      return {With::robot, world_.robots[body.index].id};
    case physics::BodyKind::box:
      if (body.index >= world_.boxes.size()) {
        return {With::charger};
      }
      return {With::box, world_.boxes[body.index].id};
    case physics::BodyKind::wall:
      break;
  }
  return {With::wall};
}

}  // namespace elsie::simulation
