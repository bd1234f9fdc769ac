#include "edits/room.h"

#include <algorithm>
#include <iterator>

namespace elsie::simulation {

double height(const Frame& frame) {
  constexpr double kHair = 1e-3;  // m
  return frame.origin.z < kHair ? 0.0 : frame.origin.z;
}

Room::Room(const world::World& world, const physics::Engine& engine)
    : world_(world), first_robot_(world.obstacles.size() + world.chargers.size()) {
  blocks_.reserve(first_robot_ + world.robots.size());
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (!engine.has_obstacle(i)) continue;
    const world::Fixture fixture = world::fixture_of(world.obstacles[i]);
    Frame middle = engine.obstacle(i);
    middle.origin = middle.point({0.0, 0.0, 0.5 * fixture.shape.size.z});
    const world::ObstacleKind kind = world.obstacles[i].kind;
    blocks_.push_back(
        {world::footprint_of(fixture.shape, middle), i, 0,
         kind == world::ObstacleKind::dynamic || kind == world::ObstacleKind::resource});
  }
  for (std::size_t i = 0; i < world.chargers.size(); ++i) {
    const world::Charger& charger = world.chargers[i];
    if (charger.seen_by_range_sensors) {
      const world::Fixture fixture = world::fixture_of(charger);
      blocks_.push_back({world::footprint_of(fixture.shape, fixture.frame),
                         world.obstacles.size() + i, 0, false});
    }
  }
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const BodyPlan plan = world::plan_of(world.robots[i]);
    std::size_t vehicle = 0;
    const auto add = [&](const auto& body) {
      blocks_.push_back(
          {world::footprint_of(world::vehicle_of(plan, vehicle), body.pose, height(body.frame)),
           first_robot_ + i, vehicle, true});
      ++vehicle;
    };
    add(engine.robot(i));
    for (std::size_t k = 0; k < engine.segments(i); ++k) {
      add(engine.segment(i, k));
    }
  }
}

std::string Room::in_words(const Block& block) const {
  if (block.owner < world_.obstacles.size()) return world_.obstacles[block.owner].in_words();
  if (block.owner < first_robot_) {
    return "the charger '" + world_.chargers[block.owner - world_.obstacles.size()].id + "'";
  }
  const world::Robot& robot = world_.robots[block.owner - first_robot_];
  const auto vehicles = std::count_if(blocks_.begin(), blocks_.end(),
                                      [&](const Block& each) { return each.owner == block.owner; });
  const std::size_t of_drive = static_cast<std::size_t>(vehicles) - robot.segments.size();
  const std::string segment =
      block.vehicle < of_drive
          ? ""
          : "the segment '" + robot.segments[block.vehicle - of_drive].id + "' of ";
  return segment + "the robot '" + robot.id + "'";
}

void Room::place(std::size_t robot, const Pose& pose, double z) {
  auto vehicle = std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& block) {
    return block.owner == first_robot_ + robot;
  });
  const BodyPlan plan = world::plan_of(world_.robots[robot]);
  for (const world::Footprint& footprint : world::footprints_of(plan, pose, z)) {
    (vehicle++)->footprint = footprint;
  }
}

void Room::place_box(std::size_t obstacle, const Pose& pose) {
  const world::Obstacle& described = world_.obstacles[obstacle];
  const world::Fixture fixture = world::fixture_of(described);
  const Frame middle =
      Frame::turned({pose.x, pose.y, fixture.frame.origin.z}, pose.heading_rad, 0.0);
  auto block = std::find_if(blocks_.begin(), blocks_.end(),
                            [&](const Block& each) { return each.owner == obstacle; });
  if (block == blocks_.end()) {
    block = blocks_.insert(blocks_.begin(), {{}, obstacle, 0, true});
  }
  block->footprint = world::footprint_of(fixture.shape, middle);
}

void Room::put(const physics::Body& body, const Pose& pose) {
  if (body.kind != physics::BodyKind::robot) return place_box(body.index, pose);
  const auto first = std::find_if(blocks_.begin(), blocks_.end(),
                                  [&](const Block& each) { return each.owner == owner(body); });
  place(body.index, pose, first->footprint.bottom);
}

bool Room::has_room(const physics::Body& body, const Pose& pose) {
  const auto is_its = [&](const Block& block) { return block.owner == owner(body); };
  std::vector<Block> before;
  std::copy_if(blocks_.begin(), blocks_.end(), std::back_inserter(before), is_its);
  put(body, pose);
  const bool has = !problem_of(body);
  const auto its = std::find_if(blocks_.begin(), blocks_.end(), is_its);
  if (before.empty()) {
    blocks_.erase(its);
  } else {
    std::move(before.begin(), before.end(), its);
  }
  return has;
}

std::optional<std::string> Room::overlap(const Block& own) const {
  for (const Block& other : blocks_) {
    if (other.owner != own.owner && (own.is_free || other.is_free) &&
        world::overlap(own.footprint, other.footprint)) {
      return in_words(own) + " overlaps " + in_words(other);
    }
  }
  return std::nullopt;
}

std::optional<std::string> Room::problem_of(std::size_t robot) const {
  for (const Block& own : blocks_) {
    if (own.owner == first_robot_ + robot) {
      auto problem = world::outside(world_.arena, in_words(own), own.footprint);
      if (problem || (problem = overlap(own))) return problem;
    }
  }
  return std::nullopt;
}

std::optional<std::string> Room::problem_of_box(std::size_t obstacle) const {
  for (const Block& own : blocks_) {
    if (own.owner == obstacle) {
      auto problem = overlap(own);
      return problem || !own.is_free ? problem
                                     : world::outside(world_.arena, in_words(own), own.footprint);
    }
  }
  return std::nullopt;
}

std::optional<std::string> Room::problem_of_arena() const {
  constexpr double kHair = 1e-3;  // m
  // Robots come first.
  for (const bool is_robot : {true, false}) {
    for (const Block& block : blocks_) {
      if (block.is_free && is_robot == (block.owner >= first_robot_)) {
        if (auto found =
                world::outside(world_.arena, in_words(block), block.footprint.grown(-kHair))) {
          return found;
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace elsie::simulation
