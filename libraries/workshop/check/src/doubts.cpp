#include "elsie/check/doubts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "elsie/api/message.h"
#include "elsie/api/reading.h"
#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/footprint.h"

namespace elsie::check {

namespace {

using base::number_text;
using simulation::Simulation;

constexpr double kHair = 1e-6;   // m
constexpr double kLevel = 1e-6;  // rad

bool needs_robot(const world::Goal& goal) {
  if (const auto* any = std::get_if<world::AnyGoal>(&goal)) {
    return std::all_of(any->goals.begin(), any->goals.end(), needs_robot);
  }
  if (const auto* all = std::get_if<world::AllGoal>(&goal)) {
    return std::any_of(all->goals.begin(), all->goals.end(), needs_robot);
  }
  return !std::holds_alternative<world::EndureGoal>(goal) &&
         !std::holds_alternative<world::NoCollisionGoal>(goal) &&
         !std::holds_alternative<world::BatteryGoal>(goal);
}

class Doubts {
 public:
  explicit Doubts(const Simulation& simulation)
      : simulation_(simulation), world_(simulation.world()) {}

  std::vector<base::Problem> all() {
    const auto active = std::find_if(world_.goals.begin(), world_.goals.end(), needs_robot);
    if (world_.robots.empty() && active != world_.goals.end()) {
      add(std::visit([](const auto& each) { return each.location; }, *active),
          "the world has no robot that could reach this goal");
    }
    world::for_each_goal(world_.goals, [&](const world::Goal& goal) {
      if (const auto* travel = std::get_if<world::TravelGoal>(&goal)) check(*travel);
      if (const auto* reach = std::get_if<world::ReachGoal>(&goal)) check(*reach);
    });
    for (const world::Obstacle& thing : world_.obstacles) check_cargo(thing);
    for (std::size_t robot = 0; robot < world_.robots.size(); ++robot) {
      check_beams(robot);
      for (std::size_t i = 0; i < simulation_.actuators(robot); ++i) check_talk(robot, i);
    }
    return std::move(problems_);
  }

 private:
  void add(const base::Location& where, const std::string& sentence) {
    problems_.push_back({where.file, where.line, sentence});
  }

  /// A robot that keeps a goal about robots from being reached; null if none does.
  template <class About, class Fails>
  const world::Robot* one_that_fails(const About& goal, Fails fails) const {
    const world::Robot* found = nullptr;
    for (const world::Robot& robot : world_.robots) {
      if ((!goal.robot.empty() && robot.id != goal.robot) ||
          (!goal.team.empty() && robot.team != goal.team)) {
        continue;
      }
      if (fails(robot)) {
        if (!found) found = &robot;
      } else if (goal.any) {
        return nullptr;
      }
    }
    return found;
  }

  void check(const world::TravelGoal& goal) {
    if (!world_.edits.empty()) {
      return;
    }
    const world::Robot* const robot = one_that_fails(goal, [&](const world::Robot& each) {
      return goal.distance > each.max_speed * world_.limits.time;
    });
    if (!robot) return;
    add(goal.location, "<travel> needs " + number_text(goal.distance) + " m within " +
                           number_text(world_.limits.time) + " s, but the robot '" + robot->id +
                           "' drives at most " + number_text(robot->max_speed) +
                           " m/s, which makes " +
                           number_text(robot->max_speed * world_.limits.time, 6) + " m");
  }

  void check(const world::ReachGoal& goal) {
    if (!goal.of.empty() || !world_.edits.empty()) {
      return;
    }
    for (const world::Obstacle& box : world_.obstacles) {
      if (box.kind == world::ObstacleKind::fixed && box.z < kHair &&
          one_that_fails(goal, [&](const world::Robot& each) { return fills(box, goal, each); })) {
        add(goal.location, "<reach>: no place within " + number_text(goal.radius) + " m of (" +
                               number_text(goal.x) + ", " + number_text(goal.y) +
                               ") is free: " + box.in_words() + " stands there");
        return;
      }
    }
  }

  /// Whether the middle of the robot comes nowhere near enough to the place because of this box.
  static bool fills(const world::Obstacle& box, const world::ReachGoal& goal,
                    const world::Robot& robot) {
    const double narrow = 0.5 * std::min(robot.body.length, robot.body.width);
    const world::Footprint kept_free = world::footprint_of(box).grown(narrow);
    const auto is_inside = [&](double x, double y) {
      world::Footprint point;
      point.x = x;
      point.y = y;
      point.half_length = point.half_width = 10.0 * kHair;
      point.bottom = kept_free.bottom;
      point.top = kept_free.top;
      return world::overlap(kept_free, point);
    };
    constexpr int kDirections = 32;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      if (!is_inside(goal.x + goal.radius * std::cos(angle),
                     goal.y + goal.radius * std::sin(angle))) {
        return false;
      }
    }
    return is_inside(goal.x, goal.y);  // the outline is convex
  }

  /// What is to be carried.
  void check_cargo(const world::Obstacle& thing) {
    const bool is_resource = thing.kind == world::ObstacleKind::resource;
    const std::string what = is_resource ? "the resource '" + thing.id + "'" : thing.in_words();
    if (is_resource && !thing.to_nest && thing.hands > 1) {
      add(thing.location, what + " has hands=\"" + std::to_string(thing.hands) +
                              "\", which counts only with collect=\"nest\"");
    }
    if (!world_.edits.empty() || !world_.rules.empty()) return;
    if (is_resource && thing.to_nest && world_.nests.empty()) {
      add(thing.location,
          what + " is to be carried to a nest, and the world has none; add a <nest>");
    }
    if (thing.is_dynamic() && static_cast<std::size_t>(thing.hands) > world_.robots.size()) {
      add(thing.location, what + " takes " + std::to_string(thing.hands) +
                              " hands, and the world has " +
                              base::counted(world_.robots.size(), "robot"));
    }
  }

  /// Devices for messages that nobody hears.
  void check_talk(std::size_t robot, std::size_t actuator) {
    const simulation::ActuatorView device = simulation_.actuator(robot, actuator);
    if (device.actuator->kind() != ReadingKind::of<SayCommand>() || !world_.edits.empty()) {
      return;
    }
    const world::MountedUse& use = world_.robots[robot].actuators[actuator];
    const auto has_one = [&](const world::Robot& other) {
      return &other != &world_.robots[robot] &&
             std::any_of(other.actuators.begin(), other.actuators.end(),
                         [&](const world::MountedUse& each) { return each.plugin == use.plugin; });
    };
    if (std::none_of(world_.robots.begin(), world_.robots.end(), has_one)) {
      add(use.location, "nobody hears the robot '" + world_.robots[robot].id +
                            "': it is the only one with a <" + use.plugin + ">");
    }
  }

  /// Level beams and those that point upwards.
  void check_beams(std::size_t robot) {
    double lowest_m = 0.0;
    bool any = false;
    for (std::size_t i = 0; i < simulation_.sensors(robot); ++i) {
      const simulation::SensorView sensor = simulation_.sensor(robot, i);
      if (sensor.sensor->kind() != ReadingKind::of<RangeReading>()) {
        continue;
      }
      if (sensor.mounting->pitch_rad < -kLevel) {
        return;
      }
      const double height_m = sensor.mounting->position.z + world_.robots[robot].z;
      lowest_m = any ? std::min(lowest_m, height_m) : height_m;
      any = true;
    }
    if (!any) {
      return;
    }
    for (const world::Obstacle& box : world_.obstacles) {
      if (box.seen_by_range_sensors && box.z < kHair && box.height <= lowest_m + kHair) {
        add(box.location, box.in_words() + " is " + number_text(box.height) +
                              " m high, and all beams of the robot '" + world_.robots[robot].id +
                              "' pass above it, at " + number_text(lowest_m, 6) + " m");
        return;
      }
    }
  }

  const Simulation& simulation_;
  const world::World& world_;
  std::vector<base::Problem> problems_;
};

}  // namespace

std::vector<base::Problem> doubts(const Simulation& simulation) { return Doubts(simulation).all(); }

}  // namespace elsie::check
