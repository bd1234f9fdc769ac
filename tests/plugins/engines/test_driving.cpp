// The robot against the closed form of the differential drive:
// v = r (wl + wr) / 2, turn rate = r (wr - wl) / (2 R).
#include <algorithm>

#include <catch2/catch.hpp>

#include "physics_context.h"

using namespace elsie;
using namespace elsie::physics;

namespace {

struct Journey {
  double distance = 0.0;      // along the path
  double turned = 0.0;        // rad, full turns counted
  double lowest = 0.0;        // m, of the chassis, relative to its place
  double highest = 0.0;       // m
  double steepest_rad = 0.0;  // largest tilt
};

/// Drives from rest for a while, then brakes for a second; the heights are those of both.
Journey drive(PhysicsContext& context, std::size_t robot, const WheelRates& rates, double seconds) {
  Journey result;
  Pose last = context.pose(robot);
  const auto watch_height = [&] {
    const Frame frame = context.engine->robot(robot).frame;
    result.lowest = std::min(result.lowest, frame.origin.z);
    result.highest = std::max(result.highest, frame.origin.z);
    result.steepest_rad = std::max(result.steepest_rad, std::acos(std::min(1.0, frame.up.z)));
  };
  context.drive(robot, {rates.left, rates.right});
  context.run(seconds, [&] {
    const Pose now = context.pose(robot);
    result.distance += distance(last, now);
    result.turned += wrap_angle(now.heading_rad - last.heading_rad);
    last = now;
    watch_height();
  });
  context.drive(robot, {0, 0});
  context.run(1.0, watch_height);
  return result;
}

}  // namespace

TEST_CASE("Ten seconds from rest follow the kinematics of the differential drive") {
  const double step = GENERATE(0.001, 0.01, 0.02);
  const WheelRates rates = GENERATE(WheelRates{25, 25}, WheelRates{-25, -25}, WheelRates{10, -10},
                                    WheelRates{5, 25}, WheelRates{25, 20}, WheelRates{1, 2});
  CAPTURE(step, rates.left, rates.right);
  PhysicsContext context(with_step(step), open_field());
  const world::RobotBody body;
  const std::size_t robot = context.robot(0, 0);
  const Journey driven = drive(context, robot, rates, 10.0);

  const double speed = 0.5 * body.wheel_radius * (rates.left + rates.right);
  const double turn_rate = body.wheel_radius * (rates.right - rates.left) / (2 * body.half_axle());
  CHECK(driven.distance == Approx(10.0 * std::abs(speed)).epsilon(0.01).margin(1e-4));
  CHECK(driven.turned == Approx(10.0 * turn_rate).epsilon(0.02).margin(1e-4));
  CHECK(driven.lowest > -1e-4);
  CHECK(driven.highest < 1e-4);
  CHECK(driven.steepest_rad < 1e-3);
}

TEST_CASE("A robot of other dimensions follows its own kinematics") {
  world::RobotBody body;
  body.length = 0.3;
  body.width = 0.2;
  body.height = 0.1;
  body.clearance = 0.03;
  body.wheel_radius = 0.06;
  body.wheel_width = 0.02;
  body.mass = 2.0;
  body.wheel_mass = 0.3;
  body.wheel_torque = 0.4;
  PhysicsContext context({}, open_field());
  const std::size_t robot = context.robot(0, 0, 0, body);
  const Journey driven = drive(context, robot, {4, 8}, 10.0);
  CHECK(driven.distance == Approx(3.6).epsilon(0.01));
  CHECK(driven.turned == Approx(10.0 * 0.06 * 4 / 0.22).epsilon(0.02));
  CHECK(driven.lowest > -1e-4);
  CHECK(driven.highest < 1e-4);
}

TEST_CASE("Motors give no more than their torque") {
  world::RobotBody body;
  PhysicsContext context(with_step(0.001), open_field());
  const std::size_t robot = context.robot(0, 0, 0, body);
  context.drive(robot, {25, 25});
  // Both wheels push with torque / radius; mass and turning wheels (and casters) resist.
  const double force = 2.0 * body.wheel_torque / body.wheel_radius;
  const double inertia = body.mass + 2.0 * body.wheel_mass * 1.5;
  const double least_time = 0.5 * inertia / force;
  context.run(0.9 * least_time);
  CHECK(context.engine->robot(robot).speed < 0.91 * 0.5);
  CHECK(context.engine->robot(robot).speed > 0.7 * 0.5);
}

TEST_CASE("A robot stands where it was put") {
  PhysicsContext context;
  const std::size_t robot = context.robot(1.5, -2.5, -120, {}, 0.25);
  const RobotState state = context.engine->robot(robot);
  CHECK(state.pose.x == Approx(1.5));
  CHECK(state.pose.y == Approx(-2.5));
  CHECK(degrees(state.pose.heading_rad) == Approx(-120));
  CHECK(state.frame.origin.z == Approx(0.25));
}

TEST_CASE("A robot that is dropped lands on its wheels") {
  const double step = GENERATE(0.001, 0.01, 0.02);
  CAPTURE(step);
  PhysicsContext context(with_step(step));
  const std::size_t robot = context.robot(0, 0, 20, {}, 0.3);
  context.run(0.2);
  CHECK(context.engine->robot(robot).frame.origin.z ==
        Approx(0.3 - 0.5 * 9.81 * 0.04).margin(0.03));
  context.run(1.0);
  CHECK(std::abs(context.engine->robot(robot).frame.origin.z) < 1e-4);
  CHECK(context.engine->robot(robot).frame.up.z == Approx(1.0));
}

TEST_CASE("Gravity is a parameter") {
  world::Physics physics;
  physics.gravity = -1.62;
  PhysicsContext context(physics);
  const std::size_t robot = context.robot(0, 0, 0, {}, 0.5);
  context.run(0.5);
  CHECK(context.engine->robot(robot).frame.origin.z ==
        Approx(0.5 - 0.5 * 1.62 * 0.25).margin(0.01));
  physics.gravity = 0.0;
  PhysicsContext space(physics);
  const std::size_t floating = space.robot(0, 0, 0, {}, 0.5);
  space.run(1.0);
  CHECK(space.engine->robot(floating).frame.origin.z == 0.5);
}

TEST_CASE("A soft floor gives way by spring and damping constant") {
  world::Physics physics;
  physics.parameters["kp"] = 1000.0;  // N/m
  physics.parameters["kd"] = 20.0;    // N s/m
  PhysicsContext context(physics);
  const std::size_t heavy =
      context.obstacle(world::ObstacleKind::dynamic, 0, 0, {0.2, 0.2, 0.2}, 0, 0, 1.0);
  context.run(5.0);
  // Four corners carry it.
  CHECK(context.engine->obstacle(heavy).origin.z == Approx(-9.81 / (4 * 1000.0)).epsilon(0.02));
}
