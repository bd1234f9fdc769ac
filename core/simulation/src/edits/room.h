// Checks whether there is room for a body at this instant.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/world/description.h"
#include "elsie/world/footprint.h"

namespace elsie::simulation {

/// The height at which a body stands, m. Small penetration of the floor is ignored.
double height(const Frame& frame);

class Room {
 public:
  Room(const world::World& world, const physics::Engine& engine);

  /// Moves a robot in this model, with its segments in line behind it.
  void place(std::size_t robot, const Pose& pose, double z);
  /// Moves an obstacle in this model; one that was removed is there again.
  void place_box(std::size_t obstacle, const Pose& pose);
  /// Moves either of them, a robot at its present height.
  void put(const physics::Body& body, const Pose& pose);
  /// Whether a robot or an obstacle would have room there. Moves nothing.
  bool has_room(const physics::Body& body, const Pose& pose);
  /// A sentence when a robot's place is not possible: "the robot 'r1' overlaps the box 'b2'".
  std::optional<std::string> problem_of(std::size_t robot) const;
  /// The same for an obstacle, by its index in World::obstacles, or for a charger (indices after
  /// the obstacles). Overlaps that a file allows are allowed here.
  std::optional<std::string> problem_of_box(std::size_t obstacle) const;
  std::optional<std::string> problem_of(const physics::Body& body) const {
    return body.kind == physics::BodyKind::robot ? problem_of(body.index)
                                                 : problem_of_box(body.index);
  }
  /// A sentence when a body that can move is outside of the arena by more than a small tolerance.
  std::optional<std::string> problem_of_arena() const;

 private:
  struct Block {
    world::Footprint footprint;
    std::size_t owner = 0;    // index: obstacles first, then chargers, then robots
    std::size_t vehicle = 0;  // of a robot
    bool is_free = false;     // it may be pushed or removed
  };

  std::size_t owner(const physics::Body& body) const {
    return body.kind == physics::BodyKind::robot ? first_robot_ + body.index : body.index;
  }
  std::string in_words(const Block& block) const;
  std::optional<std::string> overlap(const Block& own) const;

  const world::World& world_;
  std::vector<Block> blocks_;  // obstacles and chargers before robots and what they pull
  std::size_t first_robot_;    // as index of an owner
};

}  // namespace elsie::simulation
