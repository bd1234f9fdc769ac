// The effects of touching bodies: collisions and collected resources.
#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "elsie/physics/engine.h"
#include "elsie/world/description.h"

#include "robot/robot_surroundings.h"

namespace elsie::simulation {

class Touches {
 public:
  /// Handles the touches of the last step, which ended at this time.
  void handle(const world::World& world, Robots robots, physics::Engine& engine, double time_s);
  /// Renumbers the bodies; `now_of` returns none for a removed body.
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

 private:
  std::map<std::pair<physics::Body, physics::Body>, double> last_touch_;  // s
};

}  // namespace elsie::simulation
