// The simulation of a world.
//
//   const world::World world = world::read_world("clutter.xml", host);
//   simulation::Simulation simulation(world, host, {.seed = 7});
//   const simulation::RunResult result = simulation.run();
//
// One step: sensors -> each robot's coordinator and its behaviours -> energy -> motors -> physics
// -> collection, charging, goals. All robots decide at the same instant, before any of them moves.
// A user may edit the world between two steps: see edit.h.
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

#include "elsie/api/actuator.h"
#include "elsie/api/body.h"
#include "elsie/api/coordinator.h"
#include "elsie/api/inference.h"
#include "elsie/api/perception.h"
#include "elsie/api/sensor.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/camera_renderer.h"
#include "elsie/simulation/edit.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/observer.h"
#include "elsie/simulation/replacement.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/description.h"
#include "elsie/world/fields.h"

namespace elsie::simulation {

/// Limits for calls of plugins during a run; exceeding one is a PluginFault. Zero: no limit. Time
/// and memory depend on the machine: a run that exceeds a limit may not do so again.
struct Budget {
  /// Wall time of one call, without nested calls of other plugins, s.
  double time_s = 0.0;
  /// Heap memory that all calls of one object since the start of the run may leave allocated,
  /// bytes; it grows without end in a plugin that leaks.
  std::size_t memory = 0;
};

struct Options {
  std::uint64_t seed = 1;
  /// Measure how long each behaviour takes, for the trace. Changes nothing else.
  bool measure_time = false;
  /// Folders for data files that an edit names, if they are not in the folder of the world's file.
  std::vector<std::string> data_directories{};
  /// Paths of data files by their names, as in world::ReadOptions. They are used before any search.
  std::map<std::string, std::string> files{};
  Budget budget{};
  /// Threads in which robots sense, decide and move, at least 1. The run is the same with any
  /// number, bit for bit. With a budget this must be 1: the work of other threads would be counted.
  std::size_t threads = 1;
  /// Simulated time after which the run ends, s, instead of the world's <limits>; above 0. It does
  /// not change the world: an <endure> goal may last longer.
  std::optional<double> time_limit_s{};
  /// Makes the camera renderer, for example render::world_cameras. A world with cameras needs it.
  MakeCameraRenderer cameras{};
  /// Only makes the objects; call reset() before anything else. The run is the same as without it.
  bool begin_later = false;
};

/// A view of one sensor of a robot.
struct SensorView {
  std::string_view id;
  std::string_view plugin;
  const Sensor* sensor;
  const Mounting* mounting;
  const Camera* camera;  // its camera, or none
  const Image* picture;  // its last picture; none before the first step
};

/// A view of one actuator of a robot.
struct ActuatorView {
  std::string_view id;
  std::string_view plugin;
  const Actuator* actuator;
  std::string_view by;  // the path of the behaviour that gave its command; empty: none did yet
  Frame frame;          // in the world
  std::optional<Colour> shine;  // none: it is dark
};

/// A number that a plugin publishes, at this instant.
struct PublishedValue {
  std::string_view path;  // of the plugin, as in TracedMember; of a measure its id
  const PublishedNumber& number;
  double value;  // NaN: there is none now
};
using VisitPublished = std::function<void(const PublishedValue&)>;

/// What a plugin draws.
struct PluginSketch {
  std::string path;  // as in PublishedValue
  PluginKind kind;
  Sketch sketch;
};

/// One segment that a robot pulls, at this instant.
struct SegmentView {
  const world::Segment* description;  // null: it is part of the robot's drive
  Frame frame;                        // origin below the middle of its axle, at wheel-bottom height
  Pose pose;                          // projected onto the floor
  double yaw_rad;    // of its joint, counter-clockwise; 0: in line with the body in front
  double pitch_rad;  // of its joint; positive if its front points up
};

/// A field at this instant.
struct FieldView {
  const world::ScalarField* description;
  world::FieldCells cells;
  std::span<const double> grid;  // rows from south to north, each from west to east
  double scale;                  // a value of the grid times this is in units/m2

  double value(std::size_t column, std::size_t row) const {
    return scale * grid[row * cells.columns + column];
  }
};

/// One behaviour of a robot, at any depth, with the trace of the last decision.
struct TracedMember {
  std::string path;              // ids, outermost first: "explore/avoid_obstacle"
  std::string_view plugin;       // the behaviour's
  std::string_view coordinator;  // the plugin of its coordinator
  int depth = 0;                 // 0: the robot's own
  int parent = -1;               // index of the behaviour that contains it; -1: none
  const Member* member = nullptr;
};

/// The graph of a coordinator, as of the last decision.
struct LitGraph {
  std::string path;         // ids, outermost first: "arbiter_states", "explore/arbiter_tree"
  std::string_view plugin;  // the coordinator's
  Graph graph;
  std::vector<NodeState> lights;  // of its nodes
};

/// An inference of a behaviour or coordinator in the last decision.
struct MadeInference {
  std::string path;  // ids, outermost first: "explore/avoid_obstacle"
  Inference inference;
};

/// A view of one robot at this instant.
struct RobotView {
  const world::Robot* description;  // as edited
  const OwnState* state;            // as last perceived, or, between steps, the present state
  Pose pose;                        // true; state->pose is what it believes
  Motion moving;                    // true
  Motion asked;                     // the last command of its coordinator
  Motion command;                   // the same, as its drive can make it
  std::span<const Member> members;  // its own behaviours, with the trace of the last decision
  /// These and the behaviours inside them, in file order, each before those inside it.
  /// Member::trace.inhibited_by is an index among the members of the same parent.
  std::span<const TracedMember> trace;
  double distance_m;  // driven so far
  int collisions;
  bool empty;  // the battery is empty
  /// Measured values of the joints that can be set, in the order of their parts.
  std::span<const JointSetting> joints;
  std::optional<Talk> talk{};  // so far; none: it has no actuator that hears messages
};

class Simulation {
 public:
  /// Makes all objects of the world and starts at time zero. Throws world::WorldError, with the
  /// place in the world file, when a plugin refuses its parameters. The host must outlive the
  /// simulation and must not move.
  Simulation(world::World world, const plugin::Host& host, const Options& options = {});
  Simulation(Simulation&&) noexcept;
  ~Simulation();

  /// Returns to time zero, with this seed or the previous one, and forgets edits. The run is then
  /// the same as that of a new simulation with this seed.
  void reset(std::optional<std::uint64_t> seed = std::nullopt);

  /// Makes one step, without the world's own edits and rules; see run.h for steps with them. Throws
  /// PluginFault and PhysicsFault. Steps are possible after the end of the run; the outcome stays.
  void step();

  /// Steps until a goal or a limit ends the run. Throws PluginFault, also of a measure, and
  /// PhysicsFault.
  ///
  /// The run makes the edits in World::edits and `edits`, those of one time together, those of
  /// time zero before Observer::started(). It checks them before it begins and throws EditRefused
  /// for what is then known to be wrong (a path, a type, a range, a time after the end); nothing
  /// has changed then. An edit of the world's own whose time is after the end only causes a note.
  /// EditRefused also ends a run if there is no room for a robot when an edit is due. Edits after
  /// the time at which a goal ends the run are not made.
  ///
  /// `before_control`: called before every step in which robots sense and decide, after the edits
  /// that are due. It may make the edits that a user may make between two steps; its exceptions
  /// end the run.
  RunResult run(std::span<Observer* const> observers = {}, std::span<const TimedEdit> edits = {},
                const std::function<void(Simulation&)>& before_control = {});

  /// Only makes the check of run(), in the present state. Returns the edits that are never made;
  /// throws EditRefused with all edits that cannot be made.
  std::vector<UnmadeEdits> check(std::span<const TimedEdit> edits) const;

  // Edits between two steps, until the next reset; see edit.h. Each adds an event "changed" to
  // the log of the run, for the robot that it affects, if any. Its detail is the edit, with the
  // full path of an attribute that is changed in place: "robot[r1]/@max_speed=0.3". Behaviours do
  // not perceive it.

  /// Makes an edit. Throws EditRefused and changes nothing when a file with the new world would
  /// be refused, a plugin refuses the edit, or there is no room for a body at this instant. Throws
  /// PluginFault when a plugin that refused a value does not accept its old value again.
  void edit(std::string_view path, std::string_view value);
  /// Makes all edits or none. Set values that depend on each other together, such as a robot's x
  /// and y.
  void edit(std::span<const Edit> edits);

  /// Replaces all objects of plugins whose declarations differ in `host`, which was renewed() from
  /// the previous host; see replacement.h. Each adds an event "replaced" for its robot, which
  /// behaviours do not perceive. Throws ReplacementRefused and changes nothing if an object is
  /// refused. Otherwise the new host must outlive the simulation; new objects stay after a reset.
  Replacement replace_plugins(const plugin::Host& host);

  /// Returns the result so far. Throws PluginFault when a measure fails to report; later results
  /// have no values of measures.
  RunResult result() const;

  /// The measures so far, as in result(). Throws as result() does.
  std::vector<MeasuredValue> measures() const;

  /// The edited world.
  const world::World& world() const;
  /// The world at time zero, with all edits given to run() in World::edits: a run of it with the
  /// same seed and time limit is the same, bit for bit.
  world::World start() const;
  bool has_edits() const;  // otherwise start() is world()
  std::uint64_t seed() const;
  double time_s() const;
  /// The simulated time after which a run ends, even if goals are open, s.
  double time_limit_s() const;
  std::uint64_t steps() const;
  /// For the last step: whether robots sensed and decided in it, and the time of its start, s.
  bool decided() const;
  double step_began_s() const;
  Outcome outcome() const;
  std::uint64_t state_hash() const;
  std::span<const EventRecord> events() const;
  /// The notes of this run so far.
  std::span<const Note> notes() const;

  std::size_t robots() const;
  RobotView robot(std::size_t index) const;
  /// The object of a sensor, behaviour or coordinator of a robot, at any depth: for trainers. `use`
  /// is part of world(). Throws std::invalid_argument when the robot has no such part.
  Component& object(std::size_t robot, const world::PluginUse& use);
  /// Sets the priority of a behaviour, by its index in RobotView::trace, until the next edit of the
  /// robot or reset(): for learning, where it may change in every step. No event, and not
  /// part of world(): who wants the run to be repeated makes the edit instead. Throws
  /// std::invalid_argument if there is no such behaviour, or the number is not finite.
  void set_priority(std::size_t robot, std::size_t behavior, double priority);
  std::size_t sensors(std::size_t robot) const;
  SensorView sensor(std::size_t robot, std::size_t index) const;
  /// Calls `visit` for each field of a sensor's current reading. Throws PluginFault, and what
  /// `visit` throws.
  void visit_reading(std::size_t robot, std::size_t sensor, const FieldVisit& visit) const;
  std::size_t actuators(std::size_t robot) const;
  ActuatorView actuator(std::size_t robot, std::size_t index) const;
  /// What its actuators heard before the last decision.
  std::span<const HeardMessage> heard(std::size_t robot) const;
  /// The same for the command that an actuator carries out.
  void visit_command(std::size_t robot, std::size_t actuator, const FieldVisit& visit) const;
  /// Calls `visit` for each number that the plugins of a robot publish, in the same order until
  /// edits change the robot; the other one for those of measures. Throws PluginFault.
  void visit_published(std::size_t robot, const VisitPublished& visit) const;
  void visit_published(const VisitPublished& visit) const;
  /// What the plugins of a robot draw, and what measures draw. Throws PluginFault.
  std::vector<PluginSketch> sketches(std::size_t robot) const;
  std::vector<PluginSketch> sketches() const;
  /// The inferences of the last decision, from the robot's plugins that derive from Infers and were
  /// asked. Throws PluginFault.
  std::vector<MadeInference> inferences(std::size_t robot) const;
  /// The graphs of its coordinators that show one, at any depth. Throws PluginFault.
  std::vector<LitGraph> graphs(std::size_t robot) const;
  /// The present frame of a sensor in the world.
  Frame sensor_frame(std::size_t robot, std::size_t index) const;
  /// The number of vehicles that a robot pulls: those of its drive, then its segments.
  std::size_t segments(std::size_t robot) const;
  /// One of these vehicles, counted from the robot backwards.
  SegmentView segment(std::size_t robot, std::size_t index) const;
  /// The fields of the world, in its order. A view is valid until the next step or edit.
  std::size_t fields() const;
  FieldView field(std::size_t index) const;
  /// The present pose of an obstacle; none when it was collected.
  std::optional<Pose> obstacle(std::size_t index) const;

 private:
  friend class Run;
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::simulation
