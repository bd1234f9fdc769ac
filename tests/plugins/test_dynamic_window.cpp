// The dynamic window: what Fox, Burgard and Thrun (1997) claim of it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/testing/behavior.h"
#include "elsie/testing/expectation.h"
#include "elsie/testing/world.h"

#include "../../plugins/behaviors/dynamic_window/free_arc.h"
#include "clutter.h"
#include "shipped.h"
#include "situation.h"

using namespace elsie;
using elsie::test::Situation;

namespace {

const testing::Plugins& window_plugins() {
  static const testing::Plugins plugins(plugin::Host(test::shipped_directory()));
  return plugins;
}
testing::Behavior window_to(double x, double y, testing::Settings settings = {}) {
  settings["x"] = x;
  settings["y"] = y;
  return {window_plugins(), "dynamic_window", settings};
}
/// A robot at the origin that looks east and moves so, in a period of 0.1 s.
Situation window_moving(double forward, double turn = 0.0, double period_s = 0.1) {
  Situation now;
  now.period(period_s);
  now.self.commanded = {forward, 0.0, turn};
  return now;
}
/// The radius of the disc that it takes itself for, with the default margin.
double window_radius(double margin = 0.03) {
  const OwnState self;
  return 0.5 * std::hypot(self.length_m, self.width_m) + margin;
}

/// The same as free_arc(), by small steps; infinity after once round, or 10 m.
double stepped_window_arc(const Vector2& point, double curvature, double radius) {
  const double step = 1e-4;
  const double end =
      std::min(10.0, std::abs(curvature) > 0 ? 2 * std::numbers::pi / std::abs(curvature) : 10.0);
  for (double way = step; way < end; way += step) {
    const Pose at = after_arc({1.0, 0.0, curvature}, way);
    if (std::hypot(point.x - at.x, point.y - at.y) < radius) return way;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

TEST_CASE("dynamic_window: the free way of an arc, in closed form") {
  const double r = 0.1;
  CHECK(free_arc({1.0, 0.0}, 0.0, r) == Approx(0.9));
  CHECK(free_arc({1.0, 0.06}, 0.0, r) == Approx(1.0 - 0.08));
  CHECK(std::isinf(free_arc({1.0, 0.1}, 0.0, r)));
  CHECK(std::isinf(free_arc({-1.0, 0.0}, 0.0, r)));
  // On the arc itself: a quarter circle of 1 m, less the angle whose chord is the radius.
  const double chord = 2.0 * std::asin(0.5 * r);
  CHECK(free_arc({1.0, 1.0}, 1.0, r) == Approx(0.5 * std::numbers::pi - chord));
  CHECK(free_arc({1.0, -1.0}, -1.0, r) == Approx(0.5 * std::numbers::pi - chord));
  CHECK(std::isinf(free_arc({1.0, -1.0}, 1.0, r)));
  // Behind: nearly all around.
  CHECK(free_arc({-1.0, 1.0}, 1.0, r) == Approx(1.5 * std::numbers::pi - chord));
  // In the disc: towards it not at all, away from it nearly all around.
  CHECK(free_arc({0.05, 0.0}, 0.0, r) == 0.0);
  CHECK(std::isinf(free_arc({-0.05, 0.0}, 0.0, r)));
  CHECK(free_arc({0.05, 0.01}, 1.0, r) == 0.0);
  CHECK(free_arc({-0.05, 0.0}, 1.0, r) > 5.0);
  CHECK(free_arc({0.0, 0.0}, 0.0, r) >= 0.0);
}

TEST_CASE("dynamic_window: the free way of an arc is that of small steps") {
  Random random(1);
  int touched = 0;
  for (int i = 0; i < 800; ++i) {
    const double radius = random.uniform(0.02, 0.3);
    const Vector2 point{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
    const double curvature = i % 10 == 0 ? 0.0 : random.uniform(-2.0, 2.0);
    if (std::hypot(point.x, point.y) < radius + 0.001) continue;
    const double way = free_arc(point, curvature, radius);
    const double stepped = stepped_window_arc(point, curvature, radius);
    CAPTURE(point.x, point.y, curvature, radius);
    if (std::isinf(stepped)) {
      // Grazing by less than the steps see is possible; it is at most a touch.
      CHECK((std::isinf(way) || std::isinf(stepped_window_arc(point, curvature, radius - 1e-3))));
    } else {
      CHECK(way == Approx(stepped).margin(5e-3));
      ++touched;
    }
  }
  CHECK(touched > 50);
}

TEST_CASE("dynamic_window: it speeds up to the place, and no faster than its accelerations") {
  for (const double period : {0.001, 0.01, 0.05, 0.1}) {
    CAPTURE(period);
    const Motion first = window_to(5, 0).respond(window_moving(0, 0, period).beam(0, 3, 3)).command;
    CHECK(first.forward == Approx(0.5 * period));
    CHECK(first.turn == Approx(0.0).margin(1e-9));
    const Motion left = window_to(0, 5).respond(window_moving(0, 0, period).beam(0, 3, 3)).command;
    CHECK(left.turn > 0.0);
    CHECK(left.turn <= 4.0 * period + 1e-12);
    const Motion right =
        window_to(0, -5).respond(window_moving(0, 0, period).beam(0, 3, 3)).command;
    CHECK(right.turn == Approx(-left.turn));
  }
  CHECK(window_to(5, 0).respond(window_moving(0.4).beam(0, 3, 3)).command.forward == Approx(0.4));
  CHECK_THAT(window_to(0.04, 0).respond(window_moving(0).beam(0, 3, 3)),
             testing::stands() && testing::is_not_active() && testing::raises("arrived"));
}

TEST_CASE("dynamic_window: no command from which it cannot stop, if there is any other") {
  const double a = 0.5, turn_a = 4.0, margin = 0.03;
  Random random(2);
  int stoppable = 0, braked = 0;
  for (int i = 0; i < 2000; ++i) {
    const double period = std::pow(10.0, random.uniform(-3, -1));
    Situation now = window_moving(random.uniform(0, 0.4), random.uniform(-2, 2), period);
    std::vector<Vector2> points;
    for (double azimuth = -180; azimuth < 180; azimuth += 15) {
      const double away = random.uniform(0.0, 2.0);
      now.beam(azimuth, away, 1.9);
      if (away < 1.9) {
        points.push_back({away * std::cos(radians(azimuth)), away * std::sin(radians(azimuth))});
      }
    }
    const auto free_way = [&](const Motion& motion) {
      double free = 1.5;
      for (const Vector2& point : points) {
        // Of what is within the margin already, 0.9 of its distance.
        const double radius =
            std::min(window_radius(margin),
                     std::max(window_radius(0.0), 0.9 * std::hypot(point.x, point.y)));
        free = std::min(free, free_arc(point, motion.turn / motion.forward, radius));
      }
      return free;
    };
    // On its arc it drives for a period, and then brakes: v T + v^2 / 2a, and as far as it takes to
    // stop the turn.
    const auto can_stop = [&](const Motion& motion, double slack_m) {
      const double v = motion.forward, w = std::abs(motion.turn);
      const double stops = v * period + std::max(v * v / (2.0 * a), v * w / (2.0 * turn_a));
      return v < 1e-6 || stops <= free_way(motion) + slack_m;
    };
    const Motion from = now.self.commanded;
    const double x = random.uniform(-3, 3), y = random.uniform(-3, 3);
    const Motion command = window_to(x, y).respond(now).command;
    CAPTURE(i, period, from.forward, from.turn, command.forward, command.turn);
    REQUIRE(std::abs(command.forward - from.forward) <= a * period + 1e-9);
    REQUIRE(std::abs(command.turn - from.turn) <= turn_a * period + 1e-9);
    if (can_stop(command, 1e-9)) {
      ++stoppable;
      continue;
    }
    ++braked;
    // It could stop from none of those that it compares, and brakes on the arc of the last command,
    // or on the one of them that is free farther than that.
    const double slowest = from.forward - a * period;
    const double part =
        std::max({0.0, slowest / from.forward, 1.0 - turn_a * period / std::abs(from.turn)});
    const double wanted = 0.4 * std::min(1.0, std::hypot(x, y) / 0.3);
    const double fastest = std::max(slowest, std::min(wanted, from.forward + a * period));
    const double right = std::max(-2.0, from.turn - turn_a * period);
    const double left = std::min(2.0, from.turn + turn_a * period);
    double farthest = free_way(part * from);
    for (int w = 0; w < 11; ++w) {
      const double turn = right + (left - right) * w / 10;
      for (int v = 0; v < 5; ++v) {
        REQUIRE_FALSE(can_stop({slowest + (fastest - slowest) * v / 4, 0.0, turn}, -1e-9));
      }
      farthest = std::max(farthest, free_way({slowest, 0.0, turn}));
    }
    const bool is_slowest = std::abs(command.forward - slowest) < 1e-9;
    REQUIRE((is_slowest || std::abs(command.forward - part * from.forward) < 1e-9));
    REQUIRE(free_way(command) == Approx(farthest).margin(1e-9));
  }
  CHECK(stoppable > 1000);
  CHECK(braked > 20);
}

TEST_CASE("dynamic_window: a robot that moves as it is told touches nothing") {
  Random random(3);
  for (int run = 0; run < 40; ++run) {
    const double period = std::pow(10.0, random.uniform(-2, -1));
    std::vector<Vector2> points;
    while (points.size() < 40) {
      const Vector2 point{random.uniform(-2, 2), random.uniform(-2, 2)};
      if (std::hypot(point.x, point.y) > 0.3) points.push_back(point);
    }
    testing::Behavior window = window_to(3, 0, {{"speed", 0.2 + 0.2 * (run % 4)}});
    Pose pose;
    Motion command;
    for (int step = 0; step < 400; ++step) {
      Situation now = window_moving(command.forward, command.turn, period);
      now.at(pose.x, pose.y, degrees(pose.heading_rad));
      for (const Vector2& point : points) {
        const double away = std::hypot(point.x - pose.x, point.y - pose.y);
        CAPTURE(run, step, away);
        REQUIRE(away >= window_radius(0.0) - 1e-9);
        now.beam(degrees(bearing(pose, point.x, point.y)), away, 10.0);
      }
      command = window.respond(now).command;
      const Pose moved = after_arc(command, period);
      const Vector2 place = point_of(pose, {moved.x, moved.y});
      pose = {place.x, place.y, wrap_angle(pose.heading_rad + moved.heading_rad)};
    }
  }
}

TEST_CASE("dynamic_window: it brakes from sqrt(2 dist a) on") {
  // It can only go straight: without turns, to a place behind the obstacle.
  const testing::Settings straight{
      {"turn_rate", 1e-6}, {"turn_acceleration", 1e-6}, {"interval", 0.0}};
  for (const double v : {0.1, 0.2, 0.3, 0.4}) {
    const double period = 0.01;
    const double stops = v * v / (2.0 * 0.5) + v * period;  // and the way of this period
    const auto command = [&](double free) {
      Situation now = window_moving(v, 0.0, period).beam(0, free + window_radius(), 3.0);
      return window_to(5, 0, straight).respond(now).command.forward;
    };
    CAPTURE(v);
    CHECK(command(stops + 0.01) >= v - 1e-9);
    CHECK(command(stops - 0.005) == Approx(v - 0.5 * period).margin(1e-9));
  }
}

TEST_CASE("dynamic_window: the three terms of the objective") {
  const auto command = [](double alpha, double beta, double gamma, const Situation& now) {
    return window_to(3, 3, {{"alpha", alpha}, {"beta", beta}, {"gamma", gamma}, {"interval", 0.1}})
        .respond(now)
        .command;
  };
  const Situation clear = window_moving(0.2, 0.0).beam(0, 3, 3);
  CHECK(command(1, 0, 0, clear).turn == Approx(0.4));  // heading: to the place
  CHECK(command(0, 0, 1, clear).forward == Approx(0.25));
  // Clearance: away from what is ahead on the right, though the place may be anywhere.
  Situation blocked = window_moving(0.2, 0.0);
  for (int azimuth = -60; azimuth <= 4; azimuth += 2) blocked.beam(azimuth, 0.4, 3.0);
  CHECK(command(0, 1, 0, blocked).turn > 0.0);
  Situation mirrored = window_moving(0.2, 0.0);
  for (int azimuth = -4; azimuth <= 60; azimuth += 2) mirrored.beam(azimuth, 0.4, 3.0);
  CHECK(command(0, 1, 0, mirrored).turn < 0.0);
}

TEST_CASE("dynamic_window: sensors that touch something, and a place behind") {
  CHECK(window_to(5, 0).respond(window_moving(0.4).beam(0, 0.0, 3.0)).command.is_finite());
  CHECK(window_to(5, 0).respond(window_moving(-0.4).beam(0, 0.1, 3.0)).command.is_finite());
  CHECK_THAT(window_to(-5, 0.1).respond(window_moving(0).beam(0, 3, 3)), testing::turns_left());
}

namespace {

std::string window_world(const std::string& obstacles, const std::string& robot,
                         const std::string& behavior, const std::string& physics = "") {
  return "<world format='1'><arena length='9' width='5'/><physics engine='planar' " + physics +
         "/><teams><team id='red'/></teams><obstacles>" + obstacles +
         "</obstacles><robots><robot id='r1' team='red' " + robot +
         "<sensors><lidar id='scan' x='0' rays='180' max_range='3'/></sensors><behaviors>" +
         behavior +
         "</behaviors><coordinator><arbiter_suppression/></coordinator></robot></robots>" +
         "</world>";
}
constexpr std::size_t kWindowClutter = 14;
constexpr double kWindowRoom = 0.35;  // m
bool window_arrived(const testing::World& now) { return now.count("arrived") > 0; }

constexpr const char* kWindowStart = "x='-4' y='0' max_speed='1'>";

}  // namespace

TEST_CASE("dynamic_window: it never collides in random clutter, whatever its speed") {
  int arrived = 0, without = 0;
  const int seeds = 40;
  for (int seed = 1; seed <= seeds; ++seed) {
    const std::string clutter =
        test::clutter(static_cast<std::uint64_t>(seed), kWindowClutter, kWindowRoom);
    const double speed = 0.2 + 0.2 * (seed % 4), acceleration = seed % 3 == 0 ? 0.3 : 1.0;
    testing::World world = testing::World::from_text(
        window_world(clutter, kWindowStart,
                     "<dynamic_window x='4' y='0' speed='" + std::to_string(speed) +
                         "' acceleration='" + std::to_string(acceleration) + "'/>"),
        {}, window_plugins());
    arrived += world.run_until(window_arrived, 90);
    CAPTURE(seed, speed, acceleration);
    CHECK(world.count("collision") == 0);
    testing::World straight = testing::World::from_text(
        window_world(clutter, kWindowStart, "<go_to_point x='4' y='0'/>"), {}, window_plugins());
    straight.run_until(window_arrived, 30);
    without += straight.count("collision") > 0;
  }
  CHECK(arrived >= seeds - 1);  // it may stop at a local maximum of the objective
  CHECK(without >= seeds / 2);  // these worlds are not empty
}

TEST_CASE("dynamic_window: it does not graze what it sees only in part") {
  // A robot that brakes slowly passes obstacles by the margin. In the next period its rays hit
  // other points, and the arc leads into the margin, nearer than it could stop.
  struct Case {
    std::uint64_t clutter;
    double speed;
  };
  for (const Case& each : {Case{43, 0.4}, Case{70, 0.4}, Case{41, 0.8}, Case{10, 0.8}}) {
    testing::World world = testing::World::from_text(
        window_world(test::clutter(each.clutter, kWindowClutter, kWindowRoom),
                     std::string(kWindowStart) + "<body mass='2'/>",
                     "<dynamic_window x='4' y='0' acceleration='0.2' speed='" +
                         std::to_string(each.speed) + "'/>"),
        {}, window_plugins());
    world.run_until(window_arrived, 60);
    CAPTURE(each.clutter, each.speed);
    CHECK(world.count("collision") == 0);
  }
}

TEST_CASE("dynamic_window: motors that are weak must be known to be so") {
  // A heavy robot, whose motors brake by less than 0.5 m/s2, drives straight at a wall: its place
  // is behind that.
  const auto collisions = [&](const std::string& acceleration) {
    testing::World world = testing::World::from_text(
        window_world("<static_box x='2' y='0' length='0.1' width='5'/>",
                     "x='-4' y='0' max_speed='1'><body mass='2' wheel_torque='0.01'/>",
                     "<dynamic_window x='4' y='0' speed='0.9' turn_rate='0.001' acceleration='" +
                         acceleration + "'/>"),
        {}, window_plugins());
    world.run_for(30.0);
    CHECK(world.pose("r1").x > 1.5);
    return world.count("collision");
  };
  CHECK(collisions("0.1") == 0);
  CHECK(collisions("0.4") == 0);
  CHECK(collisions("2") > 0);
}

TEST_CASE("dynamic_window: it slows down before a narrow gap, and not before a wide one") {
  const auto slowest = [](double gap) {
    const double length = 2.5 - 0.5 * gap, middle = 0.5 * gap + 0.5 * length;
    const std::string wall = "<static_box x='0' y='" + std::to_string(middle) +
                             "' length='0.1' width='" + std::to_string(length) +
                             "'/><static_box x='0' y='" + std::to_string(-middle) +
                             "' length='0.1' width='" + std::to_string(length) + "'/>";
    testing::World world = testing::World::from_text(
        window_world(wall, "x='-2' y='0.4'>",
                     "<dynamic_window x='3' y='0' speed='0.5' acceleration='0.2'/>"),
        {}, window_plugins());
    double least = 1.0;
    world.run_until(
        [&](const testing::World& now) {
          const Pose pose = now.pose("r1");
          if (pose.x > -1.0 && pose.x < 0.1) {
            least = std::min(least, now.robot("r1").command.forward);
          }
          return window_arrived(now);
        },
        60);
    CHECK(world.count("collision") == 0);
    CHECK(world.count("arrived") == 1);
    return least;
  };
  const double wide = slowest(2.5), narrow = slowest(0.25);
  CAPTURE(wide, narrow);
  CHECK(wide > 0.45);
  CHECK(narrow < 0.35);
}

TEST_CASE("dynamic_window: at any control period") {
  for (const std::string physics :
       {"step='0.001'", "step='0.01' control_steps='5'", "step='0.1'"}) {
    testing::World world = testing::World::from_text(
        window_world(test::clutter(5, kWindowClutter, kWindowRoom), kWindowStart,
                     "<dynamic_window x='4' y='0'/>", physics),
        {}, window_plugins());
    CAPTURE(physics);
    CHECK(world.run_until(window_arrived, 90));
    CHECK(world.count("collision") == 0);
  }
}

TEST_CASE("dynamic_window refuses what it cannot do") {
  CHECK_THROWS_WITH(window_to(2, 0).equip(Situation()), Catch::Contains("it needs a lidar"));
  CHECK_NOTHROW(window_to(2, 0).equip(Situation().beam(0, 1)));
  CHECK_THROWS_WITH(window_to(2, 0, {{"acceleration", 0.0}}), Catch::Contains("acceleration"));
  CHECK_THROWS_WITH(window_to(2, 0, {{"speeds", 1}}), Catch::Contains("speeds"));
}
