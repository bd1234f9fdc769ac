// What comes of bodies that touch: collisions, and resources that are collected.
#pragma once

#include <algorithm>
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
  /// The bodies have other numbers now: `now_of` gives none for one that is gone.
  template <class NowOf>
  void renumber(NowOf now_of) {
    std::map<std::pair<physics::Body, physics::Body>, double> known;
    for (const auto& [pair, time_s] : last_touch_) {
      const auto a = now_of(pair.first), b = now_of(pair.second);
      if (a && b) {
        known[std::minmax(*a, *b)] = time_s;
      }
    }
    last_touch_ = std::move(known);
  }
  /// As another one knows them.
  void take(const Touches& other) { last_touch_ = other.last_touch_; }
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
