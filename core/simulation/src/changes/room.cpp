#include "changes/room.h"

#include <algorithm>
#include <cmath>

namespace elsie::simulation {

double height(const Frame& frame) {
  constexpr double kHair = 1e-3;  // m
  return frame.origin.z < kHair ? 0.0 : frame.origin.z;
}

Room::Room(const world::World& world, const physics::Engine& engine) : world_(world) {
  for (std::size_t i = 0; i < world.boxes.size(); ++i) {
    if (!engine.has_box(i)) {
      continue;
    }
    const Shape shape = world::fixture_of(world.boxes[i]).shape;
    Frame middle = engine.box(i);
    middle.origin = middle.point({0.0, 0.0, 0.5 * shape.size.z});
    const world::BoxKind kind = world.boxes[i].kind;
    boxes_.push_back({world::footprint_of(shape, middle), "the box '" + world.boxes[i].id + "'", i,
                      kind == world::BoxKind::dynamic || kind == world::BoxKind::resource});
  }
  std::size_t number = world.boxes.size();
  for (const world::Charger& charger : world.chargers) {
    if (charger.seen_by_range_sensors) {
      const world::Fixture fixture = world::fixture_of(charger);
      boxes_.push_back({world::footprint_of(fixture.shape, fixture.frame),
                        "the charger '" + charger.id + "'", number++, false});
    }
  }
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const BodyPlan& plan = plans_.emplace_back(world::plan_of(world.robots[i]));
    auto& vehicles = robots_.emplace_back();
    const auto add = [&](const auto& body) {
      vehicles.push_back(world::footprint_of(world::vehicle_of(plan, vehicles.size()), body.pose,
                                             height(body.frame)));
    };
    add(engine.robot(i));
    for (std::size_t k = 0; k < engine.segments(i); ++k) {
      add(engine.segment(i, k));
    }
  }
}

void Room::place(std::size_t robot, const Pose& pose, double z) {
  robots_[robot] = world::footprints_of(plans_[robot], pose, z);
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

std::optional<std::string> Room::problem_of_box(std::size_t box) const {
  for (const Block& own : boxes_) {
    if (own.number != box) {
      continue;
    }
    for (const Block& other : boxes_) {
      if (other.number != box && (own.is_free || other.is_free) &&
          world::overlap(own.footprint, other.footprint)) {
        return own.in_words + " overlaps " + other.in_words;
      }
    }
    for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
      for (std::size_t k = 0; k < robots_[robot].size(); ++k) {
        if (world::overlap(own.footprint, robots_[robot][k])) {
          return own.in_words + " overlaps " + name_of(robot, k);
        }
      }
    }
    if (own.is_free) {
      return world::outside(world_.arena, own.in_words, own.footprint);
    }
  }
  return std::nullopt;
}

std::optional<std::string> Room::problem_of_arena() const {
  constexpr double kHair = 1e-3;  // m
  const auto problem = [&](world::Footprint footprint, const std::string& name) {
    footprint.half_length = std::max(0.0, footprint.half_length - kHair);
    footprint.half_width = std::max(0.0, footprint.half_width - kHair);
    return world::outside(world_.arena, name, footprint);
  };
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    for (std::size_t k = 0; k < robots_[robot].size(); ++k) {
      if (auto found = problem(robots_[robot][k], name_of(robot, k))) {
        return found;
      }
    }
  }
  for (const Block& box : boxes_) {
    if (auto found = box.is_free ? problem(box.footprint, box.in_words) : std::nullopt) {
      return found;
    }
  }
  return std::nullopt;
}

std::string Room::name_of(std::size_t robot, std::size_t part) const {
  const world::Robot& described = world_.robots[robot];
  const std::size_t of_drive = plans_[robot].vehicles() - described.segments.size();
  return (part < of_drive ? ""
                          : "the segment '" + described.segments[part - of_drive].id + "' of ") +
         ("the robot '" + described.id + "'");
}

}  // namespace elsie::simulation
