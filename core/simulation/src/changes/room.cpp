#include "changes/room.h"

#include <cmath>

#include "elsie/world/parts.h"

namespace elsie::simulation {

double height(const Frame& frame) {
  constexpr double kHair = 1e-3;  // m
  return frame.origin.z < kHair ? 0.0 : frame.origin.z;
}

Room::Room(const world::World& world, Robots robots, const physics::Engine& engine)
    : world_(world) {
  for (std::size_t i = 0; i < world.boxes.size(); ++i) {
    if (engine.has_box(i)) {
      boxes_.push_back({world::footprint_of(world.boxes[i], engine.box(i)),
                        "the box '" + world.boxes[i].id + "'"});
    }
  }
  for (const world::Charger& charger : world.chargers) {
    if (charger.seen_by_range_sensors) {
      constexpr double kHalf = 0.5 * world::Charger::kBoxEdge;
      boxes_.push_back({{charger.x, charger.y, 0.0, kHalf, kHalf, 0.0, world::Charger::kBoxEdge},
                        "the charger '" + charger.id + "'"});
    }
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const world::Robot& robot = world.robots[i];
    auto& parts = robots_.emplace_back();
    const BodyPlan plan = world::plan_of(robot);
    const physics::RobotState state = engine.robot(i);
    parts.push_back(world::footprint_of(plan, 0, state.pose, height(state.frame)));
    for (std::size_t k = 0; k < engine.segments(i); ++k) {
      const physics::SegmentState segment = engine.segment(i, k);
      parts.push_back(world::footprint_of(plan, k + 1, segment.pose, height(segment.frame)));
    }
  }
}

void Room::place(std::size_t robot, const Pose& pose, double z) {
  robots_[robot] = world::footprints_of(world::plan_of(world_.robots[robot]), pose, z);
}

std::optional<std::string> Room::problem_of(std::size_t robot) const {
  for (std::size_t part = 0; part < robots_[robot].size(); ++part) {
    const world::Footprint& own = robots_[robot][part];
    const std::string name = name_of(robot, part);
    if (auto problem = world::outside(world_.arena, name, own)) {
      return problem;
    }
    for (const Block& box : boxes_) {
      if (world::overlap(own, box.footprint)) {
        return name + " overlaps " + box.in_words;
      }
    }
    for (std::size_t other = 0; other < robots_.size(); ++other) {
      for (std::size_t k = 0; other != robot && k < robots_[other].size(); ++k) {
        if (world::overlap(own, robots_[other][k])) {
          return name + " overlaps " + name_of(other, k);
        }
      }
    }
  }
  return std::nullopt;
}

std::string Room::name_of(std::size_t robot, std::size_t part) const {
  const world::Robot& described = world_.robots[robot];
  const std::string name = "the robot '" + described.id + "'";
  const std::size_t own = robots_[robot].size() - described.segments.size();
  return part < own ? name : "the segment '" + described.segments[part - own].id + "' of " + name;
}

}  // namespace elsie::simulation
