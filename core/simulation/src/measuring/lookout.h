// The world as measures and rules see it.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/measure.h"
#include "elsie/physics/engine.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/run_result.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/description.h"

#include "robot/robot_surroundings.h"
#include "step/fields.h"

namespace elsie::simulation {

class Lookout {
 public:
  /// The world must outlive this object and must not move: ids are views of it.
  /// `visit_published`: of the measures and rules.
  Lookout(const world::World& world, const plugin::Host& host,
          std::function<void(const VisitPublished&)> visit_published);
  Lookout(const Lookout&) = delete;
  Lookout& operator=(const Lookout&) = delete;

  /// The last observation; before the first look(), the world of the file.
  const Observation& now() const { return now_; }

  /// True if robots, behaviours and obstacles have the same names and indices, which measures use.
  bool has_cast_of(const Lookout& other) const;

  /// An edit has put a box elsewhere.
  void place_box(std::size_t index, const Pose& pose) { all_obstacles_[index].pose = pose; }

  /// Updates now(). `decided`: robots decided in the last step; `is_start`: as in Observation.
  /// Allocates nothing.
  void look(Robots robots, const physics::Engine& engine, const Fields& fields,
            std::span<const EventRecord> events, double time_s, bool decided, bool is_start);

 private:
  /// The numbers of one robot, or of the world, read when a measure asks for them.
  class Numbers final : public ObservedNumbers {
   public:
    std::span<const double> now() const override;

    std::vector<ObservedNumber> names;
    std::function<void(const VisitPublished&)> visit_published;
    mutable bool is_read = false;
    mutable std::vector<double> values;
  };

  void describe(const world::Robot& robot);
  void list_published(PluginKind kind, const world::PluginUse& use, const std::string& within);
  void describe(const world::Coordination& coordination, const std::string& path, int parent,
                std::vector<ObservedBehavior>& behaviors);
  void add_team(std::string_view team);

  Observation now_;
  const plugin::Host& host_;
  std::deque<std::string> paths_;  // of behaviours and numbers
  std::deque<Numbers> numbers_;    // of the robots, then of the world
  std::vector<std::vector<ObservedBehavior>> behaviors_;
  std::vector<ObservedRobot> robots_;
  std::vector<ObservedObstacle> all_obstacles_;  // at the start
  std::vector<bool> stay_in_place_;              // of them
  std::vector<ObservedObstacle> obstacles_;
  std::vector<std::string_view> teams_;
  std::vector<ObservedEvent> events_;
  std::vector<ObservedField> fields_;
};

}  // namespace elsie::simulation
