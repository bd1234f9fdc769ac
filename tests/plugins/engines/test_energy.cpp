// What every engine must keep at each step that a world may have: no energy from nothing, and
// nothing through anything. The last cases are what only the planar engine promises.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/physics/failure.h"

#include "conformance.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

constexpr double kDeepest = 0.003;  // m, that bodies may be in each other

/// Robots of one kind, and the most that their motors have given them.
class Throng {
 public:
  Throng(PhysicsContext& context, const world::RobotBody& body, double speed)
      : context_(context), body_(body), speed_(speed) {
    for (const Part& part : world::plan_of(body, {}).parts) {
      const Vector3 &at = part.frame.origin, &size = part.shape.size;
      mass_ += part.mass;
      about_middle_ +=
          part.mass * (at.x * at.x + at.y * at.y + (size.x * size.x + size.y * size.y) / 12.0);
    }
  }

  void add(double x, double y, double heading_deg) {
    robots_.push_back(context_.robot(x, y, heading_deg, body_));
  }

  /// Sets the motors so that all drive to a point, as fast as they turn.
  void drive_to(const Vector2& point) {
    const double top = speed_ / body_.wheel_radius;
    for (const std::size_t robot : robots_) {
      const double off = bearing(context_.pose(robot), point.x, point.y);
      const double ahead = top * std::max(0.0, std::cos(off)),
                   turn = top * std::clamp(off, -1.0, 1.0);
      context_.drive(robot,
                     {std::clamp(ahead - turn, -top, top), std::clamp(ahead + turn, -top, top)});
    }
  }

  /// The kinetic energy, J.
  double energy() const {
    double sum = 0.0;
    for (const std::size_t robot : robots_) {
      const RobotState state = context_.engine->robot(robot);
      sum += 0.5 * mass_ * (state.speed * state.speed + state.lateral * state.lateral) +
             0.5 * about_middle_ * state.turn_rate * state.turn_rate;
    }
    return sum;
  }
  /// That of all when they drive as fast as they can, J.
  double most_energy() const {
    return 0.5 * mass_ * speed_ * speed_ * static_cast<double>(robots_.size());
  }
  /// What all motors can give in a step, J: of each wheel the torque times the rate.
  double most_work() const {
    return 2.0 * body_.wheel_torque * speed_ / body_.wheel_radius * context_.physics.step *
           static_cast<double>(robots_.size());
  }

  /// The farthest middle of a robot, m along x or y.
  double farthest() const {
    double farthest = 0.0;
    for (const std::size_t robot : robots_) {
      const Pose at = context_.pose(robot);
      farthest = std::max({farthest, std::abs(at.x), std::abs(at.y)});
    }
    return farthest;
  }
  /// How deep two robots are in each other, at most, m: by the directions of their sides.
  double depth() const {
    double deepest = 0.0;
    for (const std::size_t a : robots_) {
      for (const std::size_t b : robots_) {
        if (a == b || distance(context_.pose(a), context_.pose(b)) > body_.length + body_.width) {
          continue;
        }
        deepest = std::max(deepest, -std::max(beyond(a, b), beyond(b, a)));
      }
    }
    return deepest;
  }

 private:
  /// How far `other` is away from the sides of a robot.
  double beyond(std::size_t robot, std::size_t other) const {
    const Pose at = context_.pose(robot), of_other = context_.pose(other);
    const Vector2 middle = seen_from(at, of_other);
    const double turned = of_other.heading_rad - at.heading_rad;
    const double c = std::abs(std::cos(turned)), s = std::abs(std::sin(turned));
    return std::max(std::abs(middle.x) - 0.5 * (body_.length + c * body_.length + s * body_.width),
                    std::abs(middle.y) - 0.5 * (body_.width + s * body_.length + c * body_.width));
  }
  static Vector2 seen_from(const Pose& at, const Pose& other) {
    const double dx = other.x - at.x, dy = other.y - at.y;
    const double c = std::cos(at.heading_rad), s = std::sin(at.heading_rad);
    return {c * dx + s * dy, c * dy - s * dx};
  }

  PhysicsContext& context_;
  world::RobotBody body_;
  double speed_;
  double mass_ = 0.0, about_middle_ = 0.0;
  std::vector<std::size_t> robots_;
};

/// The most of a run.
struct Reached {
  double energy = 0.0;        // as a part of that of robots which all drive as fast as they can
  double gain = 0.0;          // of energy in a step, beyond the motors' work; the same
  double depth = 0.0;         // m, of robots in each other
  double beyond_walls = 0.0;  // m, of a robot's middle
};

/// Robots that all drive to one point, from a square that the seed makes. Returns what they reach.
Reached crowd_of(std::size_t robots, const world::Physics& physics, double speed, double seconds,
                 std::uint64_t seed) {
  Random random(seed);
  const double apart = random.uniform(0.13, 0.3);
  const double side = std::ceil(std::sqrt(static_cast<double>(robots)));
  const double size = apart * (side + 1.0) + 0.2;
  PhysicsContext context(physics, {.length = size, .width = size});
  world::RobotBody body;
  body.wheel_torque = random.uniform(0.01, 0.05);
  Throng crowd(context, body, speed);
  for (std::size_t i = 0; i < robots; ++i) {
    const double column = std::fmod(static_cast<double>(i), side);
    const double row = std::floor(static_cast<double>(i) / side);
    crowd.add(apart * (column - 0.5 * (side - 1.0)), apart * (row - 0.5 * (side - 1.0)),
              random.uniform(-180.0, 180.0));
  }
  const Vector2 point{random.uniform(-0.3, 0.3) * size, random.uniform(-0.3, 0.3) * size};
  Reached reached;
  double before = 0.0;
  context.run(seconds, [&] {
    const double now = crowd.energy();
    reached.energy = std::max(reached.energy, now / crowd.most_energy());
    reached.gain = std::max(reached.gain, (now - before - crowd.most_work()) / crowd.most_energy());
    reached.depth = std::max(reached.depth, crowd.depth());
    reached.beyond_walls = std::max(reached.beyond_walls, crowd.farthest() - 0.5 * size);
    before = now;
    crowd.drive_to(point);
  });
  return reached;
}

/// What becomes of a robot between a box that moves to the right and a wall of a centimetre at 1 m.
struct Pressed {
  std::optional<physics::Failure> failure;
  double farthest = 0.0;  // m, of its middle to the right
  double fastest = 0.0;   // m/s
};

/// The box, 0.4 m long, stops `room` before the wall. The seed makes the place and heading.
Pressed press(const world::Physics& physics, double speed, double room, std::uint64_t seed) {
  Random random(seed);
  PhysicsContext context(physics, {.length = 8.0, .width = 8.0});
  const std::size_t robot = context.robot(0.5 + random.uniform(-0.1, 0.1),
                                          random.uniform(-0.1, 0.1), random.uniform(0, 360));
  context.obstacle(ObstacleKind::fixed, 1.005, 0.0, {0.01, 4.0, 0.5});
  const double from = -1.0;
  const std::size_t box = context.obstacle(ObstacleKind::moving, from, 0.0, {0.4, 0.4, 0.4});
  Pressed pressed;
  const auto look = [&] {
    const RobotState state = context.engine->robot(robot);
    pressed.farthest = std::max(pressed.farthest, state.pose.x);
    pressed.fastest = std::max(pressed.fastest, std::hypot(state.speed, state.lateral));
  };
  try {
    const double way = 0.8 - room - from;
    const double steps = std::ceil(way / speed / physics.step);  // whole steps, so a little slower
    context.drive(box, {way / (steps * physics.step), 0.0}, steps * physics.step, look);
    context.run(1.0, look);
  } catch (const PhysicsFailure& failed) {
    pressed.failure = failed.failure;
    look();
  }
  return pressed;
}

}  // namespace

TEST_CASE("A crowd has no more energy than its motors give, whatever the step and friction") {
  const std::string engine = each_engine();
  const double step = GENERATE(0.01, 0.02, 0.05, 0.1);
  // Bodies that ODE pushes apart, and robots that climb on others, have a little more.
  const double most = engine == "ode" ? 2.0 : 1.05;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    world::Physics physics = with(engine, step);
    physics.friction = std::vector{0.0, 0.3, 2.0, 10.0}[seed % 4];
    const double speed = std::vector{0.2, 0.4, 2.0}[seed % 3];
    const auto robots = static_cast<std::size_t>(random.uniform(5.0, 12.0));
    CAPTURE(engine, step, seed, physics.friction, speed, robots);
    const Reached reached = crowd_of(robots, physics, speed, 2.5, seed);
    CHECK(reached.energy < most);
    CHECK(reached.gain < 0.05 * most);
    if (engine == "planar") CHECK(reached.depth < kDeepest);
  }
}

TEST_CASE("Gaps of a millimetre: a robot that turns between walls gains nothing") {
  const std::string engine = each_engine();
  const double step = GENERATE(0.01, 0.02, 0.05, 0.1);
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    world::Physics physics = with(engine, step);
    physics.friction = std::vector{0.0, 0.3, 2.0, 10.0}[seed % 4];
    CAPTURE(engine, step, seed, physics.friction);
    PhysicsContext context(physics, {.length = 2.0, .width = 0.102});
    const double speed = random.uniform(0.1, 1.0);
    Throng crowd(context, {}, speed);
    crowd.add(-0.5, 0.0, 0.0);
    crowd.add(-0.2, 0.0, 180.0);
    double energy = 0.0;
    context.run(3.0, [&] {
      crowd.drive_to({random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
      energy = std::max(energy, crowd.energy() / crowd.most_energy());
    });
    CHECK(energy < 1.05);
    CHECK(crowd.farthest() < 0.96 + kDeepest);
  }
}

TEST_CASE("A moving box that leaves room takes a robot along, and no faster than itself") {
  const std::string engine = each_engine();
  const double step = GENERATE(0.01, 0.02, 0.05, 0.1);
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    world::Physics physics = with(engine, step);
    physics.friction = std::vector{0.0, 0.3}[seed % 2];
    const double speed = random.uniform(0.2, 1.0);
    CAPTURE(engine, step, seed, physics.friction, speed);
    const Pressed pressed = press(physics, speed, 0.2, seed);
    CHECK_FALSE(pressed.failure);
    CHECK(pressed.farthest < 0.96 + kDeepest);
    CHECK(pressed.fastest < 1.5 * speed);
  }
}

TEST_CASE("The planar engine: bodies stay apart at all speeds and frictions") {
  const double step = GENERATE(0.001, 0.01, 0.05, 0.1);
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    world::Physics physics = with("planar", step);
    physics.friction = std::vector{0.0, 0.3, 2.0, 10.0}[seed % 4];
    const double speed = std::vector{5.0, 20.0, 100.0}[seed % 3];
    CAPTURE(step, seed, physics.friction, speed);
    const Reached reached = crowd_of(6, physics, speed, 0.5, seed);
    CHECK(reached.energy < 1.05);
    CHECK(reached.depth < kDeepest);
    CHECK(reached.beyond_walls < kDeepest);
  }
}

// The wall is as thin as a centimetre, and the box would leave 5 mm between itself and the wall.
TEST_CASE(
    "The planar engine: where a moving box leaves no room, the run ends, and both are named") {
  const double step = GENERATE(0.001, 0.01, 0.05, 0.1);
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    world::Physics physics = with("planar", step);
    physics.friction = std::vector{0.0, 0.3, 2.0, 10.0}[seed % 4];
    const double speed = std::vector{0.2, 1.0, 20.0}[seed % 3];
    CAPTURE(step, seed, physics.friction, speed);
    const Pressed with_room = press(physics, speed, 0.2, seed);
    CHECK_FALSE(with_room.failure);
    CHECK(with_room.farthest < 0.96 + kDeepest);
    const Pressed without = press(physics, speed, 0.005, seed);
    REQUIRE(without.failure);
    CHECK(without.failure->kind == physics::Failure::Kind::pressed);
    CHECK(without.failure->body == robot_body(0));
    CHECK(without.failure->presser == box_body(1));
    CHECK(without.failure->time_s > 0.5 / speed);  // not before they meet
    CHECK(without.failure->place.x < 0.96 + kDeepest);
    CHECK(without.farthest < 0.96 + kDeepest);
  }
}
