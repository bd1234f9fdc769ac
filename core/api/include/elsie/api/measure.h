// A measure: figures of a run, worked out while the run goes on.
//
// A measure watches the whole world and changes nothing: with and without it a run is the same, bit
// for bit. It belongs to the world, stands in its <measures>, and is the only kind of plugin that
// sees all robots at once.
//
// A run, for a measure:
//
// 1. reset();
// 2. observe(): the world before the first step, at time zero, with what a user changed for it;
// 3. observe() after every step. What holds from one observation to the next is what the later one
//    says: the motion that drives were set to in the step just made, the trace of the decision
//    behind it. So a mean over time is a sum over observations, each times `step_s`, the first left
//    out;
// 4. report(): what came of it.
//
// A whole plugin: docs/writing-a-measure.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/geometry.h"
#include "elsie/api/motion.h"
#include "elsie/api/registration.h"

namespace elsie {

/// A behaviour of a robot, at whatever depth, with what its coordinator noted in the last decision
/// (see TraceRow).
struct ObservedBehavior {
  std::string_view path;    // ids from the robot on: "explore/avoid_obstacle"
  std::string_view plugin;  // its name
  int parent = -1;     // the behaviour that it is inside of, by its place on the robot; -1: none
  bool asked = false;  // whether it ran
  Motion command;      // what it wished for
  double activation = 0.0;
  double share = 0.0;        // its part in the command of its own coordinator, in [0, 1]
  double robot_share = 0.0;  // its part in the robot's: times the shares of those around it
};

struct ObservedRobot {
  std::string_view id;
  std::string_view team;
  Pose pose;
  Motion asked;              // by its coordinator, in the last decision; zero before the first
  Motion command;            // the same as the drive can make it
  Motion moving;             // measured
  Motion odometry;           // by the joints of its drive
  WheelPair wheels;          // as OwnState's: what a motion is in wheel rates
  double distance_m = 0.0;   // driven so far
  double energy = 0.0;       // in the battery, units
  double energy_used = 0.0;  // taken from it so far, units
  double capacity = 0.0;     // of the battery, units
  int collisions = 0;        // so far
  int collected = 0;         // resources, so far
  bool is_leader = false;
  bool charging = false;
  bool empty = false;  // the battery is: the robot stands
  /// Each before those inside it, in the order of the world file.
  std::span<const ObservedBehavior> behaviors;

  /// The behaviour with this path, or null.
  const ObservedBehavior* behavior(std::string_view path) const;
};

/// A box that is still there.
struct ObservedBox {
  enum class Kind { fixed, dynamic, moving, resource };

  std::string_view id;
  Kind kind = Kind::fixed;
  std::string_view team;  // of a resource; empty: any
  Pose pose;              // of its middle
};

/// The world at an instant. Refers to memory of the simulator and is valid during the call only;
/// but ids stay what they are, and robots and behaviours their places, from equipped() on for as
/// long as the measure lives. Reading one allocates nothing.
struct Observation {
  double time_s = 0.0;          // since the start
  double step_s = 0.01;         // length of a step
  double period_s = 0.01;       // from one decision to the next: a whole number of steps
  double arena_length_m = 0.0;  // along x; the middle of the arena is the origin
  double arena_width_m = 0.0;
  bool is_start = false;                  // before the first step
  bool decided = false;                   // robots sensed and decided in the step just made
  std::span<const ObservedRobot> robots;  // in the order of the world file
  std::span<const ObservedBox> boxes;     // likewise, resources last
  std::span<const std::string_view> teams;

  /// The robot of this id. Throws std::invalid_argument with a sentence that says which there are.
  const ObservedRobot& robot(std::string_view id) const;
  /// Throws likewise when there is no such team.
  void require_team(std::string_view id) const;
};

/// How a run ended, or that it goes on.
struct RunEnd {
  enum class Outcome { running, success, failure, time_limit };

  Outcome outcome = Outcome::running;
  double time_s = 0.0;  // simulated
};

/// "success", "failure", "time_limit"; "running" before the end.
const char* to_string(RunEnd::Outcome outcome);

/// What a measure says of one of its values, before any run.
struct Quantity {
  /// What it adds to the measure's id: the value "time_s" of <place_reached id="home"/> is
  /// "home.time_s" in results. Letters, digits, "_", "-", "." and "/". One may be empty: it is
  /// called as the measure is.
  std::string name;
  std::string unit;     // "m"; "" for a pure number
  std::string meaning;  // one line

  friend bool operator==(const Quantity&, const Quantity&) = default;
};

/// See the head of this file. It keeps sums, not histories: the tests of the test library see to it
/// that its memory does not grow with the number of steps.
class Measure : public Component {
 public:
  /// Called after configured(), before the first run: the world as its file says, nothing decided
  /// yet. Throw (std::invalid_argument, with a sentence) for parameters that name what is not
  /// there: the error is that of the measure's line in the world file.
  virtual void equipped(const Observation& start);

  /// What it will report, in this order, once it is equipped. Must not change from run to run.
  virtual std::vector<Quantity> quantities() const = 0;

  /// Takes note of an instant. Allocates nothing, if it can.
  virtual void observe(const Observation& now) = 0;

  /// The values of the run so far, one for each of quantities(), all of them none at first: leave
  /// what has no value, such as the time of something that never happened. Finite numbers. May be
  /// called at any time, also before anything was observed, and more than once.
  virtual void report(const RunEnd& end, std::span<std::optional<double>> values) const = 0;
};

/// Makes a measure class a plugin; see ELSIE_BEHAVIOR. A measure raises no events and needs no
/// readings. An edit of it in a run makes it anew.
#define ELSIE_MEASURE(Class, ...) \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::measure, Class, __VA_ARGS__)

}  // namespace elsie
