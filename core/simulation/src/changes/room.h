// Whether there is room for a body somewhere, as things stand at this instant.
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

  /// Puts a robot elsewhere in here, and what it pulls in line behind it.
  void place(std::size_t robot, const Pose& pose, double z);
  /// A sentence when a robot is not where it could be: "the robot 'r1' overlaps the box 'b2'".
  std::optional<std::string> problem_of(std::size_t robot) const;
  /// Returns the problem of a box, by its place in World::boxes, or behind them a charger's.
  /// Overlaps that a file allows are allowed here.
  std::optional<std::string> problem_of_box(std::size_t box) const;
  /// A sentence when a body that moves is outside of the arena by more than it gives way at a wall.
  std::optional<std::string> problem_of_arena() const;

 private:
  struct Block {
    world::Footprint footprint;
    std::string in_words;
    std::size_t owner = 0;  // boxes are counted first, then chargers, then robots
    bool is_free = false;   // it may be pushed or taken away
  };

  void add_robot(std::size_t robot, const std::vector<world::Footprint>& vehicles);
  std::optional<std::string> overlap(const Block& own) const;

  const world::World& world_;
  std::vector<Block> blocks_;    // boxes and chargers before robots and what they pull
  std::size_t first_robot_;      // as an owner
  std::vector<BodyPlan> plans_;  // of the robots
};

}  // namespace elsie::simulation
