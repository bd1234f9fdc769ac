// What reaches into the pyramid of a proximity sensor.
#include <array>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"

#include "conformance.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

constexpr double kNear = 1e-9;  // m

/// 90 degrees wide, about 53 high, 1 m long: at distance d it is 2 d wide and d high.
Pyramid wide(const Vector3& apex, double yaw_deg = 0.0) {
  return {Frame::turned(apex, radians(yaw_deg), 0.0), radians(90), 2.0 * std::atan(0.5), 1.0};
}

// The oracle: cuts the faces of the box down to what lies in the pyramid.

struct Plane {
  Vector3 normal;  // outward
  double distance;
};

std::vector<Vector3> cut(const std::vector<Vector3>& polygon, const Plane& plane) {
  std::vector<Vector3> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double out_a = dot(plane.normal, a) - plane.distance;
    const double out_b = dot(plane.normal, b) - plane.distance;
    if (out_a <= 0.0) left.push_back(a);
    if ((out_a < 0.0 && out_b > 0.0) || (out_a > 0.0 && out_b < 0.0)) {
      left.push_back(a + (out_a / (out_a - out_b)) * (b - a));
    }
  }
  return left;
}

bool overlap(const Pyramid& pyramid, const Frame& middle, const Vector3& half) {
  const Frame& f = pyramid.frame;
  const double h = 0.5 * pyramid.horizontal_fov_rad, v = 0.5 * pyramid.vertical_fov_rad;
  std::vector<Plane> planes{{f.forward, dot(f.forward, f.origin) + pyramid.range_m}};
  for (const double side : {-1.0, 1.0}) {
    const Vector3 beside = f.direction({-std::sin(h), side * std::cos(h), 0.0});
    const Vector3 above = f.direction({-std::sin(v), 0.0, side * std::cos(v)});
    planes.push_back({beside, dot(beside, f.origin)});
    planes.push_back({above, dot(above, f.origin)});
  }
  const Vector3 o = f.origin - middle.origin;
  if (std::abs(dot(o, middle.forward)) <= half.x && std::abs(dot(o, middle.left)) <= half.y &&
      std::abs(dot(o, middle.up)) <= half.z) {
    return true;
  }
  const std::array<std::array<double, 2>, 4> corners{{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}};
  for (const double side : {-1.0, 1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Vector3> face;
      for (const auto& [u, w] : corners) {
        const std::array<Vector3, 3> points{Vector3{side, u, w}, Vector3{u, side, w},
                                            Vector3{u, w, side}};
        const Vector3& p = points[static_cast<std::size_t>(axis)];
        face.push_back(middle.point({half.x * p.x, half.y * p.y, half.z * p.z}));
      }
      for (const Plane& plane : planes) face = cut(face, plane);
      if (!face.empty()) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("A box ahead is in the pyramid up to its far face") {
  PhysicsContext context(with(each_engine()));
  context.obstacle(ObstacleKind::fixed, 1.5, 0.0, {0.2, 0.2, 0.4});  // from x = 1.4
  CHECK(context.engine->anything_in(wide({0.4 + kNear, 0, 0.2}), kNobody));
  CHECK_FALSE(context.engine->anything_in(wide({0.4 - kNear, 0, 0.2}), kNobody));
  CHECK_FALSE(context.engine->anything_in(wide({0.4 + kNear, 0, 0.2}, 180), kNobody));
}

TEST_CASE("The far face is flat: its corners reach further than the range") {
  PhysicsContext context(with(each_engine()));
  // Beside the axis, at a distance of 1.27 m from the sensor, 0.98 m along the axis.
  context.obstacle(ObstacleKind::fixed, 1.0, 0.82, {0.04, 0.04, 0.4});
  CHECK(context.engine->anything_in(wide({0, 0, 0.2}), kNobody));
}

TEST_CASE("A box beside the pyramid is in it from its side face on") {
  PhysicsContext context(with(each_engine()));
  // The corner of the box is at (0.5, 0.5): on the left face of a pyramid at the origin.
  context.obstacle(ObstacleKind::fixed, 0.4, 0.6, {0.2, 0.2, 0.4});
  CHECK(context.engine->anything_in(wide({0, kNear, 0.2}), kNobody));
  CHECK_FALSE(context.engine->anything_in(wide({0, -kNear, 0.2}), kNobody));
}

TEST_CASE("A box above the pyramid is in it from its upper face on") {
  PhysicsContext context(with(each_engine()));
  context.obstacle(ObstacleKind::fixed, 0.8, 0.0, {0.4, 0.1, 0.1}, 0,
                   0.7);  // (1.0, 0.7) is lowest and last
  CHECK(context.engine->anything_in(wide({0, 0, 0.2 + kNear}), kNobody));
  CHECK_FALSE(context.engine->anything_in(wide({0, 0, 0.2 - kNear}), kNobody));
}

TEST_CASE("Edge meets edge") {
  PhysicsContext context(with(each_engine()));
  // An upright edge at (0.6, 0.5) points at the far left edge of the pyramid, which lies at
  // x = 0.6 and runs up and down at y = 1 from an apex at (-0.4, -0.5).
  context.obstacle(ObstacleKind::fixed, 0.6, 0.5 + 0.1 * std::sqrt(2.0), {0.2, 0.2, 0.4}, 45);
  CHECK(context.engine->anything_in(wide({-0.4 + kNear, -0.5 + 2 * kNear, 0.2}), kNobody));
  CHECK_FALSE(context.engine->anything_in(wide({-0.4, -0.5 - kNear, 0.2}), kNobody));
}

TEST_CASE("A pyramid within a box, and a box within a pyramid") {
  PhysicsContext context(with(each_engine()));
  context.obstacle(ObstacleKind::fixed, 0.0, 0.0, {3.0, 3.0, 3.0});
  CHECK(context.engine->anything_in(wide({-0.5, 0, 1.0}), kNobody));
  PhysicsContext other(context.physics);
  other.obstacle(ObstacleKind::fixed, 0.8, 0.0, {0.02, 0.02, 0.02}, 0, 0.2);
  CHECK(other.engine->anything_in(wide({0, 0, 0.2}), kNobody));
}

TEST_CASE("Walls, robots and visible boxes count, the floor and what is left out do not") {
  PhysicsContext context(with(each_engine()));
  CHECK_FALSE(context.engine->anything_in(wide({0, 0, 0.05}), kNobody));  // reaches below the floor
  CHECK(context.engine->anything_in(wide({4.5, 0, 0.2}), kNobody));
  const std::size_t robot = context.robot(0.5, 0);
  CHECK(context.engine->anything_in(wide({0, 0, 0.2}), kNobody));
  CHECK_FALSE(context.engine->anything_in(wide({0, 0, 0.2}), robot));
  world::Obstacle glass;
  glass.y = 2.0;
  glass.x = 0.5;
  glass.seen_by_range_sensors = false;
  context.engine->add_obstacle(glass);
  CHECK_FALSE(context.engine->anything_in(wide({0, 2, 0.1}), kNobody));
}

TEST_CASE("A proximity sensor on a chassis sees a robot of its own size") {
  PhysicsContext context(with(each_engine()));
  const world::RobotBody body;
  const std::size_t self = context.robot(0, 0);
  context.robot(0.4, 0.0, 90);
  const Vector3 top{0.5 * body.length, 0, body.top()};
  CHECK(context.engine->anything_in({Frame{top}, radians(40), radians(5), 0.5}, self));
  CHECK_FALSE(context.engine->anything_in({Frame{top}, radians(40), radians(5), 0.3}, self));
}

TEST_CASE("A box that was taken is in no pyramid") {
  PhysicsContext context(with(each_engine()));
  const std::size_t box = context.obstacle(ObstacleKind::resource, 0.5, 0.0, {0.1, 0.1, 0.4});
  CHECK(context.engine->anything_in(wide({0, 0, 0.2}), kNobody));
  context.engine->remove_obstacle(box);
  CHECK_FALSE(context.engine->anything_in(wide({0, 0, 0.2}), kNobody));
}

TEST_CASE("A pyramid without height holds nothing") {
  PhysicsContext context(with(each_engine()));
  context.obstacle(ObstacleKind::fixed, 0.0, 0.0, {0.1, 0.1, 0.4});
  Pyramid pyramid = wide({0, 0, 0.2});
  pyramid.range_m = 0.0;
  CHECK_FALSE(context.engine->anything_in(pyramid, kNobody));
}

TEST_CASE("Pyramids against random boxes agree with cutting them to pieces") {
  Random random(7);
  const world::Physics physics = with(each_engine());
  int in = 0, out = 0;
  for (int world = 0; world < 40; ++world) {
    PhysicsContext context(physics, open_field(6.0));
    std::vector<std::pair<Frame, Vector3>> obstacles;
    for (int i = 0; i < 6; ++i) {
      world::Obstacle box;
      box.x = random.uniform(-3.5, 3.5);
      box.y = random.uniform(-3.5, 3.5);
      box.z = random.uniform(0.0, 1.0);
      box.heading_deg = random.uniform(-180, 180);
      box.length = random.uniform(0.01, 1.0);
      box.width = random.uniform(0.01, 1.0);
      box.height = random.uniform(0.01, 1.0);
      context.engine->add_obstacle(box);
      obstacles.emplace_back(
          Frame::turned({box.x, box.y, box.z + 0.5 * box.height}, radians(box.heading_deg), 0),
          Vector3{0.5 * box.length, 0.5 * box.width, 0.5 * box.height});
    }
    for (int i = 0; i < 100; ++i) {
      const Vector3 apex{random.uniform(-3.5, 3.5), random.uniform(-3.5, 3.5),
                         random.uniform(0.0, 1.5)};
      const Pyramid pyramid{Frame::turned(apex, random.uniform(-4, 4), random.uniform(-1, 1)),
                            random.uniform(0.01, 2.5), random.uniform(0.01, 2.5),
                            random.uniform(0.1, 3.0)};
      bool expected = false;
      for (const auto& [middle, half] : obstacles)
        expected = expected || overlap(pyramid, middle, half);
      CAPTURE(world, i);
      CHECK(context.engine->anything_in(pyramid, kNobody) == expected);
      ++(expected ? in : out);
    }
  }
  CHECK(in > 500);
  CHECK(out > 500);
}

TEST_CASE("A round chassis is in the pyramid from its nearest point on, not the box around it") {
  const double near = GENERATE(-1e-6, 1e-6);
  // The left face of a pyramid at the origin is the plane y = x; the disc touches it at (0.5, 0.5).
  const double r = 0.1, aside = r * std::sqrt(0.5) + near;
  PhysicsContext context(with(each_engine()));
  context.engine->add_robot(alone(Shape::pillar(r, 0.3)), {0.5 - aside, 0.5 + aside, 0.0});
  CHECK(context.engine->anything_in(wide({0, 0, 0.2}), kNobody) == (near < 0.0));
  context.engine->add_robot(alone(Shape::box({2 * r, 2 * r, 0.3})), {0.5 - aside, 0.5 + aside, 0});
  CHECK(context.engine->anything_in(wide({0, 0, 0.2}), kNobody));
}

TEST_CASE("Pyramids against cylinders agree with boxes in and around them") {
  Random random(5);
  int in = 0, out = 0;
  for (int world = 0; world < 40; ++world) {
    PhysicsContext context({}, open_field(6.0));
    const double r = random.uniform(0.05, 0.6), height = random.uniform(0.05, 1.0);
    const double z = random.uniform(0.0, 1.0);
    const Pose pose{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3)};
    context.engine->add_robot(alone(Shape::pillar(r, height)), pose, z);
    const double top = height + 0.02;  // with the sensor deck
    for (int i = 0; i < 60; ++i) {
      const Vector3 apex{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0),
                         random.uniform(0.0, 2.0)};
      const double yaw = std::atan2(pose.y - apex.y, pose.x - apex.x) + random.uniform(-1, 1);
      const Pyramid pyramid{Frame::turned(apex, yaw, random.uniform(-1, 1)),
                            random.uniform(0.01, 2.0), random.uniform(0.01, 2.0),
                            random.uniform(0.1, 2.0)};
      // The squares in a disc, turned in small steps, leave no more than a rim of 1 % of it out.
      const auto any_square = [&](double radius) {
        constexpr int kTurns = 80;
        for (int k = 0; k < kTurns; ++k) {
          const Frame middle = Frame::turned({pose.x, pose.y, z + 1e-3 + 0.5 * top},
                                             0.5 * std::numbers::pi * k / kTurns, 0.0);
          const double half = radius * std::sqrt(0.5);
          if (overlap(pyramid, middle, {half, half, 0.5 * top})) return true;
        }
        return false;
      };
      const bool found = context.engine->anything_in(pyramid, kNobody);
      CAPTURE(world, i);
      if (any_square(r)) {
        CHECK(found);
        ++in;
      } else if (!any_square(1.015 * r)) {
        CHECK_FALSE(found);
        ++out;
      }
    }
  }
  CHECK(in > 100);
  CHECK(out > 100);
}
