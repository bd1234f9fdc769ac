#include "changes/room.h"

#include <cmath>

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
    parts.push_back(
        world::footprint_of(robot.body, robots[i]->state().pose, height(engine.robot(i).frame)));
    for (std::size_t k = 0; k < robot.segments.size(); ++k) {
      const physics::SegmentState segment = engine.segment(i, k);
      parts.push_back(world::footprint_of(robot.segments[k], segment.pose, height(segment.frame)));
    }
  }
}

void Room::place(std::size_t robot, const Pose& pose, double z) {
  robots_[robot] =
      world::footprints_of(world_.robots[robot].body, world_.robots[robot].segments, pose, z);
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
  return (part == 0 ? "" : "the segment '" + described.segments[part - 1].id + "' of ") +
         ("the robot '" + described.id + "'");
}

}  // namespace elsie::simulation
