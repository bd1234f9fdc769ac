// Rays against known distances, and against every body one by one.
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"

#include "conformance.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

Vector3 level(double degrees_) {
  return {std::cos(radians(degrees_)), std::sin(radians(degrees_)), 0.0};
}

// The oracle: goes through faces instead of slabs.

double through_face(const Vector3& from, const Vector3& along, const Frame& face, double half_1,
                    double half_2) {
  const double approach = dot(along, face.forward);
  if (approach == 0.0) return kNone;
  const double t = dot(face.origin - from, face.forward) / approach;
  const Vector3 there = from + t * along - face.origin;
  const bool inside =
      std::abs(dot(there, face.left)) <= half_1 && std::abs(dot(there, face.up)) <= half_2;
  return t >= 0.0 && inside ? t : kNone;
}

/// `frame` has its origin in the middle.
double through_box(const Vector3& from, const Vector3& along, const Frame& frame,
                   const Vector3& half) {
  const Vector3 o = from - frame.origin;
  if (std::abs(dot(o, frame.forward)) <= half.x && std::abs(dot(o, frame.left)) <= half.y &&
      std::abs(dot(o, frame.up)) <= half.z) {
    return 0.0;
  }
  double nearest = kNone;
  for (const double side : {-1.0, 1.0}) {
    const auto face = [&](const Vector3& out, double distance, const Vector3& u, double hu,
                          const Vector3& v, double hv) {
      const Frame at{frame.origin + side * distance * out, out, u, v};
      nearest = std::min(nearest, through_face(from, along, at, hu, hv));
    };
    face(frame.forward, half.x, frame.left, half.y, frame.up, half.z);
    face(frame.left, half.y, frame.up, half.z, frame.forward, half.x);
    face(frame.up, half.z, frame.forward, half.x, frame.left, half.y);
  }
  return nearest;
}

/// A wheel of a robot at `middle`, with its axle along `axis`.
double through_wheel(const Vector3& from, const Vector3& along, const Vector3& middle,
                     const Vector3& axis, double radius, double half_width) {
  const auto inside = [&](const Vector3& p, double slack) {
    const double a = dot(p - middle, axis);
    const Vector3 across = p - middle - a * axis;
    return std::abs(a) <= half_width + slack && dot(across, across) <= radius * radius + slack;
  };
  if (inside(from, 0.0)) return 0.0;
  double nearest = kNone;
  const double d = dot(along, axis), o = dot(from - middle, axis);
  for (const double cap : {-half_width, half_width}) {
    const double t = (cap - o) / d;
    if (d != 0.0 && t >= 0.0 && inside(from + t * along, 1e-12)) nearest = std::min(nearest, t);
  }
  const Vector3 p = from - middle - o * axis, q = along - d * axis;
  const double a = dot(q, q), b = dot(p, q), c = dot(p, p) - radius * radius;
  if (a > 0.0 && b * b >= a * c) {
    const double t = (-b - std::sqrt(b * b - a * c)) / a;
    if (t >= 0.0 && inside(from + t * along, 1e-12)) nearest = std::min(nearest, t);
  }
  return nearest;
}

struct Seen {
  Body body;
  Frame frame;  // of the middle
  Vector3 half;
  bool is_robot = false;
  world::RobotBody robot;
};

double through(const Seen& seen, const Vector3& from, const Vector3& along) {
  double nearest = through_box(from, along, seen.frame, seen.half);
  if (!seen.is_robot) return nearest;
  for (const double side : {-1.0, 1.0}) {
    const Frame& f = seen.frame;
    const double up = seen.robot.wheel_radius - seen.robot.clearance - seen.half.z;
    const Vector3 middle = f.point({0.0, side * seen.robot.half_axle(), up});
    nearest = std::min(nearest, through_wheel(from, along, middle, f.left, seen.robot.wheel_radius,
                                              0.5 * seen.robot.wheel_width));
  }
  return nearest;
}

}  // namespace

TEST_CASE("A ray finds the walls at their exact distance") {
  world::Arena arena;
  arena.length = 8.0;
  arena.width = 6.0;
  PhysicsContext context(with(each_engine()), arena);
  CHECK(cast(context, {0, 0, 0.1}, level(0)) == Approx(4.0).margin(1e-9));
  CHECK(cast(context, {0, 0, 0.1}, level(90)) == Approx(3.0).margin(1e-9));
  CHECK(cast(context, {1, 0, 0.1}, level(180)) == Approx(5.0).margin(1e-9));
  CHECK(cast(context, {0, 1, 0.1}, level(-90)) == Approx(4.0).margin(1e-9));
  CHECK(cast(context, {0, 0, 0.1}, level(60)) == Approx(3.0 / std::sin(radians(60))).margin(1e-9));
  const std::array<double, 4> towards{0, 90, 180, -90};
  for (std::size_t wall = 0; wall < 4; ++wall) {
    CHECK(context.engine->cast_ray({0, 0, 0.1}, level(towards[wall]), 10, kNobody)->body ==
          wall_body(wall));
  }
  // Over the walls there is nothing.
  CHECK(cast(context, {0, 0, 0.31}, level(0)) == kNone);
}

TEST_CASE("A ray finds an oriented box at its exact distance") {
  PhysicsContext context(with(each_engine()));
  const double turned = GENERATE(0.0, 17.0, 45.0, 90.0, -130.0);
  const std::size_t box = context.obstacle(ObstacleKind::fixed, 1.0, 2.0, {0.6, 0.4, 0.2}, turned);
  const Frame frame = Frame::turned({1.0, 2.0, 0.1}, radians(turned), 0.0);
  // At the middle of each face, and at a slant.
  CHECK(cast(context, frame.point({-1.3, 0.1, 0}), frame.forward) == Approx(1.0).margin(1e-9));
  CHECK(cast(context, frame.point({0.2, 1.2, 0}), -1.0 * frame.left) == Approx(1.0).margin(1e-9));
  CHECK(cast(context, frame.point({0.1, 0.1, 1.1}), -1.0 * frame.up) == Approx(1.0).margin(1e-9));
  const Vector3 slant = frame.direction({std::sqrt(0.5), std::sqrt(0.5), 0.0});
  CHECK(cast(context, frame.point({-0.8, -0.45, 0}), slant) ==
        Approx(0.5 * std::sqrt(2.0)).margin(1e-9));
  const auto hit = context.engine->cast_ray(frame.point({-1.3, 0.1, 0}), frame.forward, 5, kNobody);
  REQUIRE(hit);
  CHECK(hit->body == box_body(box));
  CHECK_FALSE(hit->floor);
}

TEST_CASE("A grazing ray belongs to the box within its face and to nothing beside it") {
  PhysicsContext context(with(each_engine()));
  context.obstacle(ObstacleKind::fixed, 1.0, 0.0, {0.5, 0.5, 0.5});
  CHECK(cast(context, {0, 0.25 - 1e-9, 0.1}, level(0), 2) == Approx(0.75).margin(1e-9));
  CHECK(cast(context, {0, 0.25, 0.1}, level(0), 2) == Approx(0.75).margin(1e-9));
  CHECK(cast(context, {0, 0.25 + 1e-9, 0.1}, level(0), 2) == kNone);
  CHECK(cast(context, {0, 0, 0.5 + 1e-9}, level(0), 2) == kNone);
}

TEST_CASE("The range limits a ray, its end included") {
  PhysicsContext context(with(each_engine()));
  context.obstacle(ObstacleKind::fixed, 1.25, 0.0, {0.5, 0.5, 0.5});
  CHECK(cast(context, {0, 0, 0.1}, level(0), 1.0) == 1.0);
  CHECK(cast(context, {0, 0, 0.1}, level(0), 0.999999) == kNone);
  CHECK(cast(context, {0, 0, 0.1}, level(0), kNone) == 1.0);
  CHECK(cast(context, {0, 0, 0.1}, level(0), 0.0) == kNone);
}

TEST_CASE("A ray that starts in a body meets it at once") {
  PhysicsContext context(with(each_engine()));
  context.obstacle(ObstacleKind::fixed, 1.0, 0.0, {0.5, 0.5, 0.5});
  CHECK(cast(context, {1.1, 0.1, 0.1}, level(33)) == 0.0);
  CHECK(cast(context, {0.75, 0.0, 0.1}, level(180), 1.0) == 0.0);
}

TEST_CASE("A ray that looks down finds the floor") {
  PhysicsContext context(with(each_engine()));
  const auto hit = context.engine->cast_ray({0, 0, 0.1}, {std::sqrt(0.75), 0, -0.5}, 1.0, kNobody);
  REQUIRE(hit);
  CHECK(hit->floor);
  CHECK(hit->distance == Approx(0.2).margin(1e-9));
  CHECK(cast(context, {0, 0, 0.1}, {0, 0, -1}) == Approx(0.1).margin(1e-12));
  CHECK(cast(context, {0, 0, 0.1}, {0, 0, 1}) == kNone);
  CHECK(cast(context, {0, 0, 0.0}, level(0), 1.0) == kNone);
  context.obstacle(ObstacleKind::fixed, 1.0, 0.0, {0.2, 0.4, 0.3});
  CHECK(cast(context, {1.0, 0.1, 1.0}, {0, 0, -1}) == Approx(0.7).margin(1e-12));
}

TEST_CASE("A robot sees another of its size over its own chassis' top, but not itself") {
  PhysicsContext context(with(each_engine()));
  const std::size_t self = context.robot(0, 0);
  const std::size_t other = context.robot(0.5, 0, 90);
  const world::RobotBody body;
  const Vector3 sensor{0.5 * body.length, 0.0, body.top()};
  const auto hit = context.engine->cast_ray(sensor, level(0), 1.0, self);
  REQUIRE(hit);
  CHECK(hit->body == robot_body(other));
  // From the own front edge to the other's side.
  CHECK(hit->distance == Approx(0.5 - 0.04 - 0.04).margin(1e-9));
  CHECK(context.engine->cast_ray(sensor, level(180), 1.0, self) == std::nullopt);
  CHECK(cast(context, sensor, level(180), 1.0, kNobody) == 0.0);
  const std::size_t disc = context.robot(0.0, 1.0, 20, round_body(0.12));
  CHECK(cast(context, {0, 0.5, 0.05}, level(90), 2.0, self) == Approx(0.44).margin(1e-9));
  CHECK(cast(context, {0, 0.5, 0.05}, level(90), 2.0, disc) == kNone);
  // The sensor deck ends 2 cm above the chassis.
  CHECK(cast(context, {0, 0, body.top() + 0.019}, level(0), 1.0, self) < 1.0);
  CHECK(cast(context, {0, 0, body.top() + 0.021}, level(0), 1.0, self) == kNone);
}

TEST_CASE("A wheel is seen as the cylinder that it is") {
  PhysicsContext context(with(each_engine()));
  context.robot(0, 0);
  const world::RobotBody body;
  // From ahead, past the chassis, onto the tyre; at axle height and above.
  CHECK(cast(context, {1, 0.045, 0.02}, level(180)) == Approx(1.0 - 0.02).margin(1e-9));
  CHECK(cast(context, {1, 0.045, 0.032}, level(180)) == Approx(1.0 - 0.016).margin(1e-9));
  // From the side onto its face.
  CHECK(cast(context, {0.01, 1, 0.02}, level(-90)) == Approx(1.0 - 0.05).margin(1e-9));
  // Beside it, onto the chassis.
  CHECK(cast(context, {0.03, 1, 0.03}, level(-90)) == Approx(1.0 - 0.04).margin(1e-9));
}

TEST_CASE("Boxes that range sensors do not see let rays through") {
  PhysicsContext context(with(each_engine()));
  world::Obstacle glass;
  glass.x = 1.0;
  glass.seen_by_range_sensors = false;
  context.engine->add_obstacle(glass);
  const std::size_t behind = context.obstacle(ObstacleKind::fixed, 2.0, 0.0, {0.2, 0.2, 0.2});
  const auto hit = context.engine->cast_ray({0, 0, 0.1}, level(0), 5, kNobody);
  REQUIRE(hit);
  CHECK(hit->body == box_body(behind));
}

TEST_CASE("Rays see bodies where they have moved to") {
  PhysicsContext context(with(each_engine()));
  const std::size_t robot = context.robot(-3.0, 0);
  const std::size_t moving = context.obstacle(ObstacleKind::moving, 2.0, 2.0, {0.2, 0.2, 0.2});
  context.drive(robot, {25, 25});
  context.drive(moving, {-0.5, 0.0}, 4.0);
  const double front = context.pose(robot).x + 0.04;
  CHECK(cast(context, {front + 1.0, 0, 0.05}, level(180), 2.0) == Approx(1.0).margin(1e-9));
  CHECK(cast(context, {-1.0, 2.0, 0.1}, level(0), 2.0) == Approx(0.9).margin(1e-9));
  CHECK(cast(context, {2.0, 1.0, 0.1}, level(90), 2.0) == kNone);
}

TEST_CASE("Of two bodies at the same distance the first is met") {
  PhysicsContext context(with(each_engine()));
  context.obstacle(ObstacleKind::fixed, 1.0, 0.1, {0.2, 0.2, 0.2});
  context.obstacle(ObstacleKind::fixed, 1.0, -0.1, {0.2, 0.2, 0.2});
  CHECK(context.engine->cast_ray({0, 0, 0.1}, level(0), 5, kNobody)->body == box_body(0));
}

TEST_CASE("Pruning changes no answer: random worlds, every body asked one by one") {
  const std::uint64_t seed = GENERATE(1u, 2u, 3u, 4u);
  Random random(seed);
  world::Arena arena;
  arena.length = seed == 3 ? 70.0 : 6.0;
  arena.width = 4.0;
  PhysicsContext context(with(each_engine()), arena);
  std::vector<Seen> all;
  const double lx = 0.5 * arena.length, ly = 0.5 * arena.width;
  for (std::size_t wall = 0; wall < 4; ++wall) {
    const bool along_y = wall % 2 == 0;
    const double side = wall < 2 ? 1.0 : -1.0;
    const Vector3 at =
        along_y ? Vector3{side * (lx + 0.05), 0, 0.15} : Vector3{0, side * (ly + 0.05), 0.15};
    const Vector3 half = along_y ? Vector3{0.05, ly, 0.15} : Vector3{lx + 0.1, 0.05, 0.15};
    all.push_back({wall_body(wall), Frame::turned(at, 0, 0), half, false, {}});
  }
  for (std::size_t i = 0; i < 25; ++i) {
    world::Obstacle box;
    box.x = random.uniform(-lx - 0.5, lx + 0.5);
    box.y = random.uniform(-ly - 0.5, ly + 0.5);
    box.z = random.chance(0.3) ? random.uniform(0.0, 0.2) : 0.0;
    box.heading_deg =
        random.chance(0.3) ? 90.0 * static_cast<double>(i % 4) : random.uniform(-180, 180);
    box.length = random.uniform(0.01, 1.0);
    box.width = random.uniform(0.01, 0.5);
    box.height = random.uniform(0.05, 0.4);
    context.engine->add_obstacle(box);
    const Vector3 middle{box.x, box.y, box.z + 0.5 * box.height};
    all.push_back({box_body(i),
                   Frame::turned(middle, radians(box.heading_deg), 0),
                   Vector3{0.5 * box.length, 0.5 * box.width, 0.5 * box.height},
                   false,
                   {}});
  }
  for (std::size_t i = 0; i < 25; ++i) {
    const world::RobotBody body;
    const double heading = random.uniform(-180, 180);
    context.robot(random.uniform(-lx, lx), random.uniform(-ly, ly), heading, body);
    const Frame frame = context.engine->robot(i).frame;
    // The chassis with the sensor deck of 2 cm.
    const Vector3 half{0.5 * body.length, 0.5 * body.width, 0.5 * (body.height + 0.02)};
    Frame middle = frame;
    middle.origin = frame.point({0, 0, body.clearance + half.z});
    all.push_back({robot_body(i), middle, half, true, body});
  }

  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3 from{random.uniform(-lx - 1, lx + 1), random.uniform(-ly - 1, ly + 1),
                       random.uniform(0.0, 0.35)};
    const double yaw = random.chance(0.2) ? radians(90.0 * (i % 4)) : random.uniform(-4, 4);
    const double pitch = random.chance(0.5) ? 0.0 : random.uniform(-1.5, 1.5);
    const Vector3 along = Frame::turned({}, yaw, pitch).forward;
    const double range = random.chance(0.5) ? 1.0 : random.uniform(0, 100);
    const std::size_t except = static_cast<std::size_t>(i % 26);
    double nearest = kNone;
    Body body;
    for (const Seen& seen : all) {
      if (seen.body == robot_body(except)) continue;
      const double distance = through(seen, from, along);
      if (distance < nearest) {
        nearest = distance;
        body = seen.body;
      }
    }
    const double floor = along.z < 0.0 ? -from.z / along.z : kNone;
    CAPTURE(i, from.x, from.y, from.z, yaw, pitch, range);
    const auto hit = context.engine->cast_ray(from, along, range, except);
    const double expected = std::min(nearest, floor);
    if (expected > range) {
      CHECK_FALSE(hit.has_value());
      continue;
    }
    ++hits;
    REQUIRE(hit.has_value());
    CHECK(hit->distance == Approx(expected).margin(1e-9));
    CHECK(hit->floor == (floor < nearest));
    if (!hit->floor && hit->distance > 0.0) CHECK(hit->body == body);
  }
  CHECK(hits > 1000);
}
