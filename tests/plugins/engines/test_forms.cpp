// Obstacles that are cylinders and prisms, against closed forms.
#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/shapes/obstacle_shapes.h"
#include "elsie/shapes/outline.h"
#include "elsie/world/footprint.h"

#include "conformance.h"
#include "outlines.h"
#include "prism_contact.h"

using namespace elsie;
using namespace elsie::physics;
using elsie::ObstacleShape;
using world::ObstacleKind;

namespace {

constexpr double kFront = 0.04;  // m, of a robot of the default size

world::Obstacle cylinder(ObstacleKind kind, double x, double y, double radius,
                         double height = 0.2) {
  world::Obstacle made;
  made.kind = kind;
  made.shape = ObstacleShape::cylinder;
  made.x = x;
  made.y = y;
  made.radius = radius;
  made.height = height;
  return made;
}

world::Obstacle prism(ObstacleKind kind, double x, double y, const std::vector<Vector2>& points,
                      double heading_deg = 0.0) {
  world::Obstacle made;
  made.kind = kind;
  made.shape = ObstacleShape::prism;
  made.x = x;
  made.y = y;
  made.points = points;
  made.heading_deg = heading_deg;
  return made;
}

/// A polygon with a side that faces west.
std::vector<Vector2> regular(int corners, double radius) {
  std::vector<Vector2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = std::numbers::pi * (1.0 + (2.0 * i + 1.0) / corners);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

const std::vector<Vector2> kTriangle{{0.0, 0.0}, {0.6, 0.0}, {0.0, 0.3}};

std::optional<double> distance_to_box(const PhysicsContext& context, const Vector3& from,
                                      const Vector3& along) {
  const auto hit = context.engine->cast_ray(from, along, 20.0, Engine::kNobody);
  return hit && hit->body.kind == BodyKind::obstacle ? std::optional(hit->distance) : std::nullopt;
}

bool in_pyramid(const PhysicsContext& context, const Vector3& from, double range) {
  Pyramid pyramid;
  pyramid.frame.origin = from;
  pyramid.range_m = range;
  pyramid.horizontal_fov_rad = radians(2.0);
  pyramid.vertical_fov_rad = radians(2.0);
  return context.engine->anything_in(pyramid, Engine::kNobody);
}

/// How far a robot gets that drives from x = 0 towards an obstacle ahead.
double stopped_at(const std::string& engine, const world::Obstacle& obstacle) {
  PhysicsContext context(with(engine));
  const std::size_t robot = context.robot(0.0, 0.0);
  context.engine->add_obstacle(obstacle);
  context.drive(robot, {5.0, 5.0});
  context.run(12.0);
  return context.pose(robot).x;
}

}  // namespace

TEST_CASE("Second moments of outlines are those of the textbook") {
  const auto check = [](const std::vector<Vector2>& points, double xx, double yy, double xy) {
    const OutlineMoments found = moments_of(centered_outline(points));
    CHECK(found.xx == Approx(xx).margin(1e-12));
    CHECK(found.yy == Approx(yy).margin(1e-12));
    CHECK(found.xy == Approx(xy).margin(1e-12));
  };
  check({{1, 1}, {1, 3}, {4, 3}, {4, 1}}, 9.0 / 12.0, 4.0 / 12.0, 0.0);  // clockwise
  check(kTriangle, 0.36 / 18.0, 0.09 / 18.0, -0.18 / 36.0);
  check(regular(6, 0.2), 5.0 / 24.0 * 0.04, 5.0 / 24.0 * 0.04, 0.0);
}

TEST_CASE("The distance of a point from an outline is negative inside") {
  const std::vector<Vector2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  CHECK(distance_to(square, {0.2, 0.5}) == Approx(-0.5));
  CHECK(distance_to(square, {3.0, 0.5}) == Approx(2.0));
  CHECK(distance_to(square, {4.0, 5.0}) == Approx(5.0));
}

TEST_CASE("A ray meets a cylinder and a prism at their exact distance") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  context.engine->add_obstacle(cylinder(ObstacleKind::fixed, 1.0, 0.0, 0.3));
  // Turned by 90 degrees, its right angle is at (-2 + 0.1, 1 - 0.2).
  context.engine->add_obstacle(prism(ObstacleKind::fixed, -2.0, 1.0, kTriangle, 90.0));
  for (const double off : {0.0, 0.1, -0.25, 0.2999}) {
    CHECK(distance_to_box(context, {-0.5, off, 0.1}, {1.0, 0.0, 0.0}).value() ==
          Approx(1.5 - std::sqrt(0.09 - off * off)));
  }
  CHECK(!distance_to_box(context, {-0.5, 0.3001, 0.1}, {1.0, 0.0, 0.0}));
  CHECK(!distance_to_box(context, {-0.5, 0.0, 0.2001}, {1.0, 0.0, 0.0}));
  CHECK(distance_to_box(context, {1.1, 0.1, 1.0}, {0.0, 0.0, -1.0}).value() == Approx(0.8));
  CHECK(distance_to_box(context, {1.1, 0.1, 0.1}, {0.0, 0.0, -1.0}).value() == 0.0);  // inside

  // The side along y is at x = -1.9, that along x at y = 0.8; the slope joins their ends.
  CHECK(distance_to_box(context, {0.0, 1.0, 0.1}, {-1.0, 0.0, 0.0}).value() == Approx(1.9));
  CHECK(distance_to_box(context, {-2.0, 0.0, 0.1}, {0.0, 1.0, 0.0}).value() == Approx(0.8));
  CHECK(distance_to_box(context, {-2.0, 2.0, 0.1}, {0.0, -1.0, 0.0}).value() == Approx(2.0 - 1.2));
  CHECK(distance_to_box(context, {-3.0, 1.1, 0.1}, {1.0, 0.0, 0.0}).value() == Approx(1.1 - 0.15));
  CHECK(!distance_to_box(context, {-3.0, 0.799, 0.1}, {1.0, 0.0, 0.0}));
  CHECK(!distance_to_box(context, {-3.0, 1.401, 0.1}, {1.0, 0.0, 0.0}));
  CHECK(distance_to_box(context, {-1.95, 0.9, 0.7}, {0.0, 0.0, -1.0}).value() == Approx(0.5));
  // In the box around the prism, but beside it.
  CHECK(!distance_to_box(context, {-2.15, 1.3, 0.7}, {0.0, 0.0, -1.0}));
}

TEST_CASE("A pyramid holds a cylinder and a prism from their nearest point on") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  context.engine->add_obstacle(cylinder(ObstacleKind::fixed, 1.0, 0.0, 0.3));
  context.engine->add_obstacle(prism(ObstacleKind::fixed, 1.0, 2.0, regular(6, 0.2)));
  context.engine->add_obstacle(prism(ObstacleKind::fixed, 1.0, -2.0, regular(6, 0.2), 30.0));
  CHECK(in_pyramid(context, {0.0, 0.0, 0.1}, 0.701));
  CHECK(!in_pyramid(context, {0.0, 0.0, 0.1}, 0.699));
  CHECK(in_pyramid(context, {0.0, 2.0, 0.1}, 1.001 - 0.2 * std::cos(radians(30))));
  CHECK(!in_pyramid(context, {0.0, 2.0, 0.1}, 0.999 - 0.2 * std::cos(radians(30))));
  CHECK(in_pyramid(context, {0.0, -2.0, 0.1}, 0.801));
  CHECK(!in_pyramid(context, {0.0, -2.0, 0.1}, 0.799));
  // A corner of the box around it is there, but nothing of the prism.
  CHECK(!in_pyramid(context, {0.0, -2.0 + 0.16, 0.1}, 0.88));
  CHECK(in_pyramid(context, {0.9, 2.0, 0.1}, 0.01));  // it is all inside
}

TEST_CASE("A robot is stopped at the surface of a cylinder and of a prism") {
  constexpr double kSoft = 2e-4;  // m
  const std::string engine = each_engine();
  CAPTURE(engine);
  CHECK(stopped_at(engine, cylinder(ObstacleKind::fixed, 1.0, 0.0, 0.2)) ==
        Approx(1.0 - 0.2 - kFront).margin(kSoft));
  CHECK(stopped_at(engine, prism(ObstacleKind::fixed, 1.0, 0.0, regular(6, 0.2))) ==
        Approx(1.0 - 0.2 * std::cos(radians(30)) - kFront).margin(kSoft));
  CHECK(stopped_at(engine, prism(ObstacleKind::fixed, 1.0, 0.0, regular(3, 0.2))) ==
        Approx(1.0 - 0.1 - kFront).margin(kSoft));
  CHECK(stopped_at(engine, prism(ObstacleKind::moving, 1.0, 0.0, regular(16, 0.2))) ==
        Approx(1.0 - 0.2 * std::cos(radians(11.25)) - kFront).margin(kSoft));
  // Where no prism is, although the box around it would be.
  CHECK(stopped_at(engine, prism(ObstacleKind::fixed, 0.25, 0.37, {{0, 0}, {0.5, 0.4}, {0, 0.4}})) >
        0.8);
}

TEST_CASE("A round robot is stopped by a cylinder and by the corner of a prism") {
  constexpr double kRobot = 0.05;
  const bool is_cylinder = GENERATE(true, false);
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  world::RobotBody body;
  body.round = true;
  body.length = body.width = 2.0 * kRobot;
  body.axle = 0.08;
  const std::size_t robot = context.robot(0.0, 0.0, 0.0, body);
  context.engine->add_obstacle(is_cylinder
                                   ? cylinder(ObstacleKind::fixed, 0.5, 0.0, 0.2)
                                   : prism(ObstacleKind::fixed, 0.5, 0.0, regular(4, 0.2), 45.0));
  context.drive(robot, {5.0, 5.0});
  double most = 0.0;
  context.run(6.0, [&] { most = std::max(most, context.pose(robot).x); });
  CHECK(most == Approx(0.5 - 0.2 - kRobot).margin(2e-4));
}

TEST_CASE("A robot pushes a cylinder and a prism ahead of it") {
  const double reach = GENERATE(0.1, 0.1 * 0.5);  // of a cylinder, of a triangle
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  const std::size_t robot = context.robot(0.0, 0.0);
  const std::size_t pushed = context.engine->add_obstacle(
      reach == 0.1 ? cylinder(ObstacleKind::dynamic, 0.3, 0.0, 0.1)
                   : prism(ObstacleKind::dynamic, 0.3, 0.0, regular(3, 0.1)));
  context.drive(robot, {10, 10});
  context.run(3.0);
  const Vector3 there = context.engine->obstacle(pushed).origin;
  CHECK(there.x > 0.5);
  CHECK(std::abs(there.z) < 1e-3);
  CHECK(there.x - context.pose(robot).x == Approx(kFront + reach).margin(5e-4));
  CHECK(context.touching({BodyKind::robot, robot}, {BodyKind::obstacle, pushed}));
}

TEST_CASE("A cylinder and a prism that were set in motion slide until friction stops them") {
  constexpr double kSpeed = 1.0;
  const world::Obstacle form = GENERATE(cylinder(ObstacleKind::dynamic, 0.3, 0.0, 0.1, 0.05),
                                        prism(ObstacleKind::dynamic, 0.3, 0.0, regular(4, 0.1)),
                                        prism(ObstacleKind::dynamic, 0.3, 0.0, regular(6, 0.1)));
  world::Obstacle slider = form;
  slider.height = 0.05;
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  const std::size_t ram = context.obstacle(ObstacleKind::moving, 0.0, 0.0, {0.1, 0.4, 0.05});
  const std::size_t slid = context.engine->add_obstacle(slider);
  context.drive(ram, {kSpeed, 0.0}, 0.5);
  const double from = context.engine->obstacle(slid).origin.x;
  context.run(2.0);
  const Frame end = context.engine->obstacle(slid);
  // Half a step of motion is decided before and after.
  CHECK(end.origin.x - from ==
        Approx(0.5 * kSpeed * kSpeed / (0.3 * 9.81)).margin(0.6 * kSpeed * context.physics.step));
  CHECK(std::abs(end.origin.y) < 1e-3);
  CHECK(end.up.z > 0.9999);
}

TEST_CASE("Cylinders and prisms at rest do not creep, whatever their corners") {
  const int corners = GENERATE(0, 3, 5, 16);
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  const world::Obstacle form =
      corners == 0 ? cylinder(ObstacleKind::dynamic, 1.0, 2.0, 0.1)
                   : prism(ObstacleKind::dynamic, 1.0, 2.0, regular(corners, 0.1), 25.0);
  const std::size_t there = context.engine->add_obstacle(form);
  context.run(30.0);
  const Frame end = context.engine->obstacle(there);
  CHECK(std::hypot(end.origin.x - 1.0, end.origin.y - 2.0) < 1e-4);
  CHECK(std::abs(end.origin.z) < 1e-4);
  CHECK(context.engine->give_ups().steps == 0);
}

TEST_CASE("Cylinders and prisms stand on each other and on boxes") {
  const auto made = [](int form, double z) {
    world::Obstacle box = form == 0   ? cylinder(ObstacleKind::dynamic, 0.0, 0.0, 0.1, 0.1)
                          : form == 1 ? prism(ObstacleKind::dynamic, 0.0, 0.0, regular(5, 0.12))
                                      : world::Obstacle{};
    box.kind = ObstacleKind::dynamic;
    box.height = 0.1;
    box.z = z;
    return box;
  };
  const int below = GENERATE(0, 1, 2), above = GENERATE(0, 1, 2);
  CAPTURE(below, above);
  PhysicsContext context;
  context.engine->add_obstacle(made(below, 0.0));
  const std::size_t top = context.engine->add_obstacle(made(above, 0.15));
  context.run(3.0);
  const Frame end = context.engine->obstacle(top);
  CHECK(end.origin.z == Approx(0.1).margin(2e-3));
  CHECK(end.up.z > 0.999);
  CHECK(std::hypot(end.origin.x, end.origin.y) < 5e-3);
}

TEST_CASE("A tall prism that is hit high up falls over and lies on its side") {
  PhysicsContext context;
  world::Obstacle tall = prism(ObstacleKind::dynamic, 0.0, 0.0, regular(5, 0.05));
  tall.height = 0.6;
  const std::size_t falls = context.engine->add_obstacle(tall);
  const std::size_t ram =
      context.obstacle(ObstacleKind::moving, -0.3, 0.0, {0.1, 0.4, 0.1}, 0.0, 0.45);
  context.drive(ram, {0.5, 0.0}, 1.0);
  context.run(5.0);
  const Frame end = context.engine->obstacle(falls);
  CHECK(std::abs(end.up.z) < 0.05);
  const Vector3 middle = end.point({0.0, 0.0, 0.3});
  CHECK(middle.z == Approx(0.05 * std::cos(radians(36))).margin(5e-3));
}

TEST_CASE("A new engine goes on with cylinders and prisms to the bit") {
  PhysicsContext first;
  const std::size_t robot = first.robot(0.0, 0.0);
  const std::vector<world::Obstacle> obstacles{
      cylinder(ObstacleKind::dynamic, 0.2, 0.02, 0.1),
      prism(ObstacleKind::dynamic, 0.5, 0.0, kTriangle, 20.0),
      prism(ObstacleKind::moving, 2.0, 0.0, regular(5, 0.1))};
  for (const world::Obstacle& box : obstacles) first.engine->add_obstacle(box);
  first.drive(robot, {10, 9});
  first.run(1.5);
  const auto second = make_engine(first.arena, first.physics);
  second->add_robot_of(*first.engine, robot);
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    second->add_obstacle_of(*first.engine, i, obstacles[i]);
  second->go_on_from(*first.engine);
  for (int i = 0; i < 100; ++i) {
    first.engine->step();
    second->step();
  }
  CHECK(first.engine->hash_state() == second->hash_state());
}

TEST_CASE("Engines refuse outlines that are not convex") {
  PhysicsContext context;
  CHECK_THROWS_AS(context.engine->add_obstacle(prism(ObstacleKind::fixed, 0, 0, {{0, 0}, {1, 0}})),
                  std::invalid_argument);
  CHECK_THROWS_AS(context.engine->add_obstacle(cylinder(ObstacleKind::fixed, 0, 0, -0.1)),
                  std::invalid_argument);
}

TEST_CASE("Polygons meet along their facing sides") {
  Polygon square{{0.0, 0.0}, {}, 4};
  const std::vector<Vector2> corners = regular(4, std::sqrt(0.5));  // half a metre to each side
  std::copy(corners.begin(), corners.end(), square.corners.begin());
  Polygon other = square;
  other.center = {1.1, 0.25};
  const PlanarManifold found = meet(square, other, 0.2);
  REQUIRE(found.count == 2);
  CHECK(found.normal.x == Approx(-1.0));  // from the second into the first
  for (const PlanarContact& contact : found.points) {
    CHECK(contact.gap == Approx(0.1));
    CHECK(contact.point.x == Approx(0.55));
  }
  CHECK(std::min(found.points[0].point.y, found.points[1].point.y) == Approx(-0.25));
  CHECK(std::max(found.points[0].point.y, found.points[1].point.y) == Approx(0.5));
  CHECK(meet(square, other, 0.09).count == 0);
  const PlanarManifold same = meet(Rectangle{{0, 0}, {1, 0}, 0.5, 0.5}, other, 0.2);
  CHECK(same.points[0].gap == Approx(0.1));

  // A disc at the corner, 0.05 m away, and one whose middle is inside.
  const PlanarManifold corner = meet(Disc{{0.5 + 0.09, 0.5 + 0.12}, 0.1}, square, 0.1);
  CHECK(corner.points[0].gap == Approx(0.05));
  CHECK(corner.normal.x == Approx(0.6));
  const PlanarManifold inside = meet(Disc{{0.4, 0.1}, 0.1}, square, 0.1);
  CHECK(inside.points[0].gap == Approx(-0.2));
  CHECK(inside.normal.x == Approx(1.0));
}
