// Trains against the closed forms of a vehicle that pulls trailers. With the joint M behind the
// axle of the body in front and L ahead of the segment's own axle:
//
// - in a steady circle of radius r the segment's axle runs at sqrt(r^2 + M^2 - L^2), and so on from
//   segment to segment;
// - behind a joint that moves straight on by s the angle between the segment and that line follows
//   tan(angle / 2) = tan(angle_0 / 2) exp(-s / L), the tractrix; backwards s counts negative, so
//   that any angle grows.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/world/parts.h"

#include "trains.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

const std::vector<world::Segment> kThree(3);

/// Axles that are hitched to, instead of points behind them.
std::vector<world::Segment> on_axle() {
  std::vector<world::Segment> segments(3);
  for (world::Segment& segment : segments) {
    segment.hitch = 0.0;
    segment.max_yaw_deg = 60.0;
  }
  return segments;
}

/// Hitched to the axle in front, so that the joint is on the line from the first instant on.
world::Segment long_segment(double max_yaw_deg) {
  world::Segment segment;
  segment.hitch = 0.0;
  segment.length = 0.3;
  segment.max_yaw_deg = max_yaw_deg;
  return segment;
}

double tilt(const Frame& frame) { return std::acos(std::min(1.0, frame.up.z)); }

}  // namespace

TEST_CASE("A train at rest stays where it is, level and in line") {
  const bool is_long = GENERATE(false, true);  // 30 segments are for the exact solver
  const double step = is_long ? GENERATE(0.001, 0.01, 0.1) : GENERATE(0.001, 0.005, 0.01, 0.02);
  CAPTURE(is_long, step);
  PhysicsContext context(with_step(step));
  const std::size_t count = is_long ? 30 : 3;
  const Pose pose = is_long ? Pose{4, 0, 0} : Pose{1, 2, radians(40)};
  const Train standing =
      train(context, std::vector<world::Segment>(count), pose.x, pose.y, degrees(pose.heading_rad));
  context.run(is_long ? 100 * step : 60.0);
  for (std::size_t i = 0; i < count; ++i) {
    const SegmentState state = standing.segment(i);
    const Vector2 at = point_of(pose, {-standing.joints[i].place, 0.0});
    CHECK(std::hypot(state.pose.x - at.x, state.pose.y - at.y) < (is_long ? 1e-6 : 1e-4));
    CHECK(std::abs(state.frame.origin.z) < 1e-4);
    CHECK(std::abs(state.yaw_rad) < (is_long ? 1e-6 : 1e-4));
    CHECK(tilt(state.frame) < 1e-4);
  }
}

TEST_CASE("Straight on the segments follow in line, at their distance") {
  const double step = GENERATE(0.005, 0.02);
  const double rate = GENERATE(10.0, 25.0);
  CAPTURE(step, rate);
  PhysicsContext context(with_step(step), open_field());
  Train pulled = train(context, kThree);
  pulled.drive(rate, rate);
  double widest = 0.0, steepest = 0.0, most_turned = 0.0;
  context.run(10.0, [&] {
    widest = std::max(widest, pulled.widest_gap());
    for (std::size_t i = 0; i < 3; ++i) {
      steepest = std::max(steepest, tilt(pulled.segment(i).frame));
      most_turned = std::max(most_turned, std::abs(pulled.segment(i).yaw_rad));
    }
  });
  CHECK(widest < 1e-9);
  CHECK(steepest < 1e-3);
  CHECK(most_turned < 1e-3);
  const Pose front = context.pose(0);
  CHECK(front.x == Approx(0.02 * rate * 10.0).epsilon(0.02));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(distance(front, pulled.segment(i).pose) == Approx(pulled.joints[i].place).margin(1e-5));
    CHECK(std::abs(pulled.segment(i).pose.y) < 1e-3);
  }
}

TEST_CASE("In a steady circle each axle runs at the radius of the closed form") {
  const double step = GENERATE(0.001, 0.01, 0.02);
  const bool hitched_to_axles = GENERATE(false, true);
  const WheelRates rates = GENERATE(WheelRates{18, 24}, WheelRates{24, 20});
  CAPTURE(step, hitched_to_axles, rates.left);
  PhysicsContext context(with_step(step), open_field());
  Train pulled = train(context, hitched_to_axles ? on_axle() : kThree);
  pulled.drive(rates.left, rates.right);
  context.run(20.0);
  const world::RobotBody body;
  const double radius = body.half_axle() * (rates.right + rates.left) / (rates.right - rates.left);
  const Pose pose = context.pose(0);
  check_circle(pulled, rates, 1e-4);
  double squared = radius * radius, heading = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const world::Coupling& joint = pulled.joints[i];
    const double outer = std::sqrt(squared),
                 to_joint = std::sqrt(squared + joint.behind * joint.behind);
    squared += joint.behind * joint.behind - joint.ahead * joint.ahead;
    const SegmentState state = pulled.segment(i);
    // The angles between axle lines: those at the center between axle and joint, on either side.
    const double turned = std::acos(outer / to_joint) + std::acos(std::sqrt(squared) / to_joint);
    heading += std::copysign(turned, radius);
    CHECK(state.yaw_rad == Approx(-std::copysign(turned, radius)).margin(1e-3));
    CHECK(wrap_angle(pose.heading_rad - state.pose.heading_rad) == Approx(heading).margin(3e-3));
  }
  CHECK(pulled.widest_gap() < 1e-9);
}

TEST_CASE("Behind a joint that goes straight on, the angle decays along the tractrix") {
  const double step = GENERATE(0.005, 0.02);
  CAPTURE(step);
  PhysicsContext context(with_step(step), open_field());
  Train pulled = train(context, {long_segment(80.0)});
  pulled.drive(14, 20);
  context.run(10.0);
  pulled.drive(20, 20);
  context.run(0.1);
  const double length = pulled.joints[0].ahead;
  const double angle = pulled.segment(0).yaw_rad;
  CHECK(std::abs(angle) > 0.2);
  const Pose start = context.pose(0);
  double farthest_off = 0.0;
  context.run(2.0, [&] {
    const double s = distance(start, context.pose(0));
    const double expected = 2.0 * std::atan(std::tan(0.5 * angle) * std::exp(-s / length));
    farthest_off = std::max(farthest_off, std::abs(pulled.segment(0).yaw_rad - expected));
  });
  CHECK(farthest_off < 0.4 * step);  // an integration of first order
}

TEST_CASE("Reversing jack-knifes along the same curve, up to the limit of the joint") {
  const double step = GENERATE(0.005, 0.02);
  CAPTURE(step);
  PhysicsContext context(with_step(step), open_field());
  Train pushed = train(context, {long_segment(70.0)});
  pushed.drive(18, 20);
  context.run(5.0);
  pushed.drive(-10, -10);
  context.run(0.2);
  const double length = pushed.joints[0].ahead;
  const double angle = pushed.segment(0).yaw_rad;
  CHECK(std::abs(angle) > 0.03);
  const Pose start = context.pose(0);
  double farthest_off = 0.0, most = 0.0;
  context.run(20.0, [&] {
    const double s = distance(start, context.pose(0));
    const double now = pushed.segment(0).yaw_rad;
    most = std::max(most, std::abs(now));
    const double expected = 2.0 * std::atan(std::tan(0.5 * angle) * std::exp(s / length));
    if (std::abs(expected) < radians(60.0) && most < radians(60.0)) {
      farthest_off = std::max(farthest_off, std::abs(now - expected));
    }
  });
  CHECK(farthest_off < 0.02);
  CHECK(most == Approx(radians(70.0)).margin(1e-6));
  CHECK(std::abs(pushed.segment(0).frame.origin.z) < 1e-3);
}

TEST_CASE("A train that is thrown about keeps to its joints and gains no energy but its motors'") {
  const double step = GENERATE(0.005, 0.02);
  const double mass = GENERATE(0.02, 0.1, 1.0);
  CAPTURE(step, mass);
  PhysicsContext context(with_step(step), open_field(100.0));
  std::vector<world::Segment> segments(3);
  for (world::Segment& segment : segments) segment.mass = mass;
  Train thrown = train(context, segments);
  Random random(5);
  const world::RobotBody body;
  const double fastest = 25.0, power = 2.0 * body.wheel_torque * fastest;
  Energy energy(thrown);
  const auto window = static_cast<std::size_t>(std::lround(0.1 / step));
  std::vector<double> history{energy.now()};
  double past_limit = -1.0, widest = 0.0, worst_gain = -1.0, next_change = 0.0, time = 0.0;
  context.run(60.0, [&] {
    time += step;
    if (time >= next_change) {
      thrown.drive(random.uniform(-fastest, fastest), random.uniform(-fastest, fastest));
      next_change += 0.5;
    }
    history.push_back(energy.now());
    if (history.size() > window) {
      worst_gain = std::max(worst_gain, history.back() - history[history.size() - 1 - window]);
    }
    widest = std::max(widest, thrown.widest_gap());
    for (std::size_t i = 0; i < 3; ++i) {
      past_limit =
          std::max(past_limit, std::abs(thrown.segment(i).yaw_rad) - thrown.joints[i].max_yaw_rad);
    }
  });
  CHECK(worst_gain < 1.1 * power * 0.1);
  CHECK(worst_gain > 0.0);
  CHECK(widest < 1e-9);
  CHECK(past_limit <= 0.0);
  CHECK(past_limit > -1e-9);  // the limits were needed

  thrown.drive(0, 0);
  context.run(2.0);
  const Pose resting = thrown.segment(2).pose;
  context.run(10.0);
  CHECK(distance(resting, thrown.segment(2).pose) < 1e-4);
}

TEST_CASE("A train that is dropped lands on its wheels") {
  const double step = GENERATE(0.001, 0.01, 0.02);
  CAPTURE(step);
  PhysicsContext context(with_step(step));
  const std::size_t robot = context.engine->add_robot(world::plan_of({}, kThree), {0, 0, 0.3}, 0.2);
  context.run(0.1);
  CHECK(context.engine->segment(robot, 2).frame.origin.z > 0.1);
  context.run(2.0);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::abs(context.engine->segment(robot, i).frame.origin.z) < 1e-4);
    CHECK(tilt(context.engine->segment(robot, i).frame) < 1e-3);
  }
}

TEST_CASE("What a segment touches, its robot touches, once") {
  PhysicsContext context;
  // Two segments along one box.
  Train pulled = train(context, kThree);
  const double middle = -0.5 * (pulled.joints[0].place + pulled.joints[1].place);
  const std::size_t box =
      context.obstacle(ObstacleKind::dynamic, middle, 0.03 + 0.05, {0.4, 0.1, 0.2});
  context.run(0.1);
  CHECK(context.touching(robot_body(0), box_body(box)));
  CHECK(context.engine->touches().size() == 1);
}

TEST_CASE("Segments are stopped by walls and boxes, and push what can be pushed") {
  PhysicsContext context;
  // It backs into a wall.
  Train backing = train(context, std::vector<world::Segment>(1), 4.6);
  context.engine->place_robot(backing.robot, {4.6, 0.0, std::numbers::pi});
  backing.drive(-10, -10);
  bool touched = false;
  double farthest = 0.0;
  context.run(5.0, [&] {
    const SegmentState last = backing.segment(0);
    for (const double side : {-0.03, 0.03}) {
      farthest = std::max(farthest, last.frame.point({-0.04, side, 0.05}).x);
    }
    touched = touched || context.touching(robot_body(0), wall_body(0));
  });
  CHECK(touched);
  CHECK(farthest == Approx(5.0).margin(1e-3));

  // Another robot drives into a segment from the side, and it gives way.
  Train parked = train(context, std::vector<world::Segment>(2), -2.0, 0.0, 0.0);
  const std::size_t other = context.robot(-2.0 - parked.joints[1].place, -0.3, 90.0);
  context.drive(other, {15, 15});
  bool met = false;
  context.run(3.0, [&] { met = met || context.touching(robot_body(1), robot_body(2)); });
  CHECK(met);
  CHECK(parked.segment(1).pose.y > 0.01);
}

TEST_CASE("A train that curls up is stopped by its own segments, which is no touch") {
  PhysicsContext context;
  std::vector<world::Segment> segments(9);
  Train curling = train(context, segments);
  curling.drive(4, 14);
  bool touched = false;
  double nearest = 1.0;
  context.run(30.0, [&] {
    touched = touched || !context.engine->touches().empty();
    for (std::size_t i = 0; i < 9; ++i) {
      if (i > 0) nearest = std::min(nearest, distance(context.pose(0), curling.segment(i).pose));
      for (std::size_t k = i + 2; k < 9; ++k) {
        nearest = std::min(nearest, distance(curling.segment(i).pose, curling.segment(k).pose));
      }
    }
  });
  CHECK_FALSE(touched);
  CHECK(nearest > 0.0595);  // they are 0.06 m wide
  CHECK(nearest < 0.13);
}

TEST_CASE("Rays and pyramids see the segments of other robots, and not one's own") {
  PhysicsContext context;
  Train pulled = train(context, kThree);
  const std::size_t watcher = context.robot(-0.24, -1.0, 90.0);
  const Vector3 ahead{0.0, 1.0, 0.0};
  const Vector3 from{-0.24, -1.0, 0.09};
  const auto hit = context.engine->cast_ray(from, ahead, 5.0, watcher);
  REQUIRE(hit);
  CHECK(hit->body == robot_body(pulled.robot));
  CHECK(hit->distance == Approx(0.97).margin(1e-6));
  CHECK(context.engine->cast_ray(from, ahead, 5.0, pulled.robot)->body == robot_body(watcher));
  const Vector3 past_watcher{-0.24, -0.9, 0.09};
  CHECK(context.engine->cast_ray(past_watcher, ahead, 10.0, pulled.robot)->body == wall_body(1));
  // Between two segments, and below a box, where the wheels are.
  CHECK(context.engine->cast_ray({-0.18, -1.0, 0.09}, ahead, 10.0, watcher)->body == wall_body(1));
  const auto wheel = context.engine->cast_ray({-0.24, -0.9, 0.005}, ahead, 5.0, watcher);
  REQUIRE(wheel);
  CHECK(wheel->distance == Approx(0.87).margin(1e-6));
  CHECK(wheel->body == robot_body(pulled.robot));

  const Frame looking{past_watcher, ahead, {-1, 0, 0}, {0, 0, 1}};
  CHECK(context.engine->anything_in({looking, 0.1, 0.1, 0.9}, watcher));
  CHECK_FALSE(context.engine->anything_in({looking, 0.1, 0.1, 0.8}, watcher));
  CHECK_FALSE(context.engine->anything_in({looking, 0.1, 0.1, 0.9}, pulled.robot));
}

TEST_CASE("Segments are seen where they have gone") {
  PhysicsContext context({}, open_field());
  Train pulled = train(context, kThree);
  pulled.drive(20, 22);
  for (int i = 0; i < 20; ++i) {
    context.run(0.5);
    const Frame last = pulled.segment(2).frame;
    const Vector3 from = last.point({-0.5, 0.0, 0.08});
    const auto hit = context.engine->cast_ray(from, last.forward, 5.0, Engine::kNobody);
    REQUIRE(hit);
    CHECK(hit->distance == Approx(0.46).margin(1e-6));
  }
}

TEST_CASE("A train can be put somewhere else") {
  PhysicsContext moved, made;
  Train one = train(moved, kThree, 1, 1, 10);
  one.drive(10, 20);
  moved.run(2.0);
  moved.engine->place_robot(0, {-2.0, 1.5, radians(130.0)});
  Train other = train(made, kThree, -2.0, 1.5, 130.0);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(distance(one.segment(i).pose, other.segment(i).pose) < 1e-12);
    CHECK(std::abs(one.segment(i).yaw_rad) < 1e-12);
  }
  CHECK(one.widest_gap() < 1e-12);
  other.drive(10, 20);
  for (PhysicsContext* context : {&moved, &made}) context->run(2.0);
  CHECK(distance(one.segment(2).pose, other.segment(2).pose) < 1e-6);
  CHECK_THROWS_AS(moved.engine->place_robot(1, {}), std::out_of_range);
  CHECK_THROWS_AS(moved.engine->place_robot(0, {NAN, 0, 0}), std::invalid_argument);
}

TEST_CASE("Trains are deterministic, and the hash knows them") {
  const auto history = [](double mass) {
    world::Arena small;
    small.length = small.width = 2.0;
    PhysicsContext context({}, small);
    std::vector<world::Segment> segments(3);
    segments[2].mass = mass;
    context.train(0.5, 0.5, 0, segments);
    context.train(0.0, -0.5, 180, segments);
    context.obstacle(ObstacleKind::dynamic, 0.8, 0.0, {0.1, 0.2, 0.1}, 20);
    Random random(3);
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 40; ++i) {
      for (const std::size_t robot : {0, 1}) {
        context.drive(robot, {random.uniform(-5, 25), random.uniform(-5, 25)});
      }
      context.run(0.25);
      hashes.push_back(context.engine->hash_state());
    }
    return hashes;
  };
  const auto first = history(0.1);
  CHECK(history(0.1) == first);
  CHECK(history(0.11) != first);

  PhysicsContext with, without;
  with.train(0, 0, 0, std::vector<world::Segment>(1));
  without.train(0, 0, 0, {});
  CHECK(with.engine->hash_state() != without.engine->hash_state());
}

TEST_CASE("The engine refuses segments that cannot be") {
  PhysicsContext context;
  const auto with = [&](void (*change)(world::Segment&)) {
    std::vector<world::Segment> segments(1);
    change(segments[0]);
    context.train(0, 0, 0, segments);
  };
  CHECK_THROWS_AS(with([](world::Segment& s) { s.mass = 0.0; }), std::invalid_argument);
  CHECK_THROWS_AS(with([](world::Segment& s) { s.gap = NAN; }), std::invalid_argument);
  CHECK_THROWS_AS(with([](world::Segment& s) { s.wheel_width = 0.04; }), std::invalid_argument);
  CHECK_THROWS_AS(with([](world::Segment& s) { s.hitch = 0.13; }), std::invalid_argument);
  CHECK_THROWS_AS(with([](world::Segment& s) { s.hitch = -0.01; }), std::invalid_argument);
  CHECK_THROWS_AS(with([](world::Segment& s) { s.max_yaw_deg = 180.0; }), std::invalid_argument);
  CHECK_THROWS_AS(with([](world::Segment& s) { s.max_pitch_deg = 90.0; }), std::invalid_argument);
  CHECK_THROWS_AS(context.engine->segment(0, 0), std::out_of_range);
}
