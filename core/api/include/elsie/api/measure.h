// A measure computes figures of a run during the run.
//
// A measure observes the whole world and changes nothing: a run is the same with and without it,
// bit for bit. It belongs to the world, in its <measures>, and is the only kind of plugin that sees
// all robots at once.
//
// A run, for a measure:
//
// 1. reset();
// 2. observe(): the world before the first step, at time zero, with the user's edits;
// 3. observe() after every step. Each observation describes the step before it: the motion that the
//    drives were set to, and the trace of the decision behind it. So the integral of a quantity
//    over time is the sum of all observations but the first, each times `step_s`;
// 4. report() and curves(): the results.
//
// docs/writing-a-measure.md has a complete plugin.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/geometry.h"
#include "elsie/api/localisation.h"
#include "elsie/api/message.h"
#include "elsie/api/motion.h"
#include "elsie/api/registration.h"

namespace elsie {

/// A behaviour of a robot, at any depth, with its trace of the last decision (see TraceRow).
struct ObservedBehavior {
  std::string_view path;    // ids, outermost first: "explore/avoid_obstacle"
  std::string_view plugin;  // its name
  int parent = -1;          // index of the behaviour that contains it; -1: none
  bool asked = false;       // whether it ran
  Motion command;           // its wish
  double activation = 0.0;
  double share = 0.0;        // its part in the command of its own coordinator, in [0, 1]
  double robot_share = 0.0;  // its part in the robot's command: the product of nested shares
};

/// A number that a plugin publishes; see publishes().
struct ObservedNumber {
  std::string_view name;  // "explore/avoid.clearance": the plugin's path, then its own
  std::string_view unit;
};

/// Reads the numbers that the plugins of a robot publish, or the measures and rules of the world.
class ObservedNumbers {
 public:
  /// All of them at this instant, in the order of `published`; NaN: there is none.
  virtual std::span<const double> now() const = 0;

 protected:
  ~ObservedNumbers() = default;
};

struct ObservedRobot {
  std::string_view id;
  std::string_view team;
  Pose pose;                 // the true one
  Belief believed;           // what it takes for its pose and motion; see localisation.h
  Motion asked;              // by its coordinator, in the last decision; zero before the first
  Motion command;            // as the drive can make it
  Motion moving;             // the true motion
  Motion odometry;           // from the joints of its drive
  WheelPair wheels;          // converts motions to wheel rates; see OwnState
  double distance_m = 0.0;   // driven so far
  double energy = 0.0;       // in the battery, units
  double energy_used = 0.0;  // taken from it so far, units
  double capacity = 0.0;     // of the battery, units
  int collisions = 0;        // so far
  int collected = 0;         // resources, so far
  Talk talk;                 // so far
  bool is_leader = false;
  bool charging = false;
  bool empty = false;  // the battery is empty: the robot stops
  /// A behaviour comes before those inside it; otherwise in the order of the world file.
  std::span<const ObservedBehavior> behaviors;
  std::span<const ObservedNumber> published;
  const ObservedNumbers* numbers = nullptr;  // their values; null before the first observation

  /// The behaviour with this path, or null.
  const ObservedBehavior* behavior(std::string_view path) const;
};

/// A box that is still there.
struct ObservedObstacle {
  enum class Kind { fixed, dynamic, moving, resource };

  std::string_view id;
  Kind kind = Kind::fixed;
  std::string_view team;  // of a resource; empty: any
  Pose pose;              // of its middle
};

/// An event that was raised since the last observation; docs/events.md lists those of the
/// simulator.
struct ObservedEvent {
  std::string_view name;
  std::string_view robot;  // its id; empty: an edit of the world
};

/// A field of the world: its cells divide the arena evenly.
struct ObservedField {
  std::string_view id;
  std::size_t columns = 0, rows = 0;  // along x and y
  std::span<const double> cells{};    // rows from south to north; none before the first observation
  double scale = 1.0;                 // times a cell: its value, units/m2
};

/// The world at an instant. It refers to memory of the simulator and is valid only during the call.
/// Ids, and the indices of robots and behaviours, do not change from equipped() on while the
/// measure lives. Reading it allocates nothing.
struct Observation {
  double time_s = 0.0;          // since the start
  double step_s = 0.01;         // length of a step
  double period_s = 0.01;       // from one decision to the next: a whole number of steps
  double arena_length_m = 0.0;  // along x; the middle of the arena is the origin
  double arena_width_m = 0.0;
  bool is_start = false;                        // before the first step
  bool decided = false;                         // robots sensed and decided in the step just made
  std::span<const ObservedRobot> robots;        // in the order of the world file
  std::span<const ObservedObstacle> obstacles;  // in the order of the world file, resources last
  std::span<const std::string_view> teams;
  std::span<const ObservedEvent> events;  // in the order in which they were raised
  std::span<const ObservedField> fields;
  std::span<const ObservedNumber> published;  // by measures and rules: "respawn.returned"
  const ObservedNumbers* numbers = nullptr;   // their values, as in ObservedRobot

  /// The robot with this id. Throws std::invalid_argument with a sentence that lists the robots.
  const ObservedRobot& robot(std::string_view id) const;
  /// Throws std::invalid_argument, as robot() does, when there is no such team.
  void require_team(std::string_view id) const;
};

/// The outcome of a run, or `running`.
struct RunEnd {
  enum class Outcome { running, success, failure, time_limit };

  Outcome outcome = Outcome::running;
  double time_s = 0.0;  // simulated
};

/// "success", "failure", "time_limit"; "running" before the end.
const char* to_string(RunEnd::Outcome outcome);

/// The description of one value of a measure, known before any run.
struct Quantity {
  /// It follows the measure's id in results: the value "time_s" of <place_reached id="home"/> is
  /// "home.time_s". Letters, digits, "_", "-", "." and "/". One name may be empty: its value has
  /// the measure's id as its name.
  std::string name;
  std::string unit;     // "m"; "" for a pure number
  std::string meaning;  // one line

  friend bool operator==(const Quantity&, const Quantity&) = default;
};

/// See the head of this file. Keep sums, not histories: the test library checks that the memory of
/// a measure does not grow with the number of steps.
class Measure : public Component {
 public:
  /// Called after configured(), before the first run and any decision, with the world of the file.
  /// Throw (std::invalid_argument, with a sentence) when parameters name something that does not
  /// exist: the error gets the measure's line in the world file.
  virtual void equipped(const Observation& start);

  /// The values that it reports, in this order, after equipped(). They must not change between
  /// runs.
  virtual std::vector<Quantity> quantities() const = 0;

  /// Observes an instant. It should not allocate memory.
  virtual void observe(const Observation& now) = 0;

  /// Fills in the values of the run so far, one for each of quantities(). All are none before the
  /// call: leave those without a value, such as the time of something that never happened. Numbers
  /// must be finite. May be called at any time, also before observe(), and more than once.
  virtual void report(const RunEnd& end, std::span<std::optional<double>> values) const = 0;
};

/// Makes a measure class a plugin; see ELSIE_BEHAVIOR. A measure raises no events and needs no
/// readings. An edit of it during a run creates a new object.
#define ELSIE_MEASURE(Class, ...) \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::measure, Class, __VA_ARGS__)

}  // namespace elsie
