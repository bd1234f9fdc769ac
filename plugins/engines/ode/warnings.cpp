// Warns of contacts that are rigid (cfm or wheel_slip of 0) or so soft that bodies sink under their
// own weight; an erp that overshoots; motors that overturn the robot; mass ratios beyond the
// solver's precision; speeds at which a body passes through another in one step; moving boxes that
// reach into walls; walls lower than wheels; robots that topple.
#include "elsie/world/warnings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/world/engine_facts.h"
#include "elsie/world/error.h"
#include "elsie/world/footprint.h"

#include "dangers.h"
#include "softness.h"

namespace elsie::world {

namespace {

constexpr double kSupports = 4.0;  // wheels and casters of a robot, corners of a box

constexpr double kLeastCfm = 1e-8;
constexpr double kLeastSlip = 1e-6;  // m/(s N)
constexpr double kLeastErp = 0.01;
constexpr double kGreatestErp = 0.8;
constexpr double kDeepestSinking = 0.1;  // of a wheel's radius, or of a box's height
constexpr double kStrongest = 10.0;      // times the torque that tips the robot over
constexpr double kSpinUp = 100.0;        // times the highest wheel rate, in a step
constexpr double kMassRatio = 1e4;

using base::number_text;

std::string about(double value) { return number_text(value, 3); }

/// The weight, base and motors of a robot without its segments.
struct Stance {
  double mass = 0.0;       // kg
  double half_base = 0.0;  // m, of its wheels and casters, ahead and behind
  int motors = 0;          // of wheels
};

Stance stance_of(const Robot& robot) {
  Stance stance;
  for (const auto& part : driven_plan(robot).parts) {
    stance.mass += part.mass;
    if (part.role != PartRole::chassis) {
      stance.half_base = std::max(stance.half_base, std::abs(part.frame.origin.x));
    }
    const auto* wheel = std::get_if<WheelJoint>(&part.joint);
    stance.motors += wheel && wheel->torque > 0.0 ? 1 : 0;
  }
  return stance;
}

/// The subject of a warning.
struct Subject {
  Warning::About about = Warning::About::physics;
  std::size_t index = 0;
  const Location& location;
  std::string name{};  // of a body
};

class Search {
 public:
  explicit Search(const World& world)
      : world_(world),
        softness_(physics::softness_of(world.physics)),
        gravity_(std::abs(world.physics.gravity)) {}

  std::vector<Warning> find() {
    for (const Robot& robot : world_.robots) {
      stances_.push_back(stance_of(robot));
    }
    physics();
    for (std::size_t i = 0; i < world_.robots.size(); ++i) {
      const Robot& robot = world_.robots[i];
      this->robot(robot, stances_[i],
                  {Warning::About::robot, i, robot.location, "the robot '" + robot.id + "'"});
    }
    for (std::size_t i = 0; i < world_.obstacles.size(); ++i) {
      const Obstacle& box = world_.obstacles[i];
      this->box(box, {Warning::About::obstacle, i, box.location, box.in_words()});
    }
    return std::move(found_);
  }

 private:
  void add(const Subject& subject, std::string message) {
    found_.push_back({subject.about, subject.index, subject.location, std::move(message)});
  }

  void physics() {
    const Physics& p = world_.physics;
    const auto warn = [&](std::string message) {
      add({.location = p.location}, std::move(message));
    };
    if (softness_.cfm < kLeastCfm) {
      warn("cfm is " + number_text(softness_.cfm) +
           ": contacts are rigid, and the solver often finds no motion that satisfies all of them "
           "where bodies touch; expected at least 1e-08, and 1e-05 serves most worlds");
    }
    if (softness_.erp > kGreatestErp) {
      warn("erp is " + number_text(softness_.erp) +
           ": errors of joints and contacts are corrected all at once, which overshoots; expected "
           "0.1 to 0.8");
    }
    if (softness_.erp < kLeastErp) {
      warn("erp is " + about(softness_.erp) +
           ": errors of joints and contacts are hardly corrected, so that bodies sink into each "
           "other; expected 0.1 to 0.8");
    }
    const bool trains = std::any_of(world_.robots.begin(), world_.robots.end(),
                                    [](const Robot& robot) { return !robot.segments.empty(); });
    if (trains && p.wheel_slip < kLeastSlip) {
      warn("wheel_slip is " + number_text(p.wheel_slip) +
           ": the wheels of robots and of their segments hold against each other rigidly, and the "
           "solver often finds no motion that satisfies all of them; expected at least 1e-06, and "
           "0.001 serves most worlds");
    }
    const Arena& arena = world_.arena;
    double wheels = 0.0;
    for (const Robot& robot : world_.robots) {
      wheels = std::max(wheels, robot.body.wheel_radius);
    }
    if (arena.walls && arena.wall_height < wheels) {
      add({.location = arena.location},
          "the walls are " + number_text(arena.wall_height) +
              " m high, lower than the axles of wheels of " + number_text(wheels) +
              " m radius, which roll over them; expected more than " + number_text(wheels) + " m");
    }
  }

  /// The depth at which contacts hold a weight grows with their softness. They push at most at
  /// physics::kMaxCorrectingSpeed; a body that needs more sinks without end.
  void sinking(const Subject& body, double mass, double size) {
    const Physics& p = world_.physics;
    const double force = mass * gravity_ / kSupports;
    // An erp that is too small has a warning of its own.
    const double erp = std::max(softness_.erp, kLeastErp);
    const double depth = softness_.cfm * p.step / erp * force;
    const double deepest = kDeepestSinking * size;
    const double speed = softness_.cfm * force;
    if (depth <= deepest && speed < physics::kMaxCorrectingSpeed) {
      return;
    }
    const double most =
        std::min(deepest * erp / (p.step * force), 0.5 * physics::kMaxCorrectingSpeed / force);
    add(body, body.name + " weighs " + about(mass) + " kg, under which it sinks " +
                  (speed < physics::kMaxCorrectingSpeed ? about(depth) + " m into the floor"
                                                        : "through the floor") +
                  ": contacts are too soft, with a cfm of " + about(softness_.cfm) +
                  (softness_.from_spring ? " from kp and kd" : "") + "; expected at most " +
                  about(most));
  }

  void add(const Subject& subject, const std::optional<std::string>& message) {
    if (message) {
      add(subject, *message);
    }
  }

  void crossing(const Subject& body, double speed, double size) {
    add(body, physics::danger_of_speed(body.name, speed, size, world_.physics.step,
                                       ", and may pass into or through what stands in its way"));
  }

  void robot(const Robot& robot, const Stance& stance, const Subject& subject) {
    const std::string& whose = subject.name;
    const auto warn = [&](std::string message) { add(subject, std::move(message)); };
    const RobotBody& body = robot.body;
    const double mass = stance.mass;
    sinking(subject, mass, std::min(body.wheel_radius, body.clearance));
    crossing(subject, robot.max_speed, std::min(body.length, body.width));
    // The torque that each motor may have.
    const double holds = mass * gravity_ * stance.half_base / std::max(stance.motors, 1);
    if (body.wheel_torque > kStrongest * holds) {
      warn(whose + " has motors of " + number_text(body.wheel_torque) +
           " N m, and its weight holds only " + about(holds) +
           " N m of each before the chassis turns over instead of the wheels; expected at most " +
           about(kStrongest * holds) + " N m");
    }
    const double inertia = 0.5 * body.wheel_mass * body.wheel_radius * body.wheel_radius;
    const double gained = body.wheel_torque * world_.physics.step / inertia;
    const double top_rate = std::max(robot.max_speed, 0.1) / body.wheel_radius;
    if (gained > kSpinUp * top_rate) {
      warn(whose + " has motors of " + number_text(body.wheel_torque) +
           " N m, which bring a wheel of " + number_text(body.wheel_mass) + " kg to " +
           about(gained / top_rate) +
           " times its top speed in one step; expected a smaller wheel_torque, a larger "
           "wheel_mass or a step of at most " +
           about(world_.physics.step * kSpinUp * top_rate / gained) + " s");
    }
    ratio(subject, "the chassis of " + whose, body.mass, "each wheel", body.wheel_mass);
    for (const Segment& segment : robot.segments) {
      const Subject pulled{subject.about, subject.index, segment.location,
                           "the segment '" + segment.id + "' of " + whose};
      ratio(pulled, pulled.name, segment.mass, "the robot", mass);
      sinking(pulled, segment.mass, std::min(segment.wheel_radius, segment.clearance));
    }
    add(subject, physics::danger_of_height(whose, robot, ", and topples"));
  }

  void ratio(const Subject& body, const std::string& what, double mass, const std::string& other,
             double other_mass) {
    if (std::max(mass, other_mass) > kMassRatio * std::min(mass, other_mass)) {
      add(body, what + " weighs " + about(mass) + " kg and " + other + " " + about(other_mass) +
                    " kg: contacts of such different masses exceed the solver's precision; "
                    "expected a ratio of at most " +
                    number_text(kMassRatio));
    }
  }

  void box(const Obstacle& box, const Subject& subject) {
    if (box.is_dynamic()) {
      sinking(subject, box.mass, box.height);
      const auto least =
          std::max_element(stances_.begin(), stances_.end(), [&](const Stance& a, const Stance& b) {
            return unlike(box.mass, a.mass) < unlike(box.mass, b.mass);
          });
      if (least != stances_.end()) {
        const Robot& robot = world_.robots[static_cast<std::size_t>(least - stances_.begin())];
        ratio(subject, subject.name, box.mass, "the robot '" + robot.id + "'", least->mass);
      }
    }
    if (box.kind == ObstacleKind::moving && !box.waypoints.empty()) {
      const Vector3 size = fixture_of(box).shape.size;
      crossing(subject, box.speed, std::min(size.x, size.y));
      // Nothing stops a moving box.
      add(subject,
          physics::danger_of_path(world_, box, ", and presses bodies in between through it"));
    }
  }

  static double unlike(double mass, double other) { return std::abs(std::log(mass / other)); }

  const World& world_;
  physics::Softness softness_;
  double gravity_;
  std::vector<Stance> stances_;  // of the robots
  std::vector<Warning> found_;
};

}  // namespace

}  // namespace elsie::world

extern "C" __attribute__((visibility("default"))) void elsie_warn(
    const elsie::world::World& world, std::vector<elsie::world::Warning>& warnings) {
  elsie::physics::add_idle_parameters(world, warnings);
  for (elsie::world::Warning& each : elsie::world::Search(world).find()) {
    warnings.push_back(std::move(each));
  }
}
