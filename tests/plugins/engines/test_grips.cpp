// Robots that hold boxes, in every engine: where the box is, what it weighs, and that nothing of it
// makes energy.
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "conformance.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

constexpr double kRadius = 0.02;  // m, of a wheel

world::Obstacle crate(double x, double y, double mass = 0.1, int hands = 1) {
  world::Obstacle box;
  box.kind = ObstacleKind::dynamic;
  box.x = x;
  box.y = y;
  box.length = box.width = box.height = 0.06;
  box.mass = mass;
  box.hands = hands;
  return box;
}

/// Where a box is in the frame of a robot.
Pose in_hand(const PhysicsContext& context, std::size_t robot, std::size_t box) {
  const Frame own = context.engine->robot(robot).frame, held = context.engine->obstacle(box);
  const Vector3 way = held.origin - own.origin;
  return {dot(way, own.forward), dot(way, own.left), std::asin(cross_z(own, held))};
}

double speed(const PhysicsContext& context, std::size_t robot) {
  return std::abs(context.engine->robot(robot).speed);
}

}  // namespace

TEST_CASE("A box that is held keeps its place in the frame of its robot") {
  PhysicsContext context(with(each_engine(), each_step()), open_field());
  const std::size_t robot = context.robot(0.0, 0.0, 30.0);
  const std::size_t box = context.engine->add_obstacle(crate(0.08, 0.06));
  context.run(0.1);
  context.engine->hold(robot, box, {});
  const Pose taken = in_hand(context, robot, box);
  const std::vector<double> rates = GENERATE(std::vector{10.0, 10.0}, std::vector{-5.0, 8.0});
  context.drive(robot, rates);
  context.run(2.0, [&] {
    const Pose now = in_hand(context, robot, box);
    CHECK(std::hypot(now.x - taken.x, now.y - taken.y) < 1e-3);
    CHECK(std::abs(now.heading_rad - taken.heading_rad) < 0.01);
    CHECK_FALSE(context.touching(robot_body(robot), box_body(box)));
  });
  const Pose end = context.pose(robot);
  CHECK(std::hypot(end.x, end.y) + std::abs(end.heading_rad - radians(30.0)) > 0.1);
  SECTION("and stays where it is put down") {
    context.drive(robot, {0.0, 0.0});
    context.run(0.5);
    context.engine->let_go(robot, box);
    const Frame there = context.engine->obstacle(box);
    context.drive(robot, {-10.0, -10.0});
    context.run(1.0);
    CHECK(across(context.engine->obstacle(box).origin, there.origin) < 2e-3);
    CHECK(across(context.engine->robot(robot).frame.origin, there.origin) > 0.15);
  }
}

TEST_CASE("A motor that moves a heavy box along takes longer to get going") {
  const std::string engine = each_engine();
  const auto way = [&](double mass) {
    PhysicsContext context(with(engine), open_field());
    world::RobotBody body;
    body.wheel_torque = 0.002;
    const std::size_t robot = context.robot(0.0, 0.0, 0.0, body);
    const std::size_t box = context.engine->add_obstacle(crate(0.08, 0.0, mass));
    context.engine->hold(robot, box, {});
    context.drive(robot, {25.0, 25.0});
    context.run(0.2);
    return context.pose(robot).x;
  };
  // Without slip, x = F t^2 / 2 m; the robot weighs 0.2 kg, and spinning up its wheels a little.
  CHECK(way(1.0) / way(0.2) == Approx((0.2 + 0.2) / (0.2 + 1.0)).epsilon(0.15));
}

TEST_CASE("Taking, carrying and putting down make no energy, at any step") {
  const std::string engine = each_engine();
  const double step = GENERATE(0.0005, 0.01, 0.1);
  PhysicsContext context(with(engine, step), open_field());
  const std::size_t robot = context.robot(-1.0, 0.0);
  const std::size_t box = context.engine->add_obstacle(crate(-0.5, 0.08, 0.5));
  const double rate = 15.0, most = 1.02 * rate * kRadius;
  context.drive(robot, {rate, rate});
  while (context.pose(robot).x < -0.53) context.run(step);
  const double before = speed(context, robot);
  context.engine->hold(robot, box, {});
  context.run(step);
  // Its half of a kilogram was at rest; the motors give no more than their torque.
  const double pushed = 2.0 * world::RobotBody{}.wheel_torque / kRadius * step / 0.2;
  CHECK(speed(context, robot) <= before + pushed);
  context.run(1.0, [&] { CHECK(speed(context, robot) < most); });
  const Vector3 at = context.engine->obstacle(box).origin;
  context.run(step);
  const double carried = across(context.engine->obstacle(box).origin, at) / step;
  context.engine->let_go(robot, box);
  double last = 1.05 * carried;
  context.drive(robot, {0.0, 0.0});
  for (int i = 0; i < 20; ++i) {
    const Vector3 from = context.engine->obstacle(box).origin;
    context.run(step);
    const double now = across(context.engine->obstacle(box).origin, from) / step;
    CHECK(now <= last + 1e-3);  // the floor brakes it
    last = std::max(now, 1e-3);
  }
}

TEST_CASE("What needs two hands stays where it is until two robots hold it") {
  PhysicsContext context(with(each_engine()), open_field());
  const std::size_t box = context.engine->add_obstacle(crate(0.0, 0.0, 0.1, 2));
  const std::size_t left = context.robot(0.0, 0.1, 90.0), right = context.robot(0.0, -0.1, 90.0);
  const std::size_t pusher = context.robot(-0.3, 0.0);
  const auto moved = [&] { return across(context.engine->obstacle(box).origin, {}); };
  context.drive(pusher, {10.0, 10.0});
  context.run(2.0);
  CHECK(moved() < 1e-6);
  CHECK(context.pose(pusher).x == Approx(-0.07).margin(5e-3));  // it stands before the box
  context.drive(pusher, {-10.0, -10.0});
  context.engine->hold(left, box, {});
  context.drive(left, {10.0, 10.0});
  context.run(0.5);
  CHECK(moved() < 1e-6);
  CHECK(context.pose(left).y == Approx(0.1).margin(2e-3));
  context.engine->hold(right, box, {});
  CHECK_THROWS_AS(context.engine->hold(pusher, box, {}), std::invalid_argument);
  context.drive(right, {10.0, 10.0});
  context.run(1.0);
  CHECK(context.engine->obstacle(box).origin.y == Approx(0.2).epsilon(0.1));
  CHECK(context.pose(left).y - context.pose(right).y == Approx(0.2).margin(2e-3));
  context.engine->let_go(left, box);
  const Vector3 there = context.engine->obstacle(box).origin;
  context.run(0.5);
  CHECK(across(context.engine->obstacle(box).origin, there) < 1e-6);
}

TEST_CASE("A bar that two hold at its ends turns as they move") {
  PhysicsContext context(with(each_engine()), open_field());
  world::Obstacle bar = crate(0.0, 0.0, 0.1, 2);
  bar.length = 0.3;
  bar.width = 0.04;
  const std::size_t box = context.engine->add_obstacle(bar);
  const std::size_t left = context.robot(-0.2, 0.0, 90.0), right = context.robot(0.2, 0.0, 90.0);
  context.engine->hold(left, box, {-0.15, 0.0});
  context.engine->hold(right, box, {0.15, 0.0});
  context.drive(left, {5.0, 5.0});
  context.drive(right, {10.0, 10.0});
  const auto apart = [&](std::size_t robot, double side, double end) {
    return across(context.engine->robot(robot).frame.point({0.0, side, 0.0}),
                  context.engine->obstacle(box).point({end, 0.0, 0.0}));
  };
  context.run(1.0, [&] {
    CHECK(apart(left, -0.05, -0.15) < 5e-3);
    CHECK(apart(right, 0.05, 0.15) < 5e-3);
  });
  CHECK(context.engine->obstacle(box).forward.y == Approx(0.3).margin(0.1));
}

TEST_CASE("Others touch what a robot holds, and a box that is gone is held no more") {
  PhysicsContext context(with(each_engine()), open_field());
  const std::size_t robot = context.robot(0.0, 0.0);
  const std::size_t box = context.engine->add_obstacle(crate(0.08, 0.0));
  const std::size_t other = context.robot(0.5, 0.0, 180.0);
  context.engine->hold(robot, box, {});
  CHECK_THROWS_AS(context.engine->hold(other, box, {}), std::invalid_argument);
  context.drive(other, {5.0, 5.0});
  bool touched = false;
  context.run(4.0,
              [&] { touched = touched || context.touching(robot_body(other), box_body(box)); });
  CHECK(touched);
  CHECK(in_hand(context, robot, box).x == Approx(0.08).margin(1e-3));
  context.engine->remove_obstacle(box);
  context.drive(robot, {5.0, 5.0});
  context.drive(other, {-5.0, -5.0});
  const double from = context.pose(robot).x;
  context.run(1.0);
  CHECK(context.pose(robot).x - from == Approx(0.1).epsilon(0.1));
  CHECK_THROWS_AS(context.engine->hold(robot, box, {}), std::invalid_argument);
}

TEST_CASE("Walls and fixed boxes cannot be held") {
  PhysicsContext context(with(each_engine()));
  const std::size_t robot = context.robot(0.0, 0.0);
  const std::size_t box = context.obstacle(ObstacleKind::fixed, 0.2, 0.0, {0.1, 0.1, 0.1});
  CHECK_THROWS_AS(context.engine->hold(robot, box, {}), std::invalid_argument);
}

TEST_CASE("A heap of robots with something in their hands has the same bits on any threads") {
  const std::string engine = each_engine();
  const auto hashes = [&](std::size_t threads) {
    base::ThreadPool pool(threads);
    PhysicsContext context(with(engine), {.length = 4.0, .width = 4.0});
    context.engine->work_with(pool);
    Random random(1);
    std::vector<std::size_t> robots, boxes;
    for (int i = 0; i < 36; ++i) {
      const double x = -1.5 + 0.5 * (i % 6), y = -1.3 + 0.5 * (i / 6);
      robots.push_back(context.robot(x, y));
      boxes.push_back(context.engine->add_obstacle(crate(x + 0.08, y)));
    }
    std::vector<Pose> taken(robots.size());
    std::vector<std::uint64_t> all;
    for (int step = 0; step < 300; ++step) {
      for (std::size_t i = 0; i < robots.size(); ++i) {
        if (step == static_cast<int>(i)) {
          context.engine->hold(robots[i], boxes[i], {});
          taken[i] = in_hand(context, robots[i], boxes[i]);
        }
        if (step == 200 + static_cast<int>(i)) context.engine->let_go(robots[i], boxes[i]);
        const double to = bearing(context.pose(robots[i]), 0.0, 0.0);  // all drive to one place
        context.drive(robots[i], {15.0 - 5.0 * to, 15.0 + 5.0 * to});
      }
      context.engine->step();
      all.push_back(context.engine->hash_state());
      for (std::size_t i = 0; step > 40 && step < 200 && i < robots.size(); ++i) {
        const Pose held = in_hand(context, robots[i], boxes[i]);
        REQUIRE(std::hypot(held.x - taken[i].x, held.y - taken[i].y) < 5e-3);
      }
    }
    return all;
  };
  const auto alone = hashes(1);
  CHECK(hashes(2) == alone);
  CHECK(hashes(3) == alone);
  CHECK(hashes(8) == alone);
}
