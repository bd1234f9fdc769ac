// The parts of bodies, and the ground that they cover.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <catch2/catch.hpp>

#include "elsie/shapes/obstacle_shapes.h"
#include "elsie/shapes/outline.h"
#include "elsie/world/footprint.h"
#include "elsie/world/parts.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const std::string kRound =
    "<body shape='round' length='0.1' width='0.1' axle='0.08' wheel_width='0.01'/>";

world::RobotBody round_body() {
  world::RobotBody body;
  body.round = true;
  body.length = body.width = 0.1;
  body.axle = 0.08;
  return body;
}

world::Footprint disc(double x, double y, double radius) {
  world::Footprint made;
  made.x = x;
  made.y = y;
  made.half_length = made.half_width = radius;
  made.top = 0.1;
  made.round = true;
  return made;
}

world::Footprint rectangle(double x, double y, double heading_rad, double half_length,
                           double half_width) {
  return {x, y, heading_rad, half_length, half_width, 0.0, 0.1};
}

}  // namespace

TEST_CASE("A chassis is a box unless its file says that it is round") {
  const world::World w =
      read("<robots><robot id='a'/><robot id='b' x='1'>" + kRound + "</robot></robots>");
  CHECK_FALSE(w.robots[0].body.round);
  CHECK(w.robots[1].body.round);
  const Shape box = world::plan_of(w.robots[0]).parts[0].shape;
  CHECK(box.kind == Shape::Kind::box);
  CHECK(box.size == Vector3{0.08, 0.08, 0.08});
  const Part round = world::plan_of(w.robots[1]).parts[0];
  CHECK(round.shape.kind == Shape::Kind::cylinder);
  CHECK(round.shape.is_round());
  CHECK(round.shape.radius() == 0.05);
  CHECK(round.shape.length() == 0.08);
  CHECK(round.frame.origin.z == Approx(0.05));
}

TEST_CASE("Only boxes and round chassis are known") {
  CHECK_THAT(problems("<robots><robot id='r'><body shape='oval'/></robot></robots>"),
             Catch::Contains("box") && Catch::Contains("round") && Catch::Contains("oval"));
}

TEST_CASE("The axis of a shape says how it lies") {
  const Frame frame = Frame::turned({1.0, 2.0, 3.0}, 0.4, 0.3);
  for (const auto& [axis, direction] :
       {std::pair(Shape::Axis::forward, frame.forward), std::pair(Shape::Axis::left, frame.left),
        std::pair(Shape::Axis::up, frame.up)}) {
    const Shape capsule = Shape::capsule(0.1, 0.5, axis);
    CHECK(capsule.radius() == Approx(0.1));
    CHECK(capsule.length() == Approx(0.5));
    CHECK(capsule.is_round() == (axis == Shape::Axis::up));
    const Frame along = along_axis(frame, axis);
    CHECK(along.origin == frame.origin);
    CHECK(along.up == direction);
    // Right-handed.
    const Vector3 &f = along.forward, &l = along.left;
    CHECK(f.y * l.z - f.z * l.y == Approx(along.up.x));
    CHECK(f.z * l.x - f.x * l.z == Approx(along.up.y));
    CHECK(f.x * l.y - f.y * l.x == Approx(along.up.z));
  }
}

TEST_CASE("A robot reaches as far as its chassis and its wheels") {
  const world::RobotBody box;
  const Vector3 extents = world::extents_of(world::plan_of(box, {}).parts);
  CHECK(extents.x == 0.5 * box.length);
  CHECK(extents.y == box.half_axle() + 0.5 * box.wheel_width);
  CHECK(extents.z == Approx(box.top()));
  CHECK(world::radius_of(world::plan_of(box, {}).parts) == 0.0);

  world::RobotBody round = round_body();
  CHECK(world::radius_of(world::plan_of(round, {}).parts) == 0.05);  // the wheels are within
  round.axle = 0.1;
  CHECK(world::radius_of(world::plan_of(round, {}).parts) == Approx(std::hypot(0.055, 0.02)));
}

TEST_CASE("A steered wheel reaches as far wherever it points") {
  Part wheel;
  wheel.shape = Shape::wheel(0.03, 0.04);
  wheel.joint = WheelJoint{};
  CHECK(world::reach_of(wheel).x == 0.03);
  CHECK(world::reach_of(wheel).y == 0.02);
  const double c = std::cos(0.5), s = std::sin(0.5);
  wheel.frame = Frame::turned({}, 0.5, 0.0);
  CHECK(world::reach_of(wheel).x == Approx(0.03 * c + 0.02 * s));
  CHECK(world::reach_of(wheel).y == Approx(0.03 * s + 0.02 * c));
  WheelJoint steered;
  steered.steered = true;
  wheel.joint = steered;
  CHECK(world::reach_of(wheel).x == Approx(std::hypot(0.03, 0.02)));
  CHECK(world::reach_of(wheel).z == Approx(0.03));
}

TEST_CASE("Discs overlap where their middles are nearer than their radii") {
  CHECK(world::overlap(disc(0, 0, 0.1), disc(0.12, 0.16, 0.1001)));
  CHECK_FALSE(world::overlap(disc(0, 0, 0.1), disc(0.12, 0.16, 0.1)));
  world::Footprint above = disc(0, 0, 0.1);
  above.bottom = 0.1;
  above.top = 0.2;
  CHECK_FALSE(world::overlap(disc(0, 0, 0.1), above));
}

TEST_CASE("Prisms overlap where their outlines do, not the boxes around them") {
  const auto prism = [](double x, double y, double heading_deg) {
    world::Obstacle box;
    box.shape = ObstacleShape::prism;
    box.points = {{5.0, 5.0}, {5.0, 5.3}, {5.6, 5.0}};  // clockwise, from another origin
    box.x = x;
    box.y = y;
    box.heading_deg = heading_deg;
    return world::footprint_of(box);
  };
  // Its right angle is 0.2 m west and 0.1 m south of its middle.
  const world::Footprint first = prism(0, 0, 0);
  CHECK(first.reach(1, 0) == Approx(0.4));
  CHECK(first.reach(-1, 0) == Approx(0.2));
  CHECK(first.reach(0, 1) == Approx(0.2));
  CHECK(first.reach(0, -1) == Approx(0.1));
  CHECK(first.grown(0.05).reach(-1, 0) == Approx(0.25));
  CHECK(area_of(first.outline) == Approx(0.09));
  // Two halves of a rectangle, slope to slope, 0.2 x 0.1 m from its middle.
  CHECK_FALSE(world::overlap(first, prism(0.2, 0.1, 180)));
  CHECK(world::overlap(first, prism(0.199, 0.099, 180)));
  // Discs beside the slope, whose distance from the middle is 0.1 m times the cosine, and beyond
  // the tip.
  const double cosine = 2.0 / std::sqrt(5.0), sine = 1.0 / std::sqrt(5.0);
  const double away = 0.1 * cosine + 0.2;
  CHECK_FALSE(world::overlap(disc(away * sine, away * cosine, 0.2), first));
  CHECK(world::overlap(disc(away * sine, away * cosine, 0.2001), first));
  CHECK_FALSE(world::overlap(first, disc(0.4 + 0.12, -0.1 - 0.16, 0.1999)));
  CHECK(world::overlap(first, disc(0.4 + 0.12, -0.1 - 0.16, 0.2001)));
}

TEST_CASE("A disc overlaps a rectangle from the nearest point of its edge on") {
  const double turned = GENERATE(0.0, 0.3, 2.0, -1.2);
  const world::Footprint box = rectangle(0.5, -0.2, turned, 0.3, 0.2);
  const auto overlaps = [&](double along, double aside, double radius) {
    const Vector2 at = point_of({0.5, -0.2, turned}, {along, aside});
    const world::Footprint round = disc(at.x, at.y, radius);
    CHECK(world::overlap(round, box) == world::overlap(box, round));
    return world::overlap(round, box);
  };
  CHECK(overlaps(0.4, 0.1, 0.1001));
  CHECK_FALSE(overlaps(0.4, 0.1, 0.0999));
  CHECK(overlaps(-0.1, -0.3, 0.1001));
  CHECK_FALSE(overlaps(-0.1, -0.3, 0.0999));
  // Past the corner, where the square around the disc would overlap.
  CHECK(overlaps(0.36, 0.28, 0.1001));
  CHECK_FALSE(overlaps(0.36, 0.28, 0.0999));
  CHECK(overlaps(0.1, 0.05, 0.01));  // inside
}

TEST_CASE("A round robot may stand as near to a wall as its radius, whatever its heading") {
  const auto robot = [](const std::string& place) {
    return "<robots><robot id='r' heading_deg='45' " + place + ">" + kRound + "</robot></robots>";
  };
  CHECK(problems(robot("x='4.95' y='-4.95'")) == "");
  CHECK_THAT(problems(robot("x='4.951'")),
             Catch::Contains("the robot 'r' reaches 0.001 m into the east wall"));
  // Off the corner of a box by 0.05 m.
  const std::string box = "<obstacles><static_box id='b' length='0.2' width='0.2'/></obstacles>";
  CHECK(problems(box + robot("x='0.13001' y='0.14'")) == "");
  CHECK_THAT(problems(box + robot("x='0.1299' y='0.14'")),
             Catch::Contains("the robot 'r' overlaps the box 'b'"));
}

TEST_CASE("Behind a round robot a joint turns until the segment would touch, and no further") {
  const double hitch = GENERATE(0.055, 0.06, 0.07, 0.08);
  const double gap = GENERATE(0.035, 0.04, 0.05);
  CAPTURE(hitch, gap);
  const double radius = 0.05;
  world::Segment segment;
  segment.gap = gap;
  segment.hitch = hitch;
  const world::Coupling joint =
      world::couplings(world::plan_of(round_body(), {}), std::vector{segment})[0];
  CHECK(joint.behind + joint.ahead == Approx(radius + gap + 0.5 * segment.length));
  // From the disc to the segment, whose frame has its origin in the joint.
  const double front = 0.5 * segment.length - joint.ahead;  // its front face, behind the joint
  const auto room = [&](double yaw) {
    const double x = hitch * std::cos(yaw), y = std::abs(hitch * std::sin(yaw));
    return std::hypot(std::max(0.0, x - front), std::max(0.0, y - 0.5 * segment.width)) - radius;
  };
  const double limit = joint.max_yaw_rad;
  CHECK(limit > 0.3);
  for (double yaw = 0.0; yaw < limit; yaw += 0.01) CHECK(room(yaw) > -1e-12);
  if (limit < 0.5 * std::numbers::pi) {
    CHECK(room(limit) == Approx(0.0).margin(1e-12));
    CHECK(room(limit + 0.01) < 0.0);
  }
}

TEST_CASE("Wheels that stand out do not stop a segment before it turns") {
  world::Segment segment;
  segment.gap = 0.005;
  world::RobotBody body = round_body();
  body.axle = 0.12;
  CHECK(world::couplings(world::plan_of(body, {}), std::vector{segment})[0].max_yaw_rad > 0.01);
}
