// What every engine must do: motion and contacts. Each case runs with each engine that is
// installed; test_conformance_state.cpp has the rest.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"

#include "conformance.h"
#include "trains.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

TEST_CASE("Straight on: the wheels' rate gives the speed") {
  const std::string engine = each_engine();
  const double step = GENERATE(0.001, 0.005, 0.01, 0.02);
  CAPTURE(engine, step);
  PhysicsContext context(with(engine, step), open_field());
  const std::size_t robot = context.robot(-3.0, 1.0, 30);
  context.drive(robot, {20, 20});
  context.run(1.0);
  const Pose from = context.pose(robot);
  context.run(5.0);
  const Pose to = context.pose(robot);
  CHECK(distance(from, to) == Approx(5.0 * 20 * 0.02).epsilon(1e-4));
  CHECK(to.heading_rad == Approx(radians(30)).margin(1e-4));
  CHECK(bearing(from, to.x, to.y) == Approx(0.0).margin(1e-4));
  const RobotState state = context.engine->robot(robot);
  CHECK(state.speed == Approx(0.4).epsilon(1e-4));
  CHECK(state.lateral == Approx(0.0).margin(1e-4));
  CHECK(context.engine->joints(robot)[0].rate_rad_s == Approx(20.0).epsilon(1e-3));
}

TEST_CASE("An arc: a circle closes where it began") {
  const std::string engine = each_engine();
  const double step = each_step();
  CAPTURE(engine, step);
  PhysicsContext context(with(engine, step), open_field());
  const world::RobotBody body;
  const std::size_t robot = context.robot(0, 0);
  context.drive(robot, {10, 20});
  context.run(1.0);
  const RobotState from = context.engine->robot(robot);
  const double rate = body.wheel_radius * 10 / (2 * body.half_axle());
  CHECK(from.turn_rate == Approx(rate).epsilon(2e-3));
  // The middle of the circle is to its left.
  const double radius = 0.5 * body.wheel_radius * 30 / rate;
  const Vector2 middle = point_of(from.pose, {0.0, radius});
  double farthest = 0.0;
  context.run(2.0 * std::numbers::pi / rate, [&] {
    const Pose pose = context.pose(robot);
    const double off = std::hypot(pose.x - middle.x, pose.y - middle.y) - radius;
    farthest = std::max(farthest, std::abs(off));
  });
  CHECK(farthest < 0.005);
  CHECK(distance(from.pose, context.pose(robot)) < 0.02);
}

TEST_CASE("A spin: the middle of the axle stays") {
  const std::string engine = each_engine();
  const double step = each_step();
  CAPTURE(engine, step);
  PhysicsContext context(with(engine, step), open_field());
  const world::RobotBody body;
  const std::size_t robot = context.robot(1.0, -1.0);
  context.drive(robot, {-20, 20});
  double turned = 0.0, last = 0.0;
  context.run(5.0, [&] {
    const double now = context.pose(robot).heading_rad;
    turned += wrap_angle(now - last);
    last = now;
  });
  const double rate = body.wheel_radius * 20 / body.half_axle();
  CHECK(turned == Approx(5.0 * rate).epsilon(0.02));
  CHECK(distance(context.pose(robot), {1.0, -1.0, 0.0}) < 2e-3);
}

TEST_CASE("A push: a box goes along, and friction stops it") {
  const std::string engine = each_engine();
  const double step = each_step();
  CAPTURE(engine, step);
  PhysicsContext context(with(engine, step), open_field());
  const std::size_t ram = context.obstacle(ObstacleKind::moving, -0.3, 0.0, {0.2, 0.2, 0.2});
  const std::size_t box = context.obstacle(ObstacleKind::dynamic, 0.0, 0.0, {0.2, 0.2, 0.2});
  context.drive(ram, {1.0, 0.0}, 0.5);
  const Vector3 let_go = context.engine->obstacle(box).origin;
  CHECK(let_go.x == Approx(0.4).margin(0.025));
  context.drive(ram, {-1.0, 0.0}, 0.01);
  context.run(2.0);
  const Vector3 end = context.engine->obstacle(box).origin;
  // v2 / (2 mu g)
  CHECK(end.x - let_go.x == Approx(1.0 / (2 * 0.3 * 9.81)).margin(0.025));
  CHECK(std::abs(end.y) < 2e-3);
  context.run(5.0);
  CHECK(across(context.engine->obstacle(box).origin, end) < 1e-4);
}

TEST_CASE("A push off the middle turns the box") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine), open_field());
  const std::size_t ram = context.obstacle(ObstacleKind::moving, -0.2, 0.08, {0.1, 0.02, 0.1});
  const std::size_t box = context.obstacle(ObstacleKind::dynamic, 0.0, 0.0, {0.2, 0.2, 0.2});
  context.drive(ram, {0.2, 0.0}, 1.0);
  const Frame frame = context.engine->obstacle(box);
  const double turned = std::atan2(frame.forward.y, frame.forward.x);
  CHECK(turned < -0.05);
  CHECK(turned > -1.5);
  CHECK(frame.origin.x > 0.05);
}

TEST_CASE("A wall: a robot stops at it, touches it, and presses") {
  const std::string engine = each_engine();
  const double step = each_step();
  CAPTURE(engine, step);
  world::Arena arena;
  arena.length = 2.0;
  PhysicsContext context(with(engine, step), arena);
  const std::size_t robot = context.robot(0.0, 0.0);
  context.drive(robot, {25, 25});
  double farthest = 0.0;
  context.run(1.0, [&] { CHECK(context.engine->touches().empty()); });
  context.run(3.0, [&] { farthest = std::max(farthest, context.pose(robot).x); });
  CHECK(farthest < 0.96 + 1e-3);
  CHECK(context.pose(robot).x == Approx(0.96).margin(1e-3));
  CHECK(context.engine->robot(robot).speed == Approx(0.0).margin(1e-3));
  CHECK(context.touching(robot_body(robot), wall_body(0)));
  context.drive(robot, {-10, -10});
  context.run(1.0);
  CHECK(context.pose(robot).x < 0.8);
  CHECK(context.engine->touches().empty());
}

// At some headings the motors and tyres come to their limits and leave them again within one step.
TEST_CASE("A wall: whatever the heading, a robot is not thrown off") {
  const std::string engine = each_engine();
  const double step = GENERATE(0.01, 0.02, 0.05, 0.1);
  const double heading =
      GENERATE(20.0, 45.0, 53.0, 53.5, 66.7, 66.9, 70.1, 70.2, 70.8, 72.6, 74.5, 85.0);
  CAPTURE(engine, step, heading);
  PhysicsContext context(with(engine, step), {.length = 8.0, .width = 400.0});
  const std::size_t robot = context.robot(3.7, 0.0, heading);
  context.drive(robot, {25, 25});
  double fastest = 0.0;
  context.run(6.0, [&] {
    const RobotState state = context.engine->robot(robot);
    fastest = std::max(fastest, std::hypot(state.speed, state.lateral));
  });
  CHECK(fastest < 1.3 * 0.5);
}

// The motors press with 1 N, and each box holds against it with 0.3 x 0.02 kg x 9.81 m/s2.
TEST_CASE("A stack of pushes: a row of boxes gives way if the motors are strong enough") {
  const std::string engine = each_engine();
  const int obstacles = GENERATE(1, 3, 10, 14, 20, 22);
  CAPTURE(engine, obstacles);
  PhysicsContext context(with(engine), open_field());
  const std::size_t robot = context.robot(0, 0);
  std::size_t last = 0;
  for (int i = 0; i < obstacles; ++i) {
    last =
        context.obstacle(ObstacleKind::dynamic, 0.1 + 0.081 * i, 0, {0.08, 0.08, 0.08}, 0, 0, 0.02);
  }
  const double from = context.engine->obstacle(last).origin.x;
  context.drive(robot, {10, 10});
  context.run(5.0);
  const double pushed = context.engine->obstacle(last).origin.x - from;
  if (obstacles < 17) {
    CHECK(pushed > 0.2);
  } else {
    CHECK(pushed < 0.03);
  }
}

TEST_CASE("No tunnelling: nothing goes through a thin wall at the greatest speed") {
  const std::string engine = each_engine();
  const double step = each_step();
  const double heading = GENERATE(0.0, 20.0, 45.0);
  const bool is_fast = GENERATE(false, true);  // 0.5 or 5 m/s
  CAPTURE(engine, step, heading, is_fast);
  PhysicsContext context(with(engine, step), open_field());
  world::RobotBody body;
  if (is_fast) body.wheel_torque = 0.05;
  const double from = is_fast ? -3.0 : -0.7, rate = is_fast ? 250 : 25;
  const std::size_t robot = context.robot(from, from * std::tan(radians(heading)), heading, body);
  const std::size_t wall = context.obstacle(ObstacleKind::fixed, 0.0, 0.0, {0.002, 6.0, 0.3});
  context.drive(robot, {rate, rate});
  double farthest = from;
  bool touched = false;
  context.run(is_fast ? 2.5 : 6.0, [&] {
    farthest = std::max(farthest, context.pose(robot).x);
    touched = touched || context.touching(robot_body(robot), box_body(wall));
  });
  // A fast corner may have bounced off within the step.
  CHECK((touched || (is_fast && heading > 0.0)));
  CHECK(farthest < -0.03);
  CHECK((is_fast || context.engine->robot(robot).frame.up.z > 0.99));
}

TEST_CASE("No tunnelling: a light box that is hit does not leave the arena") {
  const std::string engine = each_engine();
  const double step = GENERATE(0.001, 0.01, 0.02);
  CAPTURE(engine, step);
  world::Arena arena;
  arena.length = arena.width = 1.0;
  arena.wall_thickness = 0.005;
  PhysicsContext context(with(engine, step), arena);
  const std::size_t box =
      context.obstacle(ObstacleKind::dynamic, 0.2, 0, {0.05, 0.05, 0.05}, 0, 0, 0.005);
  const std::size_t ram = context.obstacle(ObstacleKind::moving, -0.2, 0.0, {0.2, 0.2, 0.2});
  context.drive(ram, {2.0, 0.0}, 0.2);
  context.run(1.0);
  CHECK(context.engine->obstacle(box).origin.x < 0.48);
  CHECK(context.engine->obstacle(box).origin.x > 0.2);
}

TEST_CASE("At rest, nothing creeps") {
  const std::string engine = each_engine();
  const double step = each_step();
  CAPTURE(engine, step);
  PhysicsContext context(with(engine, step));
  const std::size_t robot = context.robot(1.0, 1.0, 40);
  const std::size_t box = context.obstacle(ObstacleKind::dynamic, -1.0, 2.0, {0.1, 0.2, 0.3}, 25);
  const Frame turned = context.engine->obstacle(box);
  const std::size_t beside = context.obstacle(ObstacleKind::dynamic, -1.5, 0.0, {0.2, 0.2, 0.2});
  context.obstacle(ObstacleKind::dynamic, -1.3, 0.0, {0.2, 0.2, 0.2});
  context.run(60.0);
  CHECK(distance(context.pose(robot), {1.0, 1.0, 0.0}) < 1e-4);
  CHECK(context.pose(robot).heading_rad == Approx(radians(40)).margin(1e-4));
  CHECK(std::abs(context.engine->robot(robot).frame.origin.z) < 1e-4);
  CHECK(across(context.engine->obstacle(box).origin, {-1.0, 2.0, 0.0}) < 1e-4);
  CHECK(std::abs(context.engine->obstacle(box).origin.z) < 1e-4);
  CHECK(cross_z(context.engine->obstacle(box), turned) == Approx(0.0).margin(1e-4));
  CHECK(across(context.engine->obstacle(beside).origin, {-1.5, 0.0, 0.0}) < 1e-4);
  CHECK(context.engine->robot(robot).frame.up.z == Approx(1.0));
}

TEST_CASE("A long box that stands askew is in the way at each corner") {
  const std::string engine = each_engine();
  const double heading_deg = GENERATE(30.0, 75.0, 120.0);
  CAPTURE(engine, heading_deg);
  PhysicsContext context(with(engine), open_field());
  const double length = 6.0, width = 3.0;
  const std::size_t box =
      context.obstacle(ObstacleKind::fixed, 0.0, 0.0, {length, width, 0.3}, heading_deg);
  for (const double side : {-1.0, 1.0}) {
    for (const double end : {-1.0, 1.0}) {
      // Just inside of the corner, coming from outside along the long side.
      const Vector2 from = point_of({0.0, 0.0, radians(heading_deg)},
                                    {end * (0.5 * length + 0.4), side * (0.5 * width - 0.05)});
      const std::size_t robot =
          context.robot(from.x, from.y, heading_deg + (end > 0.0 ? 180.0 : 0.0));
      context.drive(robot, {10.0, 10.0});
    }
  }
  std::vector<bool> met(4, false);
  context.run(5.0, [&] {
    for (std::size_t i = 0; i < met.size(); ++i) {
      met[i] = met[i] || context.touching(robot_body(i), box_body(box));
    }
  });
  CHECK(met == std::vector<bool>(4, true));
}

// A body may stop at a surface and bounce in a later step, so that its energy is away for a while.
TEST_CASE("Energy never comes from bouncing in a pile") {
  const std::string engine = each_engine();
  world::Physics physics = with(engine, GENERATE(0.001, 0.005, 0.01));
  physics.friction = 0.0;
  physics.bounce = GENERATE(0.5, 0.8, 1.0);
  const std::uint64_t seed = GENERATE(1, 2);
  CAPTURE(engine, physics.step, physics.bounce, seed);
  PhysicsContext context(physics, {.length = 3.0, .width = 3.0});
  Random random(seed);
  struct Piece {
    std::size_t index;
    double mass, about_center;
  };
  std::vector<Piece> pile;
  for (int i = 0; i < 50; ++i) {
    const Vector3 size{random.uniform(0.06, 0.18), random.uniform(0.06, 0.18), 0.1};
    const double mass = random.uniform(0.05, 0.35);
    const Pose pose{0.25 * (i % 8) - 0.85, 0.25 * (i / 8) - 0.75, random.uniform(0.0, 6.0)};
    pile.push_back({context.engine->add_robot(alone(Shape{.size = size}, mass), pose), mass,
                    mass * (size.x * size.x + size.y * size.y) / 12.0});
  }
  for (const double from : {-1.0, 1.0}) {
    const std::size_t ram =
        context.obstacle(ObstacleKind::moving, 1.35 * from, 0.1 * from, {0.1, 0.1, 0.1});
    context.drive(ram, {-1.2 * from, 0.0}, 0.6);
    context.engine->remove_obstacle(ram);
  }
  std::vector<double> energies;
  double most_gain = 0.0;
  context.run(2.0, [&] {
    double now = 0.0;
    for (const Piece& piece : pile) {
      const RobotState state = context.engine->robot(piece.index);
      now += 0.5 * piece.mass * (state.speed * state.speed + state.lateral * state.lateral) +
             0.5 * piece.about_center * state.turn_rate * state.turn_rate;
    }
    if (energies.size() >= 10) {
      const double before = *std::max_element(energies.end() - 10, energies.end());
      most_gain = std::max(most_gain, now / before - 1.0);
    }
    energies.push_back(now);
  });
  CHECK(energies.front() > 0.1);
  CHECK(most_gain < 0.02);
}

TEST_CASE("The order of adding does not matter") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  const world::Arena arena{.length = 2.0, .width = 2.0};
  const std::vector<Pose> poses{{-0.5, 0.0, 0.1}, {0.5, 0.05, 3.0}, {0.0, -0.6, 1.5}};
  // The robots where they end, in the order of `poses`.
  const auto ends = [&](const std::vector<std::size_t>& order) {
    PhysicsContext context(with(engine), arena);
    std::vector<std::size_t> robots(order.size());
    for (const std::size_t i : order) {
      robots[i] = context.robot(poses[i].x, poses[i].y, degrees(poses[i].heading_rad));
      context.drive(robots[i], {12.0 + static_cast<double>(i), 12.0});
    }
    context.obstacle(ObstacleKind::dynamic, 0.0, 0.0, {0.1, 0.1, 0.1});
    context.run(1.5);
    std::vector<Pose> found;
    for (const std::size_t robot : robots) found.push_back(context.pose(robot));
    return found;
  };
  const std::vector<Pose> one = ends({0, 1, 2}), other = ends({2, 0, 1});
  for (std::size_t i = 0; i < poses.size(); ++i) {
    CAPTURE(i);
    CHECK(distance(one[i], other[i]) < 5e-3);
    CHECK(wrap_angle(one[i].heading_rad - other[i].heading_rad) == Approx(0.0).margin(0.05));
    if (engine == "planar") CHECK(one[i] == other[i]);  // to the bit
  }
}

TEST_CASE("A moving box arrives where it is driven, and takes along what stands in its way") {
  const std::string engine = each_engine();
  const double step = each_step();
  const double heading = GENERATE(0.0, 45.0, 90.0);
  CAPTURE(engine, step, heading);
  PhysicsContext context(with(engine, step));
  const std::size_t robot = context.robot(0.5, 0, heading);
  const std::size_t box = context.obstacle(ObstacleKind::moving, 0.0, 0.0, {0.2, 0.4, 0.2});
  bool touched = false;
  context.drive(box, {0.2, 0.0}, 5.0,
                [&] { touched = touched || context.touching(robot_body(robot), box_body(box)); });
  CHECK(touched);
  CHECK(context.engine->obstacle(box).origin.x == Approx(1.0));
  CHECK(context.engine->obstacle(box).origin.y == 0.0);
  // In front of the box; a robot that was hit askew may have slipped off its end.
  const RobotState pushed = context.engine->robot(robot);
  CHECK(pushed.pose.x > 1.0 + 0.1 + 0.03);
  CHECK(pushed.frame.up.z > 0.99);
  CHECK(std::abs(pushed.frame.origin.z) < 2e-3);
  const Frame there = context.engine->obstacle(box);
  context.run(1.0);
  CHECK(context.engine->obstacle(box).origin == there.origin);
  CHECK(cross_z(context.engine->obstacle(box), there) == 0.0);
}

TEST_CASE("Segments follow: on a circle each axle keeps its own radius") {
  const std::string engine = each_engine();
  const double step = each_step();
  CAPTURE(engine, step);
  PhysicsContext context(with(engine, step), open_field());
  Train pulled = train(context, {world::Segment{}, world::Segment{}});
  CHECK(context.engine->segments(pulled.robot) == 2);
  pulled.drive(14, 20);
  context.run(30.0);
  check_circle(pulled, {14, 20}, 2e-3);
  for (std::size_t i = 0; i < 2; ++i) CHECK(pulled.segment(i).yaw_rad < -0.2);
}

TEST_CASE("A robot that backs does not turn a segment past its limit") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine), open_field());
  world::Segment segment;
  segment.max_yaw_deg = 40.0;
  const std::size_t train = context.train(0, 0, 0, {segment});
  context.drive(train, {-10, -12});
  double most = 0.0;
  context.run(4.0,
              [&] { most = std::max(most, std::abs(context.engine->segment(train, 0).yaw_rad)); });
  CHECK(most > radians(35));
  CHECK(most <= radians(40) + 1e-9);
}
