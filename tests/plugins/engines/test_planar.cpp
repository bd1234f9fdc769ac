// What only the planar engine promises.
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "physics_context.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

world::Physics planar(double step = 0.01) {
  world::Physics physics = with_step(step);
  physics.engine = "planar";
  return physics;
}

}  // namespace

TEST_CASE("A circle is a circle, however long a step is") {
  const double step = GENERATE(0.001, 0.01, 0.02, 0.05);
  CAPTURE(step);
  PhysicsContext context(planar(step), open_field());
  const std::size_t robot = context.robot(0, 0);
  context.drive(robot, {10, 20});
  context.run(2.0);
  const RobotState from = context.engine->robot(robot);
  const double radius = from.speed / from.turn_rate;
  const Vector2 middle = point_of(from.pose, {-from.lateral / from.turn_rate, radius});
  const double away = std::hypot(from.pose.x - middle.x, from.pose.y - middle.y);
  context.run(10.0, [&] {
    const Pose pose = context.pose(robot);
    CHECK(std::hypot(pose.x - middle.x, pose.y - middle.y) == Approx(away).epsilon(1e-9));
  });
}

TEST_CASE("Robots side by side do not see who was added first") {
  const auto ends = [](bool turned_round) {
    PhysicsContext context(planar(), {.length = 1.0, .width = 1.0});
    std::vector<std::size_t> robots(12);
    for (std::size_t k = 0; k < robots.size(); ++k) {
      const std::size_t i = turned_round ? robots.size() - 1 - k : k;
      robots[i] =
          context.robot(0.2 * static_cast<double>(i % 4) - 0.3,
                        0.2 * static_cast<double>(i / 4) - 0.2, 47.0 * static_cast<double>(i));
      context.drive(robots[i], {25.0, 20.0 - static_cast<double>(i)});
    }
    context.run(10.0);
    std::vector<Pose> found;
    for (const std::size_t robot : robots) found.push_back(context.pose(robot));
    return found;
  };
  CHECK(ends(false) == ends(true));
}

TEST_CASE("What bounces comes back at its share of the speed") {
  world::Physics physics = planar(0.005);
  physics.friction = 0.0;
  physics.bounce = GENERATE(0.0, 0.5, 1.0);
  CAPTURE(physics.bounce);
  PhysicsContext context(physics, {.length = 4.0});
  const std::size_t box = context.obstacle(ObstacleKind::dynamic, 0.0, 0.0, {0.2, 0.2, 0.2});
  const std::size_t ram = context.obstacle(ObstacleKind::moving, -0.2, 0.0, {0.2, 0.2, 0.2});
  context.drive(ram, {0.5, 0.0}, 0.1);
  context.engine->remove_obstacle(ram);
  const auto speed = [&] {
    const double from = context.engine->obstacle(box).origin.x;
    context.run(physics.step);
    return (context.engine->obstacle(box).origin.x - from) / physics.step;
  };
  const double before = speed();
  REQUIRE(before > 0.4);
  context.run(1.9 / before + 0.5);
  CHECK(speed() == Approx(-physics.bounce * before).margin(1e-6));
}

TEST_CASE("Low boxes are in the way of wheels, and higher ones of the chassis") {
  PhysicsContext context(planar(), open_field());
  const std::size_t robot = context.robot(0.0, 0.0);
  // Below the chassis, which is 1 cm above the floor, between a wheel and the casters.
  context.obstacle(ObstacleKind::fixed, 0.3, 0.02, {0.05, 0.02, 0.008});
  // Above its top.
  context.obstacle(ObstacleKind::fixed, 0.6, 0.0, {0.05, 0.3, 0.1}, 0.0, 0.2);
  // In the way of the wheels.
  context.obstacle(ObstacleKind::fixed, 0.9, 0.045, {0.05, 0.01, 0.008});
  context.obstacle(ObstacleKind::fixed, 0.9, -0.045, {0.05, 0.01, 0.008});
  context.drive(robot, {20, 20});
  context.run(4.0);
  CHECK(context.pose(robot).x > 0.8);
  CHECK(context.pose(robot).x < 0.88);
}

// Wheels and casters carry a quarter of 1.96 N each, and the two tyres hold against 3 x 0.3 times
// their loads: 0.88 N.
TEST_CASE("Tyres give way sideways only beyond their grip") {
  const auto moved = [](double torque) {
    PhysicsContext context(planar(), open_field());
    world::RobotBody body;
    body.wheel_torque = torque;
    body.mass = 0.3;  // for more grip
    const std::size_t pushed = context.robot(0.2, 0.0, 90);
    const std::size_t pusher = context.robot(0.1099, 0.0, 0, body);
    context.drive(pusher, {10, 10});
    context.run(3.0);
    CHECK(context.touching(robot_body(pushed), robot_body(pusher)));
    return context.pose(pushed).x - 0.2;
  };
  CHECK(moved(0.008) < 0.01);  // 0.8 N
  CHECK(moved(0.01) > 0.1);    // 1 N
}

TEST_CASE("Pose and frame agree after a long run") {
  PhysicsContext context(planar(), open_field());
  const std::size_t robot = context.robot(0, 0, 10);
  context.drive(robot, {-24, 25});
  context.run(600.0);
  const RobotState state = context.engine->robot(robot);
  const double heading = std::atan2(state.frame.forward.y, state.frame.forward.x);
  CHECK(wrap_angle(heading - state.pose.heading_rad) == Approx(0.0).margin(1e-9));
  CHECK(std::abs(state.pose.heading_rad) <= std::numbers::pi);
}

TEST_CASE("Many rays at once find what single rays find") {
  PhysicsContext context(planar());
  for (int i = 0; i < 6; ++i) {
    context.robot(0.4 * std::cos(i), 0.4 * std::sin(i), 50.0 * i,
                  i % 2 == 0 ? world::RobotBody{} : round_body());
    context.obstacle(ObstacleKind::fixed, 1.1 * std::cos(i), 1.1 * std::sin(i), {0.2, 0.1, 0.3},
                     31.0 * i);
  }
  const double range = GENERATE(0.3, 1.0, 3.0, 100.0);
  const double pitch = GENERATE(0.0, -0.05, 0.1);
  const double height = GENERATE(0.01, 0.05, 0.105);
  CAPTURE(range, pitch, height);
  const Frame within = Frame::turned({0.1, -0.2, 0.0}, 0.3, 0.0);
  std::vector<Frame> from;
  std::vector<RayQuery> rays;
  for (int i = 0; i < 24; ++i) {
    from.push_back(Frame::turned({0.01 * i, 0.0, height}, radians(15.0 * i + 1.0), pitch));
  }
  for (const Frame& frame : from) rays.push_back({&frame, range});
  context.engine->cast_rays(within, rays, 2);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Frame frame = within.frame(from[i]);
    const auto hit = context.engine->cast_ray(frame.origin, frame.forward, range, 2);
    CAPTURE(i);
    CHECK((rays[i].distance_m != RayQuery::kNothing) == hit.has_value());
    if (hit) CHECK(rays[i].distance_m == Approx(hit->distance).epsilon(1e-12));
  }
}

TEST_CASE("A surface exactly at the range is met by many rays as by one") {
  PhysicsContext context(planar());
  context.robot(-3.0, 0.0);
  context.obstacle(ObstacleKind::fixed, 2.435, 0.0, {0.27, 0.2, 0.3});
  const Frame ahead{{0.0, 0.0, 0.1}}, aside = Frame::turned({0.0, 0.0, 0.1}, 1.57, 0.0);
  std::vector<RayQuery> rays{{&ahead, 2.3}, {&aside, 2.3}};
  context.engine->cast_rays({}, rays, 0);
  CHECK(context.engine->cast_ray(ahead.origin, ahead.forward, 2.3, 0)->distance ==
        rays[0].distance_m);
}

TEST_CASE("Many rays at once find what single rays find, wherever the bodies have gone") {
  PhysicsContext context(planar());
  for (int i = 0; i < 12; ++i) {
    const std::size_t robot = context.robot(0.5 * (i % 4) - 1.0, 0.5 * (i / 4) - 1.0, 77.0 * i);
    context.drive(robot, {10.0 + i, 14.0 - 0.5 * i});
  }
  context.obstacle(ObstacleKind::fixed, 0.5, 0.0, {0.2, 0.2, 0.3});  // its sides run along rays
  const std::size_t pushed = context.obstacle(ObstacleKind::dynamic, -0.3, 0.2, {0.1, 0.2, 0.3});
  for (int step = 0; step < 300; ++step) {
    context.engine->step();
    if (step == 150) context.engine->remove_obstacle(pushed);
    if (step == 200) context.engine->place_robot(5, {1.5, 1.5, 0.0});
    const std::size_t robot = static_cast<std::size_t>(step % 12);
    const Pose at = context.pose(robot);
    std::vector<Frame> from{{{0.4, 0.3, 0.1}, {0, -1, 0}, {}, {}},  // along a side of the box
                            {{0.4, -0.1, 0.1}, {1, 0, 0}, {}, {}},  // from its corner
                            {{0.5, 0.0, 0.1}, {1, 0, 0}, {}, {}}};  // from inside
    for (int i = 0; i < 20; ++i) {
      from.push_back(Frame::turned({at.x, at.y, 0.1}, at.heading_rad + 0.4 * i, 0.0));
    }
    std::vector<RayQuery> rays;
    for (const Frame& frame : from) rays.push_back({&frame, 1.0});
    context.engine->cast_rays({}, rays, robot);
    for (const RayQuery& ray : rays) {
      const auto hit = context.engine->cast_ray(ray.from->origin, ray.from->forward, 1.0, robot);
      CAPTURE(step, robot, ray.from->origin.x, ray.from->forward.x);
      REQUIRE(ray.distance_m == (hit ? hit->distance : RayQuery::kNothing));
    }
  }
}

TEST_CASE("What has no place in a plane is refused") {
  world::Physics lifted = planar();
  lifted.gravity = 1.0;
  CHECK_THROWS_AS(PhysicsContext(lifted), std::invalid_argument);
  PhysicsContext context(planar());
  CHECK_THROWS_AS(context.robot(0, 0, 0, {}, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(context.obstacle(ObstacleKind::dynamic, 1, 0, {0.1, 0.1, 0.1}, 0, 0.1),
                  std::invalid_argument);
  CHECK_NOTHROW(context.obstacle(ObstacleKind::fixed, 1, 0, {0.1, 0.1, 0.1}, 0, 0.1));
  const std::size_t robot = context.robot(0, 0);
  CHECK_THROWS_AS(context.engine->place_robot(robot, {}, 0.1), std::invalid_argument);
  CHECK(context.engine->fault_of_height(0.1).has_value());
  CHECK_FALSE(context.engine->fault_of_height(0.0).has_value());
}
