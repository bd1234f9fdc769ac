// A world as plain data: the checked content of a world file, with all defaults and templates.
//
// Members with a unit in their names (heading_deg) have the unit of the file, all others SI units.
// Every default is defined here and nowhere else.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/api/declaration.h"
#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/base/list.h"
#include "elsie/base/problems.h"

namespace elsie {

enum class ObstacleShape : std::uint8_t;  // shapes/obstacle_shapes.h

}  // namespace elsie

namespace elsie::world {

using base::Location;

struct Arena {
  double length = 10.0;         // m, along x; the arena's middle is the origin
  double width = 10.0;          // m, along y
  double wall_height = 0.3;     // m
  double wall_thickness = 0.1;  // m, outside of the area
  bool walls = true;
  Location location{};
};

struct Physics {
  std::string engine = "ode";  // one of plugin::engine_names()
  double gravity = -9.81;      // m/s2
  double step = 0.01;          // s
  int control_steps = 1;       // steps in one control period
  double friction = 0.3;       // Coulomb coefficient of contacts between bodies and with the floor;
                               // that of tyres is three times as high
  double wheel_slip = 1e-3;    // force-dependent slip of a wheel on the floor, m/s per N
  double bounce = 0.0;         // restitution, in [0, 1]
  /// Those that engines declare, as far as the file sets them; see engine_facts.h.
  std::map<std::string, ParameterValue> parameters{};
  Location location{};
};

using elsie::Colour;

struct Team {
  std::string id;
  std::optional<Colour> colour;  // the reader sets it for every team; see colours.h
  Location location{};
};

enum class ObstacleKind { fixed, dynamic, moving, resource };  // `fixed` is "static" in the file
inline constexpr const char* kObstacleKinds[] = {"static", "dynamic", "moving", "resource"};

/// An upright solid that stands on the floor, or floats when z is positive; see fixture_of().
struct Obstacle {
  std::string id;
  ObstacleKind kind = ObstacleKind::fixed;
  ObstacleShape shape{};             // a box; other obstacles may have others
  double x = 0.0, y = 0.0, z = 0.0;  // m, the middle of its bottom: of a prism, the center of area
  double heading_deg = 0.0;
  // Those that its shape has:
  double length = 0.2;  // m, along its own x
  double width = 0.2;   // m
  double radius = 0.1;  // m
  std::vector<Vector2>
      points;           // m, around the outline of a prism, from any origin; see footprint.h
  double height = 0.2;  // m
  std::optional<Colour> colour;
  bool seen_by_range_sensors = true;
  // Of what can be pushed and held: dynamic boxes, and resources that are carried to a nest.
  double mass = 0.2;  // kg
  int hands = 1;      // robots that must hold it before it moves with them; above 1: nothing else
                      // moves it
  // Moving boxes: from the start through the waypoints, and directly back to the start in an
  // endless round; or back and forth along the same path.
  std::vector<Vector2> waypoints;
  double speed = 0.2;  // m/s
  bool round_trip = true;
  // Resources.
  std::string team;        // empty: any team may take it
  double energy = 1000.0;  // units
  bool to_nest = false;    // it is carried to a nest; else a robot collects it when it touches it
  Location location;

  /// Whether robots can push and hold it.
  bool is_dynamic() const {
    return kind == ObstacleKind::dynamic || (kind == ObstacleKind::resource && to_nest);
  }

  const char* shape_name() const;
  /// "the cylinder 'c1'"
  std::string in_words() const { return std::string("the ") + shape_name() + " '" + id + "'"; }
  /// The name of its element: "static_cylinder", "resource".
  std::string element() const {
    const std::string of_kind = kObstacleKinds[static_cast<int>(kind)];
    return kind == ObstacleKind::resource ? of_kind : of_kind + "_" + shape_name();
  }
};

/// A mark on the floor at which the robots of a team charge.
struct Charger {
  std::string id;
  std::string team;  // empty: any team
  double x = 0.0, y = 0.0;
  double radius = 0.15;                    // m: the largest distance of a charging robot
  double rate = 2500.0;                    // units per second: 25 in each control step of 0.01 s
  bool seen_by_range_sensors = false;      // true: it is a box with this edge length, not a mark
  static constexpr double kBoxEdge = 0.1;  // m
  Location location;
};

/// A disc on the floor to which robots carry resources: one that a robot releases there is
/// delivered. Ground sensors, cameras and pictures see its colour.
struct Nest {
  std::string id;
  std::string team;  // whose robots deliver there; empty: any
  double x = 0.0, y = 0.0;
  double radius = 0.5;  // m
  Colour colour{0xb0, 0xb0, 0xb0};
  Location location{};
};

/// A point light, which light sensors and cameras see. It has no body.
struct Lamp {
  std::string id;
  double x = 0.0, y = 0.0, z = 0.5;  // m; z is above 0
  double intensity = 1.0;            // above 0; 1 is the reference lamp of each sensor's law
  Colour colour{255, 255, 255};
  Location location{};
};

/// Numbers over the whole floor, which robots deposit and sense: pheromone, heat. See fields.h.
struct ScalarField {
  std::string id;
  double cell = 0.05;               // m, the largest edge of a cell
  std::optional<double> half_life;  // s, in which it evaporates to half; none: it stays
  double spread = 0.0;              // m2/s; the variance along an axis grows by twice that
  double start = 0.0;               // units/m2, everywhere when the field begins
  std::optional<double> full;       // units/m2, shown as solid; none: its largest value then
  Colour colour{124, 63, 160};
  Location location{};
};

/// The floor without its patches.
struct Floor {
  std::optional<Colour> colour;  // none: plain, which each view shows its own way; see floor.h
  std::string image;             // the name of its image's file in the world's file; empty: none
  std::string image_file{};      // its absolute path
  // The rectangle around the origin that the image covers, m; by default the arena.
  std::optional<double> image_length, image_width;
  std::shared_ptr<const Image> pixels{};  // red, green, blue; the image's; null: no image
  Location location{};
};

enum class PatchShape { rectangle, disc, polygon, line };
inline constexpr const char* kPatchShapes[] = {"rectangle", "disc", "polygon", "line"};

/// An area of the floor with a colour of its own. It lies over the image and earlier patches.
struct Patch {
  std::string id;
  PatchShape shape = PatchShape::rectangle;
  double x = 0.0, y = 0.0;  // m, its middle: of a polygon, the center of area; of a line, the
                            // origin of its points
  double heading_deg = 0.0;
  double length = 0.5;          // m, of a rectangle, along its own x
  double width = 0.5;           // m, of a rectangle
  double radius = 0.25;         // m, of a disc
  double line_width = 0.02;     // m, of a line
  std::vector<Vector2> points;  // m, around the outline of a polygon, or along a line
  Colour colour{0, 0, 0};
  Location location{};

  /// The name of its element: "disc_patch".
  std::string element() const {
    return std::string(kPatchShapes[static_cast<int>(shape)]) + "_patch";
  }
};

/// The name in a world file of a file whose absolute path a parameter holds.
struct FileName {
  std::string path;  // the parameter's value that `name` is for
  std::string name;  // relative to the world's folder or a data directory if possible; "": the file
                     // is the plugin's default, which a world need not name

  friend bool operator==(const FileName&, const FileName&) = default;
};

/// An element nested in a plugin's element.
struct ElementUse {
  std::string element;  // its name
  std::map<std::string, ParameterValue> parameters;
  std::map<std::string, FileName> file_names;  // of file parameters that are not empty
  std::vector<ElementUse> elements;            // inside it
  Location location;
};

/// What they give a plugin.
std::vector<ElementValue> values_of(const std::vector<ElementUse>& elements);

/// The use of a plugin, with the parameters that the file sets; the others keep their defaults.
struct PluginUse {
  std::string plugin;
  std::string id;  // unique within its list; by default the plugin's name
  std::map<std::string, ParameterValue> parameters;  // checked; paths of files are absolute
  std::map<std::string, FileName> file_names;        // of file parameters that are not empty
  std::vector<ElementUse> elements;                  // nested in the plugin's element; checked
  Location location;
};

/// A sensor or an actuator.
struct MountedUse : PluginUse {
  std::string segment;  // the id of the segment that it is on; "": on the robot
  // In the frame of what it is on; by default the front edge and the top of that.
  std::optional<double> x, y, z;
  double yaw_deg = 0.0;
  double pitch_deg = 0.0;
  double energy_cost = 1.0;  // units per second
};

struct Coordination;

struct BehaviorUse : PluginUse {
  double priority = 1.0;
  std::vector<Coordination> inside;  // one entry if the behaviour holds others, else empty
};

/// Behaviours and the coordinator that combines their responses into one command.
struct Coordination {
  std::vector<BehaviorUse> behaviors;
  std::optional<PluginUse> coordinator;
};

/// The chassis of a robot and its wheels. The drive places the wheels: by default two driven wheels
/// on one axle. The origin of the frame is on the floor below the middle of the chassis.
struct RobotBody {
  bool round = false;       // true: an upright cylinder with equal length and width; false: a box
  double length = 0.08;     // m, chassis along the heading
  double width = 0.08;      // m, chassis
  double height = 0.08;     // m, chassis
  double clearance = 0.01;  // m, from the floor to the chassis
  double wheel_radius = 0.02;  // m
  double wheel_width = 0.01;   // m
  std::optional<double> axle;  // m between the wheels' middles; default: just outside the chassis
  double mass = 0.1;           // kg, chassis
  double wheel_mass = 0.05;    // kg, each
  double wheel_torque = 0.01;  // N m, the maximum of each motor

  double half_axle() const { return 0.5 * axle.value_or(width + wheel_width); }
  double top() const { return clearance + height; }
};

/// A box on two passive wheels that a robot pulls. The axle is below the box's middle, and the
/// wheels are flush with its sides. A joint with two degrees of freedom, yaw and pitch, links it to
/// the body in front: the robot or another segment. parts.h says where the joint is.
struct Segment {
  std::string id;               // unique within the robot
  double length = 0.08;         // m, along its heading
  double width = 0.06;          // m
  double height = 0.08;         // m, of the box
  double clearance = 0.01;      // m, from the floor to the box
  double mass = 0.1;            // kg, of the whole segment
  double wheel_radius = 0.02;   // m
  double wheel_width = 0.01;    // m
  double gap = 0.04;            // m, between the body in front and this one when they stand in line
  std::optional<double> hitch;  // m, joint behind the middle of the body in front; default: mid-gap
  std::optional<double> hitch_height;  // m, of the joint above the floor; default: that of the axle
  std::optional<double> max_yaw_deg;   // default: where the two bodies would touch, at most 90
  double max_pitch_deg = 20.0;         // upwards and downwards
  Location location;

  double half_axle() const { return 0.5 * (width - wheel_width); }
  double top() const { return clearance + height; }
};

struct Robot : Coordination {
  std::string id;
  std::string team = "red";
  std::optional<Colour> colour;      // of its chassis; see robot_colour()
  double x = 0.0, y = 0.0, z = 0.0;  // m
  double heading_deg = 0.0;
  double max_speed = 0.5;  // m/s
  double coverage = 0.5;   // m, communication radius, within which its team perceives it
  bool leader = false;
  double battery = 5000.0;       // units when full
  std::optional<double> energy;  // units at the start; default: full
  RobotBody body;
  std::optional<PluginUse> drive;         // default: differential
  std::optional<PluginUse> localisation;  // default: exact
  BodyPlan driven;  // the chassis with the parts of its drive; empty: default drive; see parts.h
  std::vector<Segment> segments;  // from the robot backwards
  std::vector<MountedUse> sensors;
  std::vector<MountedUse> actuators;
  Location location;
};

// Goals. A run succeeds at the first instant at which all goals to reach are met, and fails at the
// first at which a goal to keep is broken. With goals to keep only, it succeeds at the time limit.
//
// A goal about robots names one in `robot` or means those of `team`, or all if both are empty: each
// of them or, with `any`, at least one.

/// To reach: all resources (of one team, or all) are collected.
struct CollectGoal {
  std::string team;  // empty: every resource
  Location location{};
};
/// To reach: robots are within `radius` of a place, in the arena or in another robot's frame.
struct ReachGoal {
  std::string robot;
  double x = 0.0, y = 0.0, radius = 0.2;
  std::string of;  // the robot in whose frame the place is: x ahead, y to the left; empty: none
  std::string team{};
  bool any = false;
  Location location{};
};
/// To reach: the middle of a box (usually a dynamic one) is within `radius` of a place.
struct PushGoal {
  std::string obstacle;
  double x = 0.0, y = 0.0, radius = 0.2;
  Location location{};
};
/// To reach: every robot of a team is within `distance` of another one or of its leader.
struct GatherGoal {
  std::string team;
  double distance = 0.5;
  Location location{};
};
/// To reach: robots have driven at least this far, m.
struct TravelGoal {
  std::string robot;
  double distance = 10.0;
  std::string team{};
  bool any = false;
  Location location{};
};
/// To reach: an event of a plugin, or one that the simulator lets robots perceive, has been raised
/// so many times by these robots together.
struct EventGoal {
  std::string name;
  int count = 1;
  std::string robot{};
  std::string team{};
  Location location{};
};
/// To reach: these robots together have delivered so many resources in nests.
struct DeliverGoal : EventGoal {
  DeliverGoal() { name = "delivered"; }
};
/// To reach: this much simulated time has passed, s.
struct EndureGoal {
  double time = 60.0;
  Location location{};
};
/// To keep: robots touch only the floor and their resources.
struct NoCollisionGoal {
  std::string robot;
  std::string team{};
  Location location{};
};
/// To keep: the batteries of robots are never empty.
struct BatteryGoal {
  std::string robot;
  std::string team{};
  Location location{};
};
struct Goal;
/// To reach: any of these goals is reached, or all of them.
struct GoalGroup {
  std::vector<Goal> goals;  // to reach
  Location location{};
};
struct AnyGoal : GoalGroup {};
struct AllGoal : GoalGroup {};

using AnyKindOfGoal =
    std::variant<CollectGoal, ReachGoal, PushGoal, GatherGoal, TravelGoal, EventGoal, DeliverGoal,
                 EndureGoal, NoCollisionGoal, BatteryGoal, AnyGoal, AllGoal>;
struct Goal : AnyKindOfGoal {
  using AnyKindOfGoal::variant;
};

/// Calls `visit` for each goal that is not a group, at any depth, in the order of the file.
template <class Visit>
void for_each_goal(const std::vector<Goal>& goals, const Visit& visit) {
  for (const Goal& goal : goals) {
    if (const auto* any = std::get_if<AnyGoal>(&goal)) {
      for_each_goal(any->goals, visit);
    } else if (const auto* all = std::get_if<AllGoal>(&goal)) {
      for_each_goal(all->goals, visit);
    } else {
      visit(goal);
    }
  }
}

struct Limits {
  double time = 60.0;               // s, simulated
  std::optional<double> wall_time;  // s on the clock
};

/// What a learning agent observes and sets, for environments in Python (docs/learning.md). A run is
/// the same with and without it. Names are separated by blanks; empty: the environment's own.
struct Learning {
  std::string robots;   // ids, or "all"
  std::string observe;  // "range.distance_m motion"
  std::string act;      // "motion", "priorities", ...
  int steps = 0;        // of the physics in each step of the environment; 0: a control period
  std::optional<double> duration;  // s, instead of the limit of time
};

/// An edit of the running world between two steps, as one of ReadOptions::edits.
struct TimedEdit {
  double time = 0.0;  // s; made before the first step that begins at this time or later
  std::string path;
  std::optional<std::string> value;    // of an attribute
  std::optional<std::string> element;  // markup; exactly one of the two is set
  Location location{};

  /// "robot[r1]/@max_speed=0.1"
  std::string text() const { return path + "=" + (element ? *element : value.value_or("")); }
};

/// What the layouts of a world were drawn from; see layouts.h.
struct Drawn {
  std::uint64_t seed = 0;
  bool by_run = false;  // it is the run's seed
};

/// A copy shares the robots and changes, until they are changed.
struct World {
  std::string name;
  std::string description;
  std::string file;                    // the file that it was read from
  std::vector<base::Problem> remarks;  // on edits without an effect; see warnings()
  Arena arena;
  Physics physics;
  std::vector<Team> teams;
  std::vector<Obstacle> obstacles;
  std::vector<Charger> chargers;
  std::vector<Nest> nests;
  std::vector<Lamp> lamps;
  Floor floor;
  std::vector<Patch> patches;
  std::vector<ScalarField> fields;
  base::List<Robot> robots;
  std::vector<Goal> goals;
  std::vector<PluginUse> measures;
  std::vector<PluginUse> rules;
  base::List<TimedEdit> edits;  // in file order
  Limits limits;
  Learning learning;
  std::optional<Drawn> drawn;  // none: its file has no layouts
};

}  // namespace elsie::world
