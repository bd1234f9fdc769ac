// What comes of bodies that touch: collisions, and resources that are collected.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "elsie/api/simulator_events.h"
#include "elsie/physics/engine.h"
#include "elsie/world/description.h"

#include "step/robot.h"

namespace elsie::simulation {

class Touches {
 public:
  /// The world must stay where it is.
  explicit Touches(const world::World& world) : world_(world) {}

  /// Those of the last step, which ended at this time.
  void handle(const std::vector<std::unique_ptr<Robot>>& robots, physics::Engine& engine,
              double time_s);
  /// Before a new run.
  void forget() { last_touch_.clear(); }

 private:
  bool collects(Robot& robot, const physics::Body& other, physics::Engine& engine) const;
  void collide(const std::vector<std::unique_ptr<Robot>>& robots, const physics::Touch& touch,
               double time_s);
  events::Collision collision_with(const physics::Body& body) const;

  const world::World& world_;
  std::map<std::pair<physics::Body, physics::Body>, double> last_touch_;  // s
};

}  // namespace elsie::simulation
