// Bodies that are no boxes: cylinders, balls and capsules.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"

#include "composite.h"
#include "physics_context.h"
#include "prism_contact.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

constexpr double kPressed = 1e-3;  // m: how far bodies may be pressed into each other

/// The moments of inertia of a body that stands alone.
Vector3 moments(const Shape& shape, double mass) {
  const Composite composite = composite_of(alone(shape, mass).parts);
  CHECK(composite.mass == Approx(mass));
  CHECK(dot(composite.center, composite.center) == Approx(0.0).margin(1e-18));
  const auto& [x, y, z] = composite.inverse_inertia;
  for (const double off : {x.y, x.z, y.x, y.z, z.x, z.y}) CHECK(off == Approx(0.0).margin(1e-9));
  return {1.0 / x.x, 1.0 / y.y, 1.0 / z.z};
}

void check_moments(const Vector3& found, double x, double y, double z) {
  CHECK(found.x == Approx(x));
  CHECK(found.y == Approx(y));
  CHECK(found.z == Approx(z));
}

/// Along and across the axis of a solid of revolution, by adding up thin discs (Simpson's rule).
struct Revolved {
  double along, across;
};
Revolved revolved(double mass, double length, const std::function<double(double)>& radius) {
  constexpr int kDiscs = 20000;
  const double h = length / kDiscs;
  double volume = 0.0, along = 0.0, across = 0.0;
  for (int i = 0; i <= kDiscs; ++i) {
    const double weight = i == 0 || i == kDiscs ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    const double z = i * h - 0.5 * length, square = radius(z) * radius(z);
    volume += weight * square;
    along += weight * 0.5 * square * square;
    across += weight * square * (0.25 * square + z * z);
  }
  return {mass * along / volume, mass * across / volume};
}

/// The distance of a point from a body whose middle and axis are these; negative inside.
double away(const Shape& shape, const Vector3& middle, const Vector3& axis, const Vector3& point) {
  const Vector3 from = point - middle;
  const double along = std::abs(dot(from, axis));
  const double across = std::sqrt(std::max(0.0, dot(from, from) - along * along));
  const double r = shape.radius(), half = 0.5 * shape.length();
  if (shape.kind != Shape::Kind::cylinder) {
    return std::hypot(std::max(0.0, along - (half - r)), across) - r;
  }
  const double out = across - r, beyond = along - half;
  return std::min(0.0, std::max(out, beyond)) +
         std::hypot(std::max(0.0, out), std::max(0.0, beyond));
}

Vector3 direction_of(const Frame& frame, Shape::Axis axis) {
  return axis == Shape::Axis::forward ? frame.forward
         : axis == Shape::Axis::left  ? frame.left
                                      : frame.up;
}

Vector3 middle_of(const PhysicsContext& context, std::size_t robot, const Shape& shape) {
  return context.engine->robot(robot).frame.point({0.0, 0.0, 0.5 * shape.size.z + 1e-3});
}

double gap_between(const Pose& a, const Pose& b, double diameter) {
  return distance(a, b) - diameter;
}

}  // namespace

TEST_CASE("Moments of inertia are those of the textbook") {
  const double m = 0.7, r = 0.05, l = 0.3;
  check_moments(moments(Shape::box({0.1, 0.2, 0.3}), m), m * (0.04 + 0.09) / 12,
                m * (0.01 + 0.09) / 12, m * (0.01 + 0.04) / 12);
  const double ball = 0.4 * m * r * r;
  check_moments(moments(Shape::sphere(r), m), ball, ball, ball);
  const double along = 0.5 * m * r * r, across = m * (3 * r * r + l * l) / 12;
  check_moments(moments(Shape::pillar(r, l), m), across, across, along);
  check_moments(moments(Shape::wheel(r, l), m), across, along, across);
  check_moments(moments({Shape::Kind::cylinder, {l, 2 * r, 2 * r}, Shape::Axis::forward}, m), along,
                across, across);
}

TEST_CASE("A capsule's moments of inertia are those of the discs that it consists of") {
  const double m = 0.7, r = 0.05, l = GENERATE(0.1, 0.11, 0.3);
  const Revolved sum = revolved(m, l, [&](double z) {
    const double over = std::max(0.0, std::abs(z) - (0.5 * l - r));
    return std::sqrt(std::max(0.0, r * r - over * over));
  });
  check_moments(moments(Shape::capsule(r, l), m), sum.across, sum.across, sum.along);
  check_moments(moments(Shape::capsule(r, l, Shape::Axis::left), m), sum.across, sum.along,
                sum.across);
  check_moments(moments(Shape::capsule(r, l, Shape::Axis::forward), m), sum.along, sum.across,
                sum.across);
}

TEST_CASE("A disc touches a rectangle at the nearest point of its edge") {
  const Rectangle box{{1.0, 2.0}, {0.6, 0.8}, 0.3, 0.2};
  const auto place = [&](double along, double aside) {
    return Vector2{1.0 + 0.6 * along - 0.8 * aside, 2.0 + 0.8 * along + 0.6 * aside};
  };
  const auto check = [&](const Vector2& middle, double gap, const Vector2& normal,
                         const Vector2& point) {
    const PlanarManifold found = meet(Disc{middle, 0.1}, box, 1.0);
    REQUIRE(found.count == 1);
    CHECK(found.points[0].gap == Approx(gap).margin(1e-12));
    CHECK(found.normal.x == Approx(normal.x).margin(1e-12));
    CHECK(found.normal.y == Approx(normal.y).margin(1e-12));
    CHECK(found.points[0].point.x == Approx(point.x).margin(1e-12));
    CHECK(found.points[0].point.y == Approx(point.y).margin(1e-12));
    const PlanarManifold reverse = meet(box, Disc{middle, 0.1}, 1.0);
    CHECK(reverse.normal == Vector2{-found.normal.x, -found.normal.y});
    CHECK(reverse.points[0].point == found.points[0].point);
  };
  check(place(0.45, 0.1), 0.05, {0.6, 0.8}, place(0.325, 0.1));    // in front
  check(place(0.38, -0.1), -0.02, {0.6, 0.8}, place(0.29, -0.1));  // pressed into the front
  check(place(-0.1, -0.3), 0.0, {0.8, -0.6}, place(-0.1, -0.2));   // at the right flank
  // Off the corner, 0.05 m by the law of Pythagoras.
  check(place(0.3 + 0.09, 0.2 + 0.12), 0.05, {0.6 * 0.6 - 0.8 * 0.8, 0.8 * 0.6 + 0.6 * 0.8},
        place(0.3 + 0.6 * 0.025, 0.2 + 0.8 * 0.025));
  // With its middle inside it leaves by the nearest face.
  check(place(-0.25, 0.1), -0.15, {-0.6, -0.8}, place(-0.225, 0.1));
  check(place(0.1, 0.17), -0.13, {-0.8, 0.6}, place(0.1, 0.135));
  CHECK(meet(Disc{place(0.45, 0.1), 0.1}, box, 0.049).count == 0);
}

TEST_CASE("Discs touch on the line between their middles") {
  const Disc a{{0.3, 0.4}, 0.2}, b{{0.0, 0.0}, 0.25};
  const PlanarManifold found = meet(a, b, 0.06);
  REQUIRE(found.count == 1);
  CHECK(found.points[0].gap == Approx(0.05));
  CHECK(found.normal.x == Approx(0.6));
  CHECK(found.normal.y == Approx(0.8));
  CHECK(found.points[0].point.x == Approx(0.6 * 0.275));
  CHECK(found.points[0].point.y == Approx(0.8 * 0.275));
  CHECK(meet(a, b, 0.049).count == 0);
  CHECK(std::isfinite(meet(b, b, 0.0).normal.x));  // one in the other
}

TEST_CASE("A ray finds round bodies at their exact distance") {
  PhysicsContext context;
  const double height = 0.1, r = 0.05;
  SECTION("a pillar, and the sensor deck on it") {
    const BodyPlan plan = alone(Shape::pillar(r, height));
    context.engine->add_robot(plan, {1.0, 0.0, 0.3});
    for (const double off : {0.0, 0.02, -0.04, 0.0499}) {
      CHECK(cast(context, {0, off, 0.05}, {1, 0, 0}) ==
            Approx(1.0 - std::sqrt(r * r - off * off)).margin(1e-9));
    }
    CHECK(cast(context, {0, 0.0501, 0.05}, {1, 0, 0}, 2.0) == kNone);
    CHECK(cast(context, {0, 0, 0.12}, {1, 0, 0}, 2.0) == Approx(0.95).margin(1e-9));
    CHECK(cast(context, {0, 0, 0.1211}, {1, 0, 0}, 2.0) == kNone);
    CHECK(cast(context, {1.03, 0.03, 0.3}, {0, 0, -1}) == Approx(0.3 - 0.121).margin(1e-9));
    CHECK(cast(context, {1.04, 0.04, 0.3}, {0, 0, -1}) == Approx(0.3).margin(1e-9));
    CHECK(cast(context, {1.01, 0.01, 0.05}, {0, 1, 0}) == 0.0);
  }
  SECTION("a ball") {
    context.engine->add_robot(alone(Shape::sphere(r)), {1.0, 0.0, 0.0});
    const double middle = r + 1e-3;
    for (const double off : {0.0, 0.02, -0.04}) {
      const double expected = 1.0 - std::sqrt(r * r - off * off);
      CHECK(cast(context, {0, off, middle}, {1, 0, 0}) == Approx(expected).margin(1e-9));
      CHECK(cast(context, {0, 0, middle + off}, {1, 0, 0}) == Approx(expected).margin(1e-9));
    }
    CHECK(cast(context, {0.9, 0.1, middle}, {std::sqrt(0.5), -std::sqrt(0.5), 0}) ==
          Approx(0.1 * std::sqrt(2.0) - r).margin(1e-9));
    CHECK(cast(context, {1.02, 0.02, middle}, {0, 1, 0}) == 0.0);
    CHECK(cast(context, {2.0, 0.0, middle}, {1, 0, 0}, 1.0) == kNone);  // it is behind
  }
  SECTION("a capsule on its side") {
    context.engine->add_robot(alone(Shape::capsule(r, 0.3, Shape::Axis::left)), {1.0, 0.0, 0.0});
    const double middle = r + 1e-3;
    CHECK(cast(context, {0, 0.09, middle}, {1, 0, 0}) == Approx(0.95).margin(1e-9));
    CHECK(cast(context, {0, 0.13, middle}, {1, 0, 0}) == Approx(1.0 - 0.04).margin(1e-9));
    CHECK(cast(context, {1, 1, middle}, {0, -1, 0}) == Approx(1.0 - 0.15).margin(1e-9));
    CHECK(cast(context, {0, 0.151, middle}, {1, 0, 0}, 2.0) == kNone);
  }
}

TEST_CASE("Rays from anywhere agree with walking up to the surface") {
  Random random(11);
  const std::array shapes{Shape::pillar(0.2, 0.5),
                          Shape::wheel(0.2, 0.1),
                          Shape{Shape::Kind::cylinder, {0.6, 0.2, 0.2}, Shape::Axis::forward},
                          Shape::sphere(0.25),
                          Shape::capsule(0.1, 0.5),
                          Shape::capsule(0.1, 0.5, Shape::Axis::left),
                          Shape::capsule(0.1, 0.4, Shape::Axis::forward)};
  int hits = 0, misses = 0;
  for (const Shape& shape : shapes) {
    PhysicsContext context({}, open_field());
    const double heading = random.uniform(-3, 3);
    context.engine->add_robot(alone(shape), {0.3, -0.2, heading}, 0.5);
    const Frame frame = Frame::turned({0.3, -0.2, 0.5}, heading, 0.0);
    Vector3 middle = frame.point({0, 0, 0.5 * shape.size.z + 1e-3});
    Shape seen = shape;
    if (shape.is_round() && shape.kind == Shape::Kind::cylinder) {  // with its deck
      seen = Shape::pillar(shape.radius(), shape.length() + 0.02);
      middle.z += 0.01;
    }
    const Vector3 axis = direction_of(frame, shape.axis);
    for (int i = 0; i < 2000; ++i) {
      const Vector3 from{random.uniform(-1, 1.5), random.uniform(-1.5, 1),
                         random.uniform(0.1, 1.5)};
      const Vector3 to = middle + Vector3{random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4),
                                          random.uniform(-0.4, 0.4)};
      const double length = std::sqrt(dot(to - from, to - from));
      const Vector3 along = (1.0 / length) * (to - from);
      double walked = 0.0, left = away(seen, middle, axis, from), nearest = left;
      for (int k = 0; k < 10000 && left > 1e-11 && walked < 5.0; ++k) {
        walked += left;
        left = away(seen, middle, axis, from + walked * along);
        nearest = std::min(nearest, left);
      }
      const auto hit = context.engine->cast_ray(from, along, 5.0, kNobody);
      const bool found = hit && !hit->floor;
      CAPTURE(i, walked, nearest);
      if (nearest <= 1e-11) {
        CHECK(found);
        CHECK((found ? hit->distance : kNone) == Approx(walked).margin(1e-5));
        ++hits;
      } else if (nearest > 1e-6) {
        CHECK_FALSE(found);
        ++misses;
      }
    }
  }
  CHECK(hits > 1000);
  CHECK(misses > 1000);
}

TEST_CASE("A round robot that drives against a wall stops with its middle a radius away") {
  const double step = GENERATE(0.001, 0.01, 0.02);
  const double heading = GENERATE(0.0, 20.0, 50.0);
  CAPTURE(step, heading);
  PhysicsContext context(with_step(step));
  const std::size_t robot = context.robot(4.7, 0, heading, round_body());
  context.drive(robot, {10, 10});
  bool touched = false;
  double furthest = 0.0;
  context.run(4.0, [&] {
    touched = touched || context.touching(robot_body(robot), wall_body(0));
    furthest = std::max(furthest, context.pose(robot).x);
  });
  CHECK(touched);
  CHECK(furthest == Approx(5.0 - 0.06).margin(kPressed));
  CHECK(context.engine->robot(robot).frame.up.z > 0.999);
}

TEST_CASE("A round robot turns where the corners of a box would hit") {
  const bool round = GENERATE(true, false);
  PhysicsContext context;
  world::RobotBody body = round_body();
  body.round = round;
  const std::size_t robot = context.robot(5.0 - 0.062, 0, 0, body);
  context.drive(robot, {-5, 5});
  bool touched = false;
  context.run(3.0, [&] { touched = touched || !context.engine->touches().empty(); });
  CHECK(touched == !round);
}

TEST_CASE("Two round robots meet where their middles are a diameter apart") {
  const double step = GENERATE(0.001, 0.01, 0.02);
  const double off = GENERATE(0.0, 0.05);
  CAPTURE(step, off);
  PhysicsContext context(with_step(step));
  const std::size_t a = context.robot(-0.3, 0, 0, round_body());
  const std::size_t b = context.robot(0.3, off, 180, round_body());
  context.drive(a, {10, 10});
  context.drive(b, {10, 10});
  bool touched = false;
  double nearest = 1.0;
  context.run(2.0, [&] {
    touched = touched || context.touching(robot_body(a), robot_body(b));
    nearest = std::min(nearest, gap_between(context.pose(a), context.pose(b), 0.12));
  });
  CHECK(touched);
  CHECK(std::abs(nearest) < kPressed);
}

TEST_CASE("A round robot pushes a box with the front of its chassis") {
  PhysicsContext context;
  const std::size_t robot = context.robot(0, 0, 0, round_body());
  const std::size_t box = context.obstacle(ObstacleKind::dynamic, 0.3, 0.0, {0.2, 0.2, 0.2});
  context.drive(robot, {10, 10});
  context.run(3.0);
  CHECK(context.touching(robot_body(robot), box_body(box)));
  const Vector3 pushed = context.engine->obstacle(box).origin;
  CHECK(pushed.x > 0.5);
  CHECK(pushed.x - context.pose(robot).x == Approx(0.06 + 0.1).margin(2 * kPressed));
}

TEST_CASE("A round robot does not ride up a low box") {
  PhysicsContext context;
  const std::size_t robot = context.robot(0, 0, 0, round_body());
  const std::size_t box = context.obstacle(ObstacleKind::fixed, 0.3, 0.0, {0.1, 0.3, 0.03});
  context.drive(robot, {15, 15});
  context.run(3.0);
  CHECK(context.touching(robot_body(robot), box_body(box)));
  CHECK(context.pose(robot).x == Approx(0.25 - 0.06).margin(kPressed));
  CHECK(std::abs(context.engine->robot(robot).frame.origin.z) < 1e-3);
}

TEST_CASE("A crowd of round robots stays apart") {
  PhysicsContext context;
  constexpr int kRobots = 14;
  for (int i = 0; i < kRobots; ++i) {
    const double angle = 360.0 * i / kRobots;
    const std::size_t robot = context.robot(
        0.6 * std::cos(radians(angle)), 0.6 * std::sin(radians(angle)), angle + 180, round_body());
    context.drive(robot, {10, 10});
  }
  double nearest = 1.0;
  context.run(5.0, [&] {
    for (std::size_t i = 0; i < kRobots; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        nearest = std::min(nearest, gap_between(context.pose(i), context.pose(k), 0.12));
      }
    }
  });
  CHECK(nearest < 1e-3);  // they have met
  CHECK(nearest > -2e-3);
}

TEST_CASE("A ball rests on the floor") {
  PhysicsContext context;
  const Shape shape = Shape::sphere(0.05);
  const std::size_t ball = context.engine->add_robot(alone(shape), {0.5, 0.5, 0.3}, 0.05);
  context.run(3.0);
  const Vector3 middle = middle_of(context, ball, shape);
  CHECK(middle.x == Approx(0.5).margin(1e-6));
  CHECK(middle.y == Approx(0.5).margin(1e-6));
  CHECK(middle.z == Approx(0.05).margin(1e-4));
  CHECK(std::abs(context.engine->robot(ball).speed) < 1e-6);
}

TEST_CASE("A ball that is pushed rolls on") {
  PhysicsContext context;
  const Shape shape = Shape::sphere(0.05);
  const std::size_t ball = context.engine->add_robot(alone(shape), {0.2, 0.0, 0.0});
  const std::size_t box = context.obstacle(ObstacleKind::moving, 0.0, 0.0, {0.2, 0.4, 0.2});
  context.drive(box, {0.3, 0.0}, 1.0);
  context.run(0.5);
  const double before = middle_of(context, ball, shape).x;
  context.run(1.0);
  const Vector3 after = middle_of(context, ball, shape);
  CHECK(after.x > before + 0.1);  // the box has stopped
  CHECK(after.z == Approx(0.05).margin(1e-3));
}

TEST_CASE("A capsule, and a cylinder, rest on their sides") {
  const auto axis = GENERATE(Shape::Axis::forward, Shape::Axis::left);
  const bool is_capsule = GENERATE(true, false);
  Shape shape = Shape::capsule(0.03, 0.2, axis);
  if (!is_capsule) shape.kind = Shape::Kind::cylinder;
  PhysicsContext context;
  const std::size_t robot = context.engine->add_robot(alone(shape), {0.5, 0.5, 0.3}, 0.02);
  context.run(3.0);
  const Vector3 middle = middle_of(context, robot, shape);
  CHECK(middle.z == Approx(0.03).margin(1e-4));
  CHECK(std::hypot(middle.x - 0.5, middle.y - 0.5) < 1e-3);
  CHECK(std::abs(direction_of(context.engine->robot(robot).frame, axis).z) < 1e-3);
}

TEST_CASE("A cylinder stands on its end, and does not creep") {
  const double step = GENERATE(0.001, 0.01, 0.02);
  PhysicsContext context(with_step(step));
  const Shape shape = Shape::pillar(0.05, 0.15);
  const std::size_t robot = context.engine->add_robot(alone(shape), {0.5, 0.5, 0.3});
  context.run(30.0);
  const Frame frame = context.engine->robot(robot).frame;
  CHECK(frame.up.z > 0.99999);
  CHECK(middle_of(context, robot, shape).z == Approx(0.075).margin(1e-4));
  CHECK(std::hypot(frame.origin.x - 0.5, frame.origin.y - 0.5) < 1e-3);
}

TEST_CASE("A slender cylinder that is pushed at its top falls over, and lies on the floor") {
  PhysicsContext context;
  const Shape shape = Shape::pillar(0.03, 0.4);
  const std::size_t robot = context.engine->add_robot(alone(shape), {0.2, 0.0, 0.0});
  // Above its middle.
  const std::size_t box =
      context.obstacle(ObstacleKind::moving, 0.0, 0.0, {0.2, 0.4, 0.1}, 0.0, 0.3);
  context.drive(box, {0.3, 0.0}, 0.6);
  context.run(4.0);
  CHECK(std::abs(context.engine->robot(robot).frame.up.z) < 0.05);
  CHECK(middle_of(context, robot, shape).z == Approx(0.03).margin(2e-3));
}

TEST_CASE("Parts whose shapes make no sense are refused") {
  PhysicsContext context;
  const auto refuses = [&](const BodyPlan& plan) {
    CHECK_THROWS_AS(context.engine->add_robot(plan, {}), std::invalid_argument);
  };
  const BodyPlan sound = world::plan_of(round_body(), {});
  CHECK_NOTHROW(context.engine->add_robot(sound, {}));
  refuses(alone(Shape::capsule(0.05, 0.08)));                // no longer than wide
  refuses(alone({Shape::Kind::cylinder, {0.1, 0.2, 0.1}}));  // oval
  refuses(alone({Shape::Kind::sphere, {0.1, 0.1, 0.2}}));    // an egg
  refuses(alone({Shape::Kind::cylinder, {0.1, 0.1, -0.1}}));
  BodyPlan plan = sound;
  plan.parts[1].shape = Shape::box({0.04, 0.01, 0.04});  // a wheel
  refuses(plan);
  plan = sound;
  plan.parts[3].shape = Shape::pillar(0.005, 0.01);  // a caster
  refuses(plan);
  plan = sound;
  plan.parts[3].joint = FixedJoint{};
  refuses(plan);
}
