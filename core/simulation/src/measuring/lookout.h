// The world as measures see it.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/measure.h"
#include "elsie/physics/engine.h"
#include "elsie/world/description.h"

#include "step/carrier.h"

namespace elsie::simulation {

class Lookout {
 public:
  /// The world must stay where it is: ids are views of it.
  explicit Lookout(const world::World& world);
  Lookout(const Lookout&) = delete;
  Lookout& operator=(const Lookout&) = delete;

  /// As the world's file says, until the first look.
  const Observation& now() const { return now_; }

  /// Whether it shows robots, behaviours and boxes of the same names at the same places, by which
  /// measures count them.
  bool has_cast_of(const Lookout& other) const;

  /// `robots`: those of the world. `decided`: in the step that led here; `is_start`: there was
  /// none. Allocates nothing.
  void look(Robots robots, const physics::Engine& engine, double time_s, bool decided,
            bool is_start);

 private:
  void describe(const world::Robot& robot);
  void describe(const world::Coordination& coordination, const std::string& path, int parent,
                std::vector<ObservedBehavior>& behaviors);
  void add_team(std::string_view team);

  Observation now_;
  std::deque<std::string> paths_;  // of behaviours
  std::vector<std::vector<ObservedBehavior>> behaviors_;
  std::vector<ObservedRobot> robots_;
  std::vector<ObservedBox> all_boxes_;  // as they stand at the start
  std::vector<ObservedBox> boxes_;
  std::vector<std::string_view> teams_;
};

}  // namespace elsie::simulation
