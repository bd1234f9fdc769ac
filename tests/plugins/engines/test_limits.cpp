// Extreme but legal worlds neither crash nor go wrong in silence; impossible ones are refused.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "physics_context.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

/// Runs a robot and a box into each other. True if all stays finite; an engine that cannot go on
/// must say so.
bool finite_or_reported(const world::Physics& physics, const world::RobotBody& body = {},
                        double box_mass = 0.2) {
  PhysicsContext context(physics);
  const double ahead = 0.5 * body.length + 0.15;
  const std::size_t robot = context.robot(0, 0, 0, body);
  const std::size_t pushed =
      context.obstacle(ObstacleKind::dynamic, ahead, 0, {0.2, 0.2, 0.2}, 0, 0, box_mass);
  context.drive(robot, {25, 25});
  try {
    context.run(200 * physics.step);
  } catch (const std::runtime_error& error) {
    const std::string sentence = error.what();
    CHECK(sentence.find("unstable") != std::string::npos);
    CHECK(sentence.find("step") != std::string::npos);
    return true;
  }
  const RobotState state = context.engine->robot(robot);
  const Vector3 at = context.engine->obstacle(pushed).origin;
  return std::isfinite(state.frame.origin.x + state.frame.origin.y + state.frame.origin.z +
                       state.speed + state.turn_rate +
                       context.engine->joints(robot)[0].rate_rad_s) &&
         std::isfinite(at.x + at.y + at.z);
}

}  // namespace

TEST_CASE("Extreme physics stays finite or is reported") {
  world::Physics physics;
  SECTION("tiny step") { physics.step = 1e-6; }
  SECTION("huge step") { physics.step = 1.0; }
  SECTION("no cfm") { physics.parameters["cfm"] = 0.0; }
  SECTION("tiny cfm") { physics.parameters["cfm"] = 1e-15; }
  SECTION("huge cfm") { physics.parameters["cfm"] = 10.0; }
  SECTION("tiny erp") { physics.parameters["erp"] = 1e-9; }
  SECTION("full erp") { physics.parameters["erp"] = 1.0; }
  SECTION("no friction") { physics.friction = 0.0; }
  SECTION("huge friction") { physics.friction = 1e6; }
  SECTION("no slip") { physics.wheel_slip = 0.0; }
  SECTION("huge slip") { physics.wheel_slip = 1e6; }
  SECTION("full bounce") { physics.bounce = 1.0; }
  SECTION("heavy gravity") { physics.gravity = -1000.0; }
  SECTION("gravity upwards") { physics.gravity = 9.81; }
  SECTION("stiff spring") {
    physics.parameters["kp"] = 1e12;
    physics.parameters["kd"] = 1.0;
  }
  SECTION("no damping") {
    physics.parameters["kp"] = 1e3;
    physics.parameters["kd"] = 0.0;
  }
  CHECK(finite_or_reported(physics));
}

TEST_CASE("Extreme bodies stay finite or are reported") {
  world::RobotBody body;
  double box_mass = 0.2;
  SECTION("strong motors") { body.wheel_torque = 1e6; }
  SECTION("light chassis") { body.mass = 1e-9; }
  SECTION("heavy chassis") { body.mass = 1e9; }
  SECTION("heavy wheels") { body.wheel_mass = 1e6; }
  SECTION("a speck") {
    body.length = body.width = body.height = 1e-4;
    body.clearance = 1e-5;
    body.wheel_radius = 2e-5;
    body.wheel_width = 1e-5;
  }
  SECTION("a house") { body.length = body.width = body.height = 10.0; }
  SECTION("high legs") { body.clearance = 5.0; }
  SECTION("wide track") { body.axle = 10.0; }
  SECTION("heavy box") { box_mass = 1e9; }
  SECTION("light box") { box_mass = 1e-9; }
  CHECK(finite_or_reported({}, body, box_mass));
}

TEST_CASE("Bodies that were put into each other come apart without a bang") {
  const bool are_round = GENERATE(false, true);
  const world::RobotBody body = are_round ? round_body() : world::RobotBody{};
  PhysicsContext context;
  const std::size_t a = context.robot(0, 0, 0, body);
  const std::size_t b = context.robot(0.02, 0.01, 30, body);
  const std::size_t box =
      context.obstacle(ObstacleKind::dynamic, are_round ? 1.0 : 0.05, 0.0, {0.1, 0.1, 0.1});
  context.run(3.0);
  if (are_round) CHECK(distance(context.pose(a), context.pose(b)) > 0.12 - 1e-3);
  CHECK(std::hypot(context.pose(a).x, context.pose(a).y) < 1.5);
  CHECK(std::hypot(context.pose(b).x, context.pose(b).y) < 1.5);
  CHECK(std::abs(context.engine->obstacle(box).origin.x) < 1.5);
}

TEST_CASE("Without walls a robot may leave the area") {
  PhysicsContext context({}, open_field(2.0));
  const std::size_t robot = context.robot(0, 0);
  const std::size_t mate = context.robot(3.0, 0.0, 180);
  context.drive(robot, {25, 25});
  bool touched = false;
  context.run(10.0,
              [&] { touched = touched || context.touching(robot_body(robot), robot_body(mate)); });
  CHECK(touched);
  const auto hit = context.engine->cast_ray({-5, 0, 0.05}, {1, 0, 0}, 20, mate);
  REQUIRE(hit);
  CHECK(hit->body == robot_body(robot));
}

// A corner 0.3 m from the middle of an axle of 0.03 m moves at 20 times the speed of the rims.
TEST_CASE("A long robot that turns on the spot may kick a light box") {
  world::Physics physics = with_step(0.002);
  physics.friction = 1.0;
  PhysicsContext context(physics, open_field());
  world::RobotBody body;
  body.length = 0.6;
  body.height = 0.03;
  body.axle = 0.03;
  body.wheel_torque = 0.1;
  const std::size_t robot = context.robot(0, 0, 0, body);
  const double rim = 0.4;  // m/s
  context.drive(robot, {-rim / body.wheel_radius, rim / body.wheel_radius});
  context.run(4.0);
  const RobotState turning = context.engine->robot(robot);
  REQUIRE(turning.turn_rate > 20.0);

  // A quarter turn ahead of the front, with a side where the chassis' side will meet it.
  world::Obstacle box;
  box.kind = ObstacleKind::dynamic;
  box.length = box.width = box.height = 0.05;
  box.mass = 1e-3;
  const double away = 0.25, place = turning.pose.heading_rad + radians(90.0);
  box.x = turning.pose.x + away * std::cos(place);
  box.y = turning.pose.y + away * std::sin(place);
  box.heading_deg = degrees(place - std::asin((0.5 * body.width + 0.5 * box.width) / away));
  const std::size_t kicked = context.engine->add_obstacle(box);
  Vector3 before = context.engine->obstacle(kicked).origin;
  double fastest = 0.0;  // m/s
  context.run(0.4, [&] {
    const Vector3 now = context.engine->obstacle(kicked).origin;
    fastest = std::max(fastest, std::hypot(now.x - before.x, now.y - before.y) / physics.step);
    before = now;
  });
  const double without_lever = 2.0 * rim + std::sqrt(2.0 * 9.81 * box.height) + 2.0;
  CHECK(fastest > without_lever);
}

TEST_CASE("Impossible worlds are refused with a sentence") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  world::Physics physics;
  SECTION("step of zero") { physics.step = 0.0; }
  SECTION("negative step") { physics.step = -0.01; }
  SECTION("step that is no number") { physics.step = nan; }
  SECTION("erp of zero") { physics.parameters["erp"] = 0.0; }
  SECTION("negative cfm") { physics.parameters["cfm"] = -1.0; }
  SECTION("gravity that is no number") { physics.gravity = nan; }
  SECTION("negative friction") { physics.friction = -1.0; }
  SECTION("bounce above 1") { physics.bounce = 1.5; }
  CHECK_THROWS_AS(make_engine({}, physics), std::invalid_argument);
}

TEST_CASE("Impossible bodies are refused with a sentence") {
  PhysicsContext context;
  world::RobotBody body;
  body.wheel_radius = 0.0;
  CHECK_THROWS_AS(context.robot(0, 0, 0, body), std::invalid_argument);
  CHECK_THROWS_AS(context.robot(std::numeric_limits<double>::infinity(), 0), std::invalid_argument);
  CHECK_THROWS_AS(context.obstacle(ObstacleKind::fixed, 0, 0, {0.1, -0.1, 0.1}),
                  std::invalid_argument);
  const std::size_t fixed = context.obstacle(ObstacleKind::fixed, 0, 0, {0.1, 0.1, 0.1});
  CHECK_THROWS_AS(context.engine->drive_obstacle(fixed, {0, 0}, {0, 0}), std::invalid_argument);
  const std::size_t robot = context.robot(1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(context.drive(robot, {nan, 0}), std::invalid_argument);
  CHECK_THROWS_AS(context.engine->robot(7), std::out_of_range);
}
