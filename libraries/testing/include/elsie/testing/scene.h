// A world as a measure sees it, put together by hand.
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
/// An arena of 10 m x 10 m with the teams "red" and "blue", at time zero, in steps of 0.01 s, until
/// it is said otherwise. What a robot has no word for here is set where it stands: now["r1"]. A
/// copy is a scene of its own.
class Scene {
 public:
  Scene();

  Scene& arena(double length_m, double width_m);
  /// A step's length, and how many of them make a control period.
  Scene& steps_of(double step_s, int control_steps = 1);
  Scene& team(const std::string& id);

  /// Another robot, with a full battery; the words below are about the one added last.
  Scene& robot(const std::string& id, double x = 0.0, double y = 0.0,
               const std::string& team = "red", double heading_deg = 0.0);
  Scene& leads(bool is_leader = true);
  /// Another behaviour, by its path: "explore", then "explore/wander" inside it. Throws
  /// std::invalid_argument when there is nothing that it could be inside of.
  Scene& behaves(const std::string& path, const std::string& plugin = "");

  Scene& box(const std::string& id, ObservedBox::Kind kind, double x, double y,
             const std::string& team = "");
  Scene& resource(const std::string& id, double x, double y, const std::string& team = "");
  /// It is not there any more: a resource was collected.
  Scene& remove_box(const std::string& id);

  /// A robot, to be changed. Throws std::invalid_argument, with those there are, for another id.
  ObservedRobot& operator[](const std::string& id);
  /// Likewise one of its behaviours, by its path. Its share in the robot's command is seen to.
  ObservedBehavior& behavior(const std::string& robot, const std::string& path);

  /// The instant after the next step: later by its length; robots decided in it when it begins a
  /// control period.
  Scene& step();
  /// The instant after so many steps; 0: the start.
  Scene& at_step(int steps);
  /// Back to the start, with everything as it is.
  Scene& restart() { return at_step(0); }
  double time_s() const { return now_.time_s; }

  /// For calling a measure's object directly. Refers to this scene, and is good until that changes.
  const Observation& observation() const;

 private:
  std::string_view keep(const std::string& text);
  std::size_t index_of(const std::string& robot) const;

  std::shared_ptr<std::deque<std::string>> texts_;  // ids; copies share them
  std::vector<ObservedRobot> robots_;
  std::vector<std::vector<ObservedBehavior>> behaviors_;  // of each robot
  std::vector<ObservedBox> boxes_;
  std::vector<std::string_view> teams_;
  int steps_ = 0;
  int control_steps_ = 1;
  // What observation() refers to, made anew by each call.
  Observation now_;
  mutable Observation view_;
  mutable std::vector<ObservedRobot> seen_;
  mutable std::vector<std::vector<ObservedBehavior>> seen_behaviors_;
};

}  // namespace elsie::testing
