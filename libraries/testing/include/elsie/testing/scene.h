// A world made up by hand, as a measure or a rule sees it.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/measure.h"

namespace elsie::testing {

///   Scene now;
///   now.robot("r1", 1, 2).behaves("wander").robot("r2", 0, 0, "blue").leads();
///   now["r1"].distance_m = 0.5;
///   now.step();
///
/// By default an arena of 10 m x 10 m with the teams "red" and "blue", at time zero, in steps of
/// 0.01 s. Members of a robot that have no function here are set directly: now["r1"]. Copies are
/// independent.
class Scene {
 public:
  Scene();

  Scene& arena(double length_m, double width_m);
  /// Sets the length of a step and the number of steps in a control period.
  Scene& steps_of(double step_s, int control_steps = 1);
  Scene& team(const std::string& id);

  /// Adds a robot with a full battery; the functions below change the last one.
  Scene& robot(const std::string& id, double x = 0.0, double y = 0.0,
               const std::string& team = "red", double heading_deg = 0.0);
  Scene& leads(bool is_leader = true);
  /// Adds a behaviour by its path: "explore", then "explore/wander" inside of it. Throws
  /// std::invalid_argument when the outer one does not exist.
  Scene& behaves(const std::string& path, const std::string& plugin = "");
  /// Adds a number that a plugin of the robot publishes, such as "explore.known"; before the first
  /// robot, one that a rule or measure publishes. There is none until number() sets it.
  Scene& publishes(const std::string& name, const std::string& unit = "");

  Scene& box(const std::string& id, ObservedObstacle::Kind kind, double x, double y,
             const std::string& team = "");
  Scene& resource(const std::string& id, double x, double y, const std::string& team = "");
  /// Sets the values of a field of the world: `columns` cells along x, and as many rows as there
  /// are numbers for, from south to north.
  Scene& field(const std::string& id, std::size_t columns, std::vector<double> cells);
  /// Removes a box, as when a resource was collected.
  Scene& remove_obstacle(const std::string& id);

  /// Adds an event of the step that was just made; the next step() forgets it.
  Scene& event(const std::string& name, const std::string& robot = "");

  /// A robot, to be changed. For another id, throws std::invalid_argument with the existing ones.
  ObservedRobot& operator[](const std::string& id);
  /// One of its behaviours by its path, to be changed. Its share in the robot's command is
  /// computed.
  ObservedBehavior& behavior(const std::string& robot, const std::string& path);
  /// One of its published numbers, to be changed; without a robot, one of the world's.
  double& number(const std::string& robot, const std::string& name);

  /// Moves to the instant after the next step. Robots decide in it when it begins a control period.
  Scene& step();
  /// Moves to the instant after so many steps; 0: the start.
  Scene& at_step(int steps);
  /// Moves to the start without other changes.
  Scene& restart() { return at_step(0); }
  double time_s() const { return now_.time_s; }

  /// For calling a plugin's object directly. Refers to this scene, and is valid until that
  /// changes.
  const Observation& observation() const;

 private:
  struct Numbers final : ObservedNumbers {
    std::span<const double> now() const override { return values; }
    std::vector<ObservedNumber> names;
    std::vector<double> values;
  };

  std::string_view keep(const std::string& text);
  std::size_t index_of(const std::string& robot) const;

  std::shared_ptr<std::deque<std::string>> texts_;  // ids; copies share them
  std::vector<ObservedRobot> robots_;
  std::vector<std::vector<ObservedBehavior>> behaviors_;  // for each robot
  std::vector<Numbers> numbers_;                          // for each robot
  Numbers of_world_;
  std::vector<ObservedObstacle> boxes_;
  std::vector<std::string_view> teams_;
  std::vector<ObservedEvent> events_;
  std::vector<ObservedField> fields_;
  std::vector<std::vector<double>> cells_;  // for each field
  int steps_ = 0;
  int control_steps_ = 1;
  // The data that observation() refers to, renewed by each call.
  Observation now_;
  mutable Observation view_;
  mutable std::vector<ObservedRobot> seen_;
  mutable std::vector<std::vector<ObservedBehavior>> seen_behaviors_;
  mutable std::vector<Numbers> seen_numbers_;
  mutable Numbers seen_of_world_;
  mutable std::vector<ObservedField> seen_fields_;
  mutable std::vector<std::vector<double>> seen_cells_;
};

}  // namespace elsie::testing
