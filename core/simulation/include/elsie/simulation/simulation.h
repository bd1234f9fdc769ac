// A world that runs.
//
//   const world::World world = world::read_world("clutter.xml", host);
//   simulation::Simulation simulation(world, host, {.seed = 7});
//   const simulation::RunResult result = simulation.run();
//
// One step: sensors -> each robot's coordinator and its behaviours -> energy -> motors -> physics
// -> collection, charging, goals. All robots decide on the same instant, before any of them moves.
// Between two steps a user may edit it: see change.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/api/coordinator.h"
#include "elsie/api/inference.h"
#include "elsie/api/perception.h"
#include "elsie/api/sensor.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/camera_renderer.h"
#include "elsie/simulation/change.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/observer.h"
#include "elsie/simulation/replacement.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// What a call of a plugin may take while the world runs. Beyond it, PluginFault. Zero: anything.
/// Whether a budget is met depends on the machine: a run that ends for it may not end there again.
struct Budget {
  /// By the clock, for one call without those of other plugins within it, s.
  double time_s = 0.0;
  /// What one object may come to hold in all its calls since the start of the run, bytes: what it
  /// leaves allocated on the heap, of which a plugin that leaks has more and more.
  std::size_t memory = 0;
};

struct Options {
  std::uint64_t seed = 1;
  /// Measure how long each behaviour takes, for the trace. Changes nothing else.
  bool measure_time = false;
  /// Where data files that a change names are looked for when they are not beside the world's file.
  std::vector<std::string> data_directories{};
  /// Paths of data files by their names, as in world::ReadOptions. They are used before any search.
  std::map<std::string, std::string> files{};
  Budget budget{};
  /// Simulated time after which the run ends, s, instead of the world's <limits>; above 0. The
  /// world stays as its file says: an <endure> goal may last longer.
  std::optional<double> time_limit_s{};
  /// What takes the pictures of cameras: render::world_cameras, for example. A world that has
  /// cameras needs it.
  MakeCameraRenderer cameras{};
};

/// One sensor of a robot, to look at.
struct SensorView {
  std::string_view id;
  std::string_view plugin;
  const Sensor* sensor;
  const Mounting* mounting;
  const Camera* camera;   // that it looks through, or none
  const Image* picture;   // what that saw last; none before the first step
  const Pyramid* volume;  // that it asked about last, or none
};

/// One segment that a robot pulls, at this instant.
struct SegmentView {
  const world::Segment* description;  // none: it is part of the robot's drive
  Frame frame;                        // origin below the middle of its axle, at wheel-bottom height
  Pose pose;                          // the same on the floor
  double yaw_rad;    // of its joint, from in line with the body in front, counter-clockwise
  double pitch_rad;  // likewise; positive where its front points up
};

/// One behaviour among all those of a robot, whatever depth it stands at, with the trace of the
/// last decision.
struct TracedMember {
  std::string path;              // ids from the robot on: "explore/avoid_obstacle"
  std::string_view plugin;       // the behaviour's
  std::string_view coordinator;  // the plugin of the coordinator that decides about it
  int depth = 0;                 // 0: the robot's own
  int parent = -1;               // the behaviour that it is inside of, by its place; -1: none
  const Member* member = nullptr;
};

/// What a behaviour or coordinator has inferred in the last decision.
struct MadeInference {
  std::string path;  // of ids from the robot on: "explore/avoid_obstacle"
  Inference inference;
};

/// One robot at this instant, to look at.
struct RobotView {
  const world::Robot* description;  // without what was put in place since
  const OwnState* state;            // as it was last perceived or, between steps, as it is now
  Motion asked;                     // what its coordinator commanded last
  Motion command;                   // the same as its drive can make it
  std::span<const Member> members;  // its own behaviours, with the trace of the last decision
  /// The same and those inside them: each behaviour before those inside it, in file order.
  /// Member::trace.inhibited_by counts among the members of one parent.
  std::span<const TracedMember> trace;
  double distance_m;  // driven so far
  int collisions;
  bool empty;  // the battery is
  /// What the joints of its body hold that can be set, in the order of their parts, measured.
  std::span<const JointSetting> joints;
};

class Simulation {
 public:
  /// Makes all objects of the world and puts it at time zero. Throws world::WorldError when a
  /// plugin refuses its parameters, with the place in the world file. The host must stay where it
  /// is for as long as the simulation lives.
  Simulation(world::World world, const plugin::Host& host, const Options& options = {});
  Simulation(Simulation&&) noexcept;
  ~Simulation();

  /// Back to time zero, with this seed or the one before. Changes are forgotten: what follows is
  /// what a new simulation with that seed does.
  void reset(std::optional<std::uint64_t> seed = std::nullopt);

  /// One step. Throws PluginFault and PhysicsFault. After the end of the run it goes on all the
  /// same; the outcome stays.
  void step();

  /// Steps until a goal or a limit ends the run. Throws PluginFault, also of a measure, and
  /// PhysicsFault.
  ///
  /// The edits in World::changes and `changes` are made on the way, those of one time together, at
  /// time zero before observers hear of the start. They are checked before the run begins:
  /// ChangeRefused tells of what can be known then (a path, a type, a range, a time that never
  /// comes), in which case nothing has happened. One of the world's own whose time never comes is
  /// not made, which a note says. It also ends a run in which there is no room for a
  /// robot when its time comes. One whose time has not come when a goal ends the run is not made.
  ///
  /// `before_control`: called before every step in which robots sense and decide, after the changes
  /// for it. It may do to the simulation what a user may do between two steps; what it throws ends
  /// the run.
  RunResult run(std::span<Observer* const> observers = {},
                std::span<const TimedChange> changes = {},
                const std::function<void(Simulation&)>& before_control = {});

  /// The same check by itself, as things are now. Returns those that are never made; throws
  /// ChangeRefused with all that cannot be made.
  std::vector<UnmadeChanges> check(std::span<const TimedChange> changes) const;

  // Edits between two steps, until the next reset; see change.h. Each adds an event "changed" to
  // the log, of the robot that it concerns if it is one, whose detail is the edit with the full
  // path of every attribute that is put in place: "robot[r1]/@max_speed=0.3". Behaviours do not
  // perceive that event.

  /// Makes an edit. Throws ChangeRefused and leaves all as it was when the world that comes out is
  /// none that a file could describe, a plugin refuses it, or there is no room for a body at this
  /// instant. PluginFault when a plugin that has refused a value does not take its old one back.
  void change(std::string_view path, std::string_view value);
  /// Makes them all, or none: what is to fit together is set together, such as a robot's x and y.
  void change(std::span<const Change> changes);

  /// Replaces all objects of plugins whose declarations `host` has others of than the host before:
  /// one that was renewed() from it. replacement.h says what becomes of them. Each is an event
  /// "replaced" of its robot, which behaviours do not perceive. Throws ReplacementRefused, and all
  /// is as it was. Otherwise the new host is the one that must stay from now on; a reset, too,
  /// leaves the new objects where they are.
  Replacement replace_plugins(const plugin::Host& host);

  /// Returns the result so far. Throws PluginFault when a measure fails to report; from then on it
  /// has no values.
  RunResult result() const;

  /// The measures so far, as in result(). Throws as that.
  std::vector<MeasuredValue> measures() const;

  /// As it was edited, without what was put in place since.
  const world::World& world() const;
  /// As it was at time zero, with all edits that run() was given among World::changes: a run of it
  /// with the same seed and time limit is the same, bit for bit.
  world::World start() const;
  std::uint64_t seed() const;
  double time_s() const;
  /// Simulated time after which a run ends, whatever its goals.
  double time_limit_s() const;
  std::uint64_t steps() const;
  /// Whether robots sensed and decided in the last step, and when that began, s.
  bool decided() const;
  double step_began_s() const;
  Outcome outcome() const;
  std::uint64_t state_hash() const;
  std::span<const EventRecord> events() const;
  /// What plugins have to say about this run since it was reset.
  std::span<const Note> notes() const;

  std::size_t robots() const;
  RobotView robot(std::size_t index) const;
  std::size_t sensors(std::size_t robot) const;
  SensorView sensor(std::size_t robot, std::size_t index) const;
  /// Appends the numbers of a sensor's current reading, by name. Throws PluginFault.
  void list_values(std::size_t robot, std::size_t sensor, std::vector<NamedValue>& values) const;
  /// What those of the robot's plugins have inferred that say so and were asked in the last
  /// decision. Throws PluginFault.
  std::vector<MadeInference> inferences(std::size_t robot) const;
  /// Where a sensor is in the world now.
  Frame sensor_frame(std::size_t robot, std::size_t index) const;
  /// How many vehicles a robot pulls: those of its drive, then its segments.
  std::size_t segments(std::size_t robot) const;
  /// One of them, counted from the robot backwards.
  SegmentView segment(std::size_t robot, std::size_t index) const;
  /// Where a box is now; none when it was collected.
  std::optional<Pose> box(std::size_t index) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::simulation
