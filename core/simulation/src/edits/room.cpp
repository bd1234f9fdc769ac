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
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (!engine.has_obstacle(i)) continue;
    const world::Fixture fixture = world::fixture_of(world.obstacles[i]);
    Frame middle = engine.obstacle(i);
    middle.origin = middle.point({0.0, 0.0, 0.5 * fixture.shape.size.z});
    const world::ObstacleKind kind = world.obstacles[i].kind;
    blocks_.push_back(
        {world::footprint_of(fixture.shape, middle), world.obstacles[i].in_words(), i,
         kind == world::ObstacleKind::dynamic || kind == world::ObstacleKind::resource});
  }
  for (std::size_t i = 0; i < world.chargers.size(); ++i) {
    const world::Charger& charger = world.chargers[i];
    if (charger.seen_by_range_sensors) {
      const world::Fixture fixture = world::fixture_of(charger);
      blocks_.push_back({world::footprint_of(fixture.shape, fixture.frame),
                         "the charger '" + charger.id + "'", world.obstacles.size() + i, false});
    }
  }
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const BodyPlan& plan = plans_.emplace_back(world::plan_of(world.robots[i]));
    std::vector<world::Footprint> vehicles;
    const auto add = [&](const auto& body) {
      vehicles.push_back(world::footprint_of(world::vehicle_of(plan, vehicles.size()), body.pose,
                                             height(body.frame)));
    };
    add(engine.robot(i));
    for (std::size_t k = 0; k < engine.segments(i); ++k) {
      add(engine.segment(i, k));
    }
    add_robot(i, vehicles);
  }
}

void Room::add_robot(std::size_t robot, const std::vector<world::Footprint>& vehicles) {
  const world::Robot& described = world_.robots[robot];
  const std::size_t of_drive = plans_[robot].vehicles() - described.segments.size();
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const std::string segment =
        i < of_drive ? "" : "the segment '" + described.segments[i - of_drive].id + "' of ";
    blocks_.push_back(
        {vehicles[i], segment + "the robot '" + described.id + "'", first_robot_ + robot, true});
  }
}

void Room::place(std::size_t robot, const Pose& pose, double z) {
  auto vehicle = std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& block) {
    return block.owner == first_robot_ + robot;
  });
  for (const world::Footprint& footprint : world::footprints_of(plans_[robot], pose, z)) {
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
    block = blocks_.insert(blocks_.begin(), {{}, described.in_words(), obstacle, true});
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
      return own.in_words + " overlaps " + other.in_words;
    }
  }
  return std::nullopt;
}

std::optional<std::string> Room::problem_of(std::size_t robot) const {
  for (const Block& own : blocks_) {
    if (own.owner == first_robot_ + robot) {
      auto problem = world::outside(world_.arena, own.in_words, own.footprint);
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
                                     : world::outside(world_.arena, own.in_words, own.footprint);
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
                world::outside(world_.arena, block.in_words, block.footprint.grown(-kHair))) {
          return found;
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace elsie::simulation
