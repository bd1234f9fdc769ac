#include "step/hands.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "elsie/world/footprint.h"
#include "elsie/world/parts.h"

#include "edits/transaction.h"
#include "step/teams.h"

namespace elsie::simulation {
namespace {

Vector2 place_of(const physics::Engine& engine, std::size_t thing) {
  const Vector3 at = engine.obstacle(thing).origin;
  return {at.x, at.y};
}

/// Whether an actuator held something in the last control period.
bool is_full(const Robot& robot, std::string_view actuator) {
  const auto held = robot.state().held;
  return std::any_of(held.begin(), held.end(),
                     [&](const HeldThing& thing) { return thing.actuator == actuator; });
}

std::size_t index_in(const Robot& robot, std::string_view actuator) {
  std::size_t index = 0;
  while (robot.actuator(index) != actuator) ++index;
  return index;
}

/// The place of a thing that is nearest to one in the world, in the thing's own frame, m; of the
/// rectangle around its outline.
Vector2 nearest_in(const physics::Engine& engine, const world::World& world, std::size_t thing,
                   const Vector3& place) {
  const Vector3 size = world::fixture_of(world.obstacles[thing]).shape.size;
  const Frame frame = engine.obstacle(thing);
  const Vector3 way = place - frame.origin;
  return {std::clamp(dot(way, frame.forward), -0.5 * size.x, 0.5 * size.x),
          std::clamp(dot(way, frame.left), -0.5 * size.y, 0.5 * size.y)};
}

world::Footprint footprint_in(const physics::Engine& engine, const world::World& world,
                              std::size_t thing) {
  const Shape shape = world::fixture_of(world.obstacles[thing]).shape;
  Frame middle = engine.obstacle(thing);
  middle.origin = middle.point({0.0, 0.0, 0.5 * shape.size.z});
  return world::footprint_of(shape, middle);
}

}  // namespace

void Hands::act(const world::World& world, Robots robots,
                const std::shared_ptr<physics::Engine>& engine) {
  engine_ = engine;
  loose_.clear();
  is_listed_ = false;
  count_holders(world);
  bool has_changed = false;
  for (std::size_t i = 0; i < held_.size();) {
    const Robot& robot = *robots[held_[i].robot_index];
    if (robot.grasp(index_in(robot, held_[i].actuator))) {
      ++i;
      continue;
    }
    const Held released = held_[i];
    --holders_[released.thing_index];
    held_.erase(held_.begin() + static_cast<std::ptrdiff_t>(i));
    release(world, robots, released);
    has_changed = true;
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (std::size_t k = 0; k < robots[i]->actuator_count(); ++k) {
      if (!robots[i]->grasp(k) || is_full(*robots[i], robots[i]->actuator(k))) continue;
      const std::size_t known = held_.size();
      take(world, robots, i, k);
      has_changed = has_changed || held_.size() > known;
    }
  }
  if (has_changed) show(world, robots);
}

void Hands::count_holders(const world::World& world) {
  holders_.assign(world.obstacles.size(), 0);
  for (const Held& held : held_) ++holders_[held.thing_index];
}

void Hands::release(const world::World& world, Robots robots, const Held& held) {
  const std::size_t thing = held.thing_index;
  Robot& robot = *robots[held.robot_index];
  engine_->let_go(held.robot_index, thing);
  robot.raise(events::Released{held.thing});
  const world::Obstacle& released = world.obstacles[thing];
  const std::string& team = robot.description().team;
  if (!released.to_nest || !held.carried || holders_[thing] > 0 ||
      !in_nest(world, team, place_of(*engine_, thing))) {
    return;
  }
  engine_->remove_obstacle(thing);
  robot.collect(released.energy);
  robot.raise(events::Delivered{released.id});
}

void Hands::list_loose(const world::World& world) {
  is_listed_ = true;
  farthest_ = 0.0;
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (!world.obstacles[i].is_dynamic() || !engine_->has_obstacle(i)) continue;
    const Vector3 size = world::fixture_of(world.obstacles[i]).shape.size;
    const double reach = 0.5 * std::sqrt(dot(size, size));
    loose_.push_back({i, place_of(*engine_, i), reach});
    farthest_ = std::max(farthest_, reach);
  }
  std::stable_sort(loose_.begin(), loose_.end(),
                   [](const Loose& a, const Loose& b) { return a.place.x < b.place.x; });
}

/// The nearest thing within reach that fits the team and has a free hand.
void Hands::take(const world::World& world, Robots robots, std::size_t robot,
                 std::size_t actuator) {
  if (!is_listed_) list_loose(world);
  Robot& taker = *robots[robot];
  const Vector3 hand = taker.actuator_place(actuator);
  const double reach = *taker.grasp(actuator);
  const std::string& team = taker.description().team;
  const auto first =
      std::lower_bound(loose_.begin(), loose_.end(), hand.x - reach - farthest_,
                       [](const Loose& loose, double x) { return loose.place.x < x; });
  const Loose* nearest = nullptr;
  double least = 0.0;
  for (auto loose = first; loose != loose_.end() && loose->place.x <= hand.x + reach + farthest_;
       ++loose) {
    const double away = std::hypot(loose->place.x - hand.x, loose->place.y - hand.y);
    if (away > reach + loose->reach || (nearest && away >= least)) continue;
    const world::Obstacle& thing = world.obstacles[loose->index];
    if (thing.kind == world::ObstacleKind::resource && !may_collect(team, thing)) continue;
    if (!engine_->has_obstacle(loose->index) || holders_[loose->index] >= thing.hands) continue;
    const world::Footprint hull = footprint_in(*engine_, world, loose->index);
    const world::Footprint around{.x = hand.x,
                                  .y = hand.y,
                                  .half_length = reach,
                                  .half_width = reach,
                                  .bottom = hull.bottom,
                                  .top = hull.top,
                                  .round = true};
    const bool is_mine = std::any_of(held_.begin(), held_.end(), [&](const Held& held) {
      return held.robot_index == robot && held.thing_index == loose->index;
    });
    if (is_mine || !world::overlap(around, hull)) continue;
    nearest = &*loose;
    least = away;
  }
  if (!nearest) return;
  const Vector2 at = nearest_in(*engine_, world, nearest->index, hand);
  engine_->hold(robot, nearest->index, at);
  ++holders_[nearest->index];
  const world::Obstacle& thing = world.obstacles[nearest->index];
  const std::string& id = thing.id;
  const bool is_carried = holders_[nearest->index] == thing.hands;
  held_.push_back({taker.description().id, std::string(taker.actuator(actuator)), id, robot,
                   nearest->index, at, is_carried});
  if (is_carried && thing.hands > 1) {
    for (Held& held : held_) held.carried = held.carried || held.thing_index == nearest->index;
  }
  taker.raise(events::Taken{id});
}

/// Lets robots know what they hold.
void Hands::show(const world::World& world, Robots robots) const {
  for (const auto& robot : robots) {
    if (!robot->state().held.empty()) robot->set_held({});
  }
  for (const Held& held : held_) {
    Robot& robot = *robots[held.robot_index];
    std::vector<HeldThing> all(robot.state().held.begin(), robot.state().held.end());
    const world::Obstacle& thing = world.obstacles[held.thing_index];
    all.push_back({thing.id, robot.actuator(index_in(robot, held.actuator)),
                   holders_[held.thing_index] >= thing.hands});
    robot.set_held(std::move(all));
  }
}

void Hands::follow(const world::World& world, Robots robots,
                   const std::shared_ptr<physics::Engine>& engine,
                   std::span<const physics::Body> placed) {
  if (held_.empty()) return;
  const auto is_placed = [&](physics::BodyKind kind, std::size_t index) {
    return std::find(placed.begin(), placed.end(), physics::Body{kind, index}) != placed.end();
  };
  const std::vector<Held> before = std::exchange(held_, {});
  count_holders(world);
  for (const Held& was : before) {
    Held held = was;
    held.robot_index = index_of(world.robots, was.robot, was.robot_index);
    held.thing_index = index_of(world.obstacles, was.thing, was.thing_index);
    bool stays = held.robot_index < robots.size() && held.thing_index < world.obstacles.size() &&
                 engine->has_obstacle(held.thing_index);
    if (stays) {
      const auto& actuators = world.robots[held.robot_index].actuators;
      stays = index_of(actuators, was.actuator, 0) < actuators.size() &&
              world.obstacles[held.thing_index].is_dynamic() &&
              holders_[held.thing_index] < world.obstacles[held.thing_index].hands &&
              !is_placed(physics::BodyKind::robot, held.robot_index) &&
              !is_placed(physics::BodyKind::obstacle, held.thing_index);
    }
    if (engine == engine_ && !stays) engine->let_go(was.robot_index, was.thing_index);
    if (engine != engine_ && stays) engine->hold(held.robot_index, held.thing_index, held.at);
    if (!stays && held.robot_index < robots.size()) {
      robots[held.robot_index]->raise(events::Released{was.thing});
    }
    if (!stays) continue;
    ++holders_[held.thing_index];
    held_.push_back(held);
  }
  engine_ = engine;
  show(world, robots);
}

}  // namespace elsie::simulation
