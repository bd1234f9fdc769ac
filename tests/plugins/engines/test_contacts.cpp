// Bodies that meet.
#include <algorithm>

#include <catch2/catch.hpp>

#include "elsie/physics/failure.h"

#include "physics_context.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

TEST_CASE("A robot at 2 m/s does not go through a box of 5 cm, nor over it") {
  const double step = GENERATE(0.005, 0.02);
  const double height = GENERATE(0.05, 0.2);
  CAPTURE(step, height);
  PhysicsContext context(with_step(step));
  const std::size_t robot = context.robot(-2.0, 0);
  const std::size_t box = context.obstacle(ObstacleKind::fixed, 0.0, 0.0, {0.05, 0.05, height});
  context.drive(robot, {100, 100});
  bool touched = false;
  context.run(1.6, [&] {
    touched = touched || context.touching(robot_body(robot), box_body(box));
    CHECK(context.pose(robot).x < -0.06);
    CHECK(std::abs(context.engine->robot(robot).frame.origin.z) < 0.005);
  });
  CHECK(touched);
}

TEST_CASE("A wheel that grazes a wall touches it") {
  PhysicsContext context;
  const std::size_t robot = context.robot(0.0, 0.0);
  // The wheels' outer faces are at y = 0.05.
  const std::size_t box = context.obstacle(ObstacleKind::fixed, 0.0, 0.15, {1.0, 0.2, 0.2});
  context.run(0.1);
  CHECK(context.touching(robot_body(robot), box_body(box)));
}

TEST_CASE("A box that is taken away is gone") {
  PhysicsContext context;
  const std::size_t robot = context.robot(0.0, 0.0);
  const ObstacleKind kind =
      GENERATE(ObstacleKind::fixed, ObstacleKind::resource, ObstacleKind::dynamic);
  const std::size_t box = context.obstacle(kind, 0.5, 0.0, {0.2, 0.2, 0.2});
  const std::size_t other = context.obstacle(ObstacleKind::fixed, 0.5, 1.0, {0.2, 0.2, 0.2});
  CHECK(context.engine->has_obstacle(box));
  CHECK(context.engine->cast_ray({0, 0, 0.1}, {1, 0, 0}, 1, Engine::kNobody).has_value());
  context.engine->remove_obstacle(box);
  CHECK_FALSE(context.engine->has_obstacle(box));
  CHECK(context.engine->has_obstacle(other));
  context.engine->remove_obstacle(box);  // twice is once
  CHECK_FALSE(context.engine->cast_ray({0, 0, 0.1}, {1, 0, 0}, 1, robot).has_value());
  context.drive(robot, {25, 25});
  context.run(2.0);
  CHECK(context.pose(robot).x > 0.8);
  CHECK(context.obstacle(ObstacleKind::fixed, 2, 2, {0.1, 0.1, 0.1}) == 2);
}

TEST_CASE("A resource stands fast until it is taken") {
  PhysicsContext context;
  const std::size_t robot = context.robot(0.0, 0.0);
  const std::size_t box = context.obstacle(ObstacleKind::resource, 0.3, 0.0, {0.1, 0.1, 0.1});
  context.drive(robot, {25, 25});
  context.run(1.0);
  CHECK(context.touching(robot_body(robot), box_body(box)));
  CHECK(context.engine->obstacle(box).origin.x == Approx(0.3));
}

TEST_CASE("Boxes fall and stack, fixed ones float") {
  const double step = GENERATE(0.001, 0.01, 0.02);
  CAPTURE(step);
  PhysicsContext context(with_step(step));
  const std::size_t lower = context.obstacle(ObstacleKind::dynamic, 0, 0, {0.2, 0.2, 0.2}, 0, 0.05);
  const std::size_t upper =
      context.obstacle(ObstacleKind::dynamic, 0.02, 0, {0.2, 0.2, 0.1}, 10, 0.3);
  const std::size_t floating = context.obstacle(ObstacleKind::fixed, 2, 0, {0.2, 0.2, 0.1}, 0, 0.5);
  context.run(3.0);
  CHECK(context.engine->obstacle(lower).origin.z == Approx(0.0).margin(1e-3));
  CHECK(context.engine->obstacle(upper).origin.z == Approx(0.2).margin(2e-3));
  CHECK(context.engine->obstacle(floating).origin.z == 0.5);
}

TEST_CASE("A tall box that is hit high up falls over and stays above the floor") {
  PhysicsContext context;
  const std::size_t tall = context.obstacle(ObstacleKind::dynamic, 0.0, 0.0, {0.04, 0.2, 0.5});
  const std::size_t ram =
      context.obstacle(ObstacleKind::moving, -0.3, 0.0, {0.2, 0.2, 0.1}, 0, 0.35);
  context.drive(ram, {0.3, 0.0}, 2.0);
  context.run(2.0);
  const Frame lying = context.engine->obstacle(tall);
  CHECK(lying.up.z < 0.1);
  const Vector3 center = lying.point({0, 0, 0.25});
  CHECK(center.z == Approx(0.02).margin(2e-3));
}

TEST_CASE("A robot that is tipped over lies on the floor") {
  PhysicsContext context;
  const std::size_t robot = context.robot(0.0, 0.0, 90);
  const std::size_t ram =
      context.obstacle(ObstacleKind::moving, -0.25, 0.0, {0.2, 0.2, 0.1}, 0, 0.075);
  context.drive(ram, {1.5, 0.0}, 0.25);
  context.run(3.0, [&] {
    // No part of it sinks: the middle of the chassis is at least half an edge above the floor.
    const Frame frame = context.engine->robot(robot).frame;
    CHECK(frame.point({0, 0, 0.05}).z > 0.035);
  });
}

TEST_CASE("A robot that a moving box presses through a wall ends the run, and is named") {
  const double step = GENERATE(0.001, 0.01, 0.02);
  PhysicsContext context(with_step(step));
  const std::size_t robot = context.robot(4.8, 0.0, 0);
  const std::size_t bystander = context.robot(0.0, 0.0, 0);
  const std::size_t ram = context.obstacle(ObstacleKind::moving, 4.5, 0.0, {0.2, 0.2, 0.2});
  try {
    context.drive(ram, {0.2, 0.0}, 3.0);
    FAIL("nothing was said");
  } catch (const PhysicsFailure& failure) {
    CHECK(failure.failure.kind == physics::Failure::Kind::outside);
    CHECK(failure.failure.body == robot_body(robot));
    CHECK(failure.failure.time_s > 0.5);
    CHECK(failure.failure.time_s < 3.0);
    CHECK(failure.failure.place.x == Approx(5.0).margin(0.01));
  }
  CHECK(context.pose(bystander).x == Approx(0).margin(1e-4));
}

TEST_CASE("What bounces comes back") {
  world::Physics physics;
  physics.step = 0.001;
  physics.bounce = GENERATE(0.0, 0.7);
  PhysicsContext context(physics);
  const std::size_t box = context.obstacle(ObstacleKind::dynamic, 0, 0, {0.2, 0.2, 0.2}, 0, 0.5);
  double lowest = 1.0, highest_after = 0.0;
  context.run(1.0, [&] {
    const double z = context.engine->obstacle(box).origin.z;
    lowest = std::min(lowest, z);
    if (lowest < 0.01) highest_after = std::max(highest_after, z);
  });
  if (physics.bounce > 0.0) {
    CHECK(highest_after == Approx(0.5 * 0.49).epsilon(0.15));
  } else {
    CHECK(highest_after < 0.012);
  }
}
