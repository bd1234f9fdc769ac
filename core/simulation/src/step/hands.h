// What robots hold.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/world/description.h"

#include "robot/robot_surroundings.h"

namespace elsie::simulation {

/// Takes and releases things as the actuators of robots want it, once in each control period: robot
/// after robot, in the order of the file.
class Hands {
 public:
  void act(const world::World& world, Robots robots,
           const std::shared_ptr<physics::Engine>& engine);
  /// After an edit: what a robot holds stays in its hands, perhaps in another engine. It lets go if
  /// the edit has removed it or its actuator, or has `placed` one of the two.
  void follow(const world::World& world, Robots robots,
              const std::shared_ptr<physics::Engine>& engine,
              std::span<const physics::Body> placed);

 private:
  /// Something in the hand of a robot. An edit may give all three other indices.
  struct Held {
    std::string robot, actuator, thing;  // ids
    std::size_t robot_index = 0, thing_index = 0;
    Vector2 at;            // where it is held, in its own frame, m
    bool carried = false;  // as many have held it as it takes
  };
  /// Something that can be taken.
  struct Loose {
    std::size_t index = 0;
    Vector2 place;       // m
    double reach = 0.0;  // m, of its farthest point
  };

  void count_holders(const world::World& world);
  void release(const world::World& world, Robots robots, const Held& held);
  void take(const world::World& world, Robots robots, std::size_t robot, std::size_t actuator);
  void list_loose(const world::World& world);
  void show(const world::World& world, Robots robots) const;

  std::shared_ptr<physics::Engine> engine_;
  std::vector<Held> held_;
  std::vector<int> holders_;  // of each obstacle
  std::vector<Loose> loose_;  // from west to east; in a period in which somebody takes something
  bool is_listed_ = false;    // they are
  double farthest_ = 0.0;     // the greatest reach of them
};

}  // namespace elsie::simulation
