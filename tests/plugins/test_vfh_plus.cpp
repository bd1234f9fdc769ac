// VFH+: what Ulrich and Borenstein (1998) say that it has over VFH.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/readings/lidar.h"
#include "elsie/testing/behavior.h"
#include "elsie/testing/expectation.h"
#include "elsie/testing/world.h"

#include "clutter.h"
#include "shipped.h"
#include "situation.h"

using namespace elsie;
using elsie::test::Situation;

namespace {

const testing::Plugins& vfh_plugins() {
  static const testing::Plugins plugins(plugin::Host(test::shipped_directory()));
  return plugins;
}

/// Discs as the robot at the origin, which looks east, sees them by 360 rays of 3 m.
struct VfhDisc {
  double x, y, radius = 0.05;
};
Situation vfh_sees(const std::vector<VfhDisc>& discs) {
  LidarReading scan;
  scan.max_range_m = 3.0;
  scan.first_rad = radians(179.5);
  scan.step_rad = radians(1.0);
  for (std::size_t i = 0; i < 360; ++i) {
    const double c = std::cos(scan.azimuth_rad(i)), s = std::sin(scan.azimuth_rad(i));
    double range = scan.max_range_m;
    for (const VfhDisc& disc : discs) {
      const double along = c * disc.x + s * disc.y, aside = c * disc.y - s * disc.x;
      const double half = disc.radius * disc.radius - aside * aside;
      if (along > 0.0 && half > 0.0) range = std::min(range, along - std::sqrt(half));
    }
    scan.ranges_m.push_back(range);
  }
  return Situation().reading(scan);
}
/// Discs side by side from one point to another.
void add_vfh_row(std::vector<VfhDisc>& discs, double x1, double y1, double x2, double y2) {
  const int count = static_cast<int>(std::hypot(x2 - x1, y2 - y1) / 0.05);
  for (int i = 0; i <= count; ++i) {
    const double part = static_cast<double>(i) / count;
    discs.push_back({x1 + part * (x2 - x1), y1 + part * (y2 - y1)});
  }
}

testing::Behavior vfh_to(double x, double y, testing::Settings settings = {}) {
  settings["x"] = x;
  settings["y"] = y;
  return {vfh_plugins(), "vfh_plus", settings};
}
/// The direction of its first answer, degrees to the left of the heading: the gain is 1.
double vfh_direction(const Situation& now, double x, double y, testing::Settings settings = {}) {
  settings["gain"] = 1.0;
  return degrees(vfh_to(x, y, settings).respond(now).command.turn);
}

}  // namespace

TEST_CASE("vfh_plus: where nothing is near it drives straight to the place, and stops there") {
  CHECK(vfh_direction(vfh_sees({}), 2, 1) == Approx(degrees(std::atan2(1, 2))));
  CHECK_THAT(vfh_to(2, 0).respond(vfh_sees({})), testing::commands({0.3, 0.0, 0.0}, 1e-9));
  CHECK_THAT(vfh_to(0.15, 0).respond(vfh_sees({})), testing::commands({0.15, 0.0, 0.0}, 1e-9));
  CHECK_THAT(vfh_to(0.04, 0).respond(vfh_sees({})),
             testing::stands() && testing::is_not_active() && testing::raises("arrived"));
}

TEST_CASE("vfh_plus: a sector is blocked nearer than range sqrt(1 - high)") {
  // A single beam straight ahead, and the place behind it.
  const double edge = std::sqrt(1.0 - 0.6);
  const auto direction = [](double away) {
    return std::abs(vfh_direction(Situation().beam(0, away, 3.0), 2.0, 0.0));
  };
  CHECK(direction(edge + 0.001) == Approx(0.0).margin(1e-9));
  CHECK(direction(edge - 0.001) > 5.0);
  // What is behind the place does not count: the robot's disc stops short of it.
  CHECK(vfh_direction(Situation().beam(0, 0.6, 3.0), 0.4, 0.0) == Approx(0.0).margin(1e-9));
}

TEST_CASE("vfh_plus: obstacles are enlarged by asin((radius + safety) / distance)") {
  // The nearest free direction to the left of a point straight ahead; openings of any width count.
  for (const double safety : {0.0, 0.05, 0.15, 0.3}) {
    for (const double away : {0.3, 0.45, 0.6}) {
      Situation now = Situation().beam(0, away, 3.0);
      const double radius = 0.5 * std::hypot(now.self.length_m, now.self.width_m) + safety;
      const double half = degrees(std::asin(std::min(1.0, radius / away)));
      const double direction = std::abs(
          vfh_direction(now, 2.0, 0.0, {{"safety", safety}, {"wide", 0.001}, {"sectors", 720}}));
      CAPTURE(safety, away);
      CHECK(direction == Approx(half).margin(1.0));  // two sectors of half a degree
    }
  }
}

TEST_CASE("vfh_plus: between the thresholds nothing changes, and with one threshold it trembles") {
  // The reading flickers about one distance. Hysteresis of the paper: blocked stays blocked, free
  // stays free.
  const auto changes = [](double low, double high) {
    testing::Behavior vfh = vfh_to(2, 0, {{"low", low}, {"high", high}});
    int changed = 0;
    double last = 0.0;
    for (int i = 0; i < 100; ++i) {
      const double away = std::sqrt(1.0 - 0.55) + (i % 2 == 0 ? 0.02 : -0.02);
      const double turn = vfh.respond(Situation().beam(0, away, 3.0).time(0.01 * i)).command.turn;
      changed += i > 0 && std::abs(turn - last) > 0.01;
      last = turn;
    }
    return changed;
  };
  CHECK(changes(0.5, 0.6) == 0);
  CHECK(changes(0.55, 0.55) > 20);

  testing::Behavior vfh = vfh_to(2, 0);
  const auto turns = [&](double away) {
    return std::abs(vfh.respond(Situation().beam(0, away, 3.0)).command.turn) > 0.01;
  };
  CHECK_FALSE(turns(0.67));  // between the distances of high, 0.632 m, and low, 0.707 m
  CHECK(turns(0.62));
  CHECK(turns(0.67));
  CHECK_FALSE(turns(0.71));
  CHECK_FALSE(turns(0.67));
  turns(0.62);
  vfh.reset();
  CHECK_FALSE(turns(0.67));
}

TEST_CASE("vfh_plus: of two openings the cost decides: the place, the heading, and the last one") {
  // A wall ahead with an opening at 30 degrees to the left and one at 50 degrees to the right.
  std::vector<VfhDisc> wall;
  for (double azimuth = -175; azimuth <= 175; azimuth += 4) {
    if (std::abs(azimuth - 30) < 20 || std::abs(azimuth + 50) < 20) continue;
    wall.push_back({0.5 * std::cos(radians(azimuth)), 0.5 * std::sin(radians(azimuth))});
  }
  const testing::Settings narrow{{"safety", 0.01}};
  const auto now = vfh_sees(wall);
  CHECK(vfh_direction(now, 2.0, 0.0, narrow) == Approx(30).margin(5));  // nearer to the place
  CHECK(vfh_direction(now, 1.0, -2.0, narrow) == Approx(-50).margin(5));
  // As far off from both, the heading decides; without its cost, the place.
  const double bearing = radians(-12.0);
  const double x = 2 * std::cos(bearing), y = 2 * std::sin(bearing);
  CHECK(vfh_direction(now, x, y, narrow) == Approx(30).margin(5));
  CHECK(vfh_direction(now, x, y, {{"safety", 0.01}, {"mu2", 0}, {"mu3", 0}}) ==
        Approx(-50).margin(5));
  // The last direction: it keeps the one that it has taken, although the other is cheaper now.
  for (const double mu3 : {0.0, 4.0}) {
    testing::Behavior vfh =
        vfh_to(1.0, -2.0, {{"safety", 0.01}, {"mu2", 0}, {"mu3", mu3}, {"gain", 1}});
    CHECK(degrees(vfh.respond(now).command.turn) == Approx(-50).margin(5));
    vfh.set({{"x", 2.0}, {"y", -0.2}});
    CHECK(degrees(vfh.respond(now).command.turn) == Approx(mu3 > 0 ? -50 : 30).margin(5));
  }
}

TEST_CASE("vfh_plus: a wide opening is passed at its side, a narrow one in its middle") {
  // Discs at 60 degrees and more to both sides of an opening to the left.
  const auto direction = [](double half_deg) {
    std::vector<VfhDisc> ring;
    for (double azimuth = 90 + half_deg; azimuth <= 450 - half_deg; azimuth += 4) {
      ring.push_back({0.5 * std::cos(radians(azimuth)), 0.5 * std::sin(radians(azimuth))});
    }
    return vfh_direction(vfh_sees(ring), 2.0, 0.0, {{"safety", 0.01}});
  };
  CHECK(direction(35) == Approx(90).margin(5));  // narrow: its middle
  CHECK(direction(90) < 70);                     // wide: half of 80 degrees from its right border
  CHECK(direction(90) > 30);
}

TEST_CASE("vfh_plus: what the turning circle cannot pass is masked, though VFH would enter") {
  // A wall along the robot's left with an opening to the left: a robot that turns on the spot
  // enters it, one with a large turning circle would hit the edge and drives on.
  std::vector<VfhDisc> discs;
  add_vfh_row(discs, 0.28, 0.35, 2.5, 0.35);
  add_vfh_row(discs, -2.5, 0.35, -0.28, 0.35);
  const Situation now = vfh_sees(discs);
  CHECK(vfh_direction(now, 0.0, 2.0) == Approx(90).margin(20));
  CHECK(std::abs(vfh_direction(now, 0.0, 2.0, {{"turning_radius", 0.4}})) < 45);
  // Its curves are never tighter than that, and it moves to turn.
  for (const double radius : {0.1, 0.4, 1.0}) {
    const Motion command = vfh_to(0.0, 2.0, {{"turning_radius", radius}}).respond(now).command;
    CHECK(command.forward > 0.0);
    CHECK(std::abs(command.turn) <= command.forward / radius + 1e-9);
  }
  // The same on the other side.
  for (VfhDisc& disc : discs) disc.y = -disc.y;
  CHECK(vfh_direction(vfh_sees(discs), 0.0, -2.0) == Approx(-90).margin(20));
  CHECK(std::abs(vfh_direction(vfh_sees(discs), 0.0, -2.0, {{"turning_radius", 0.4}})) < 45);
}

TEST_CASE("vfh_plus: where no direction is free it stands, and says so once") {
  std::vector<VfhDisc> ring;
  for (double azimuth = 0; azimuth < 360; azimuth += 4) {
    ring.push_back({0.4 * std::cos(radians(azimuth)), 0.4 * std::sin(radians(azimuth))});
  }
  testing::Behavior vfh = vfh_to(2, 0);
  CHECK_THAT(vfh.respond(vfh_sees(ring)), testing::stands() && testing::raises("blocked"));
  CHECK_THAT(vfh.respond(vfh_sees(ring)), testing::stands() && testing::raises_nothing());
  CHECK_THAT(vfh.respond(vfh_sees({})), testing::drives_forward() && testing::raises_nothing());
  CHECK_THAT(vfh.respond(vfh_sees(ring)), testing::raises("blocked"));
}

TEST_CASE("vfh_plus: a reading of zero, and a successor") {
  Situation touching = Situation().beam(0, 0.0, 3.0);
  CHECK(vfh_to(2, 0).respond(touching).command.is_finite());
  testing::Behavior before = vfh_to(2, 0), after = vfh_to(2, 0);
  before.respond(Situation().beam(0, 0.62, 3.0));
  REQUIRE(after.take_over(before));
  const Situation between = Situation().beam(0, 0.67, 3.0);
  CHECK(after.respond(between).command == before.respond(between).command);
  CHECK(std::abs(after.respond(between).command.turn) > 0.01);
}

namespace {

/// Ten discs and boxes between the robot and its place, with room for it between them.
std::string vfh_world(std::uint64_t seed, const std::string& physics) {
  return "<world format='1'><arena length='9' width='5'/><physics engine='planar' " + physics +
         "/><teams><team id='red'/></teams><obstacles>" + test::clutter(seed, 10, 0.45) +
         "</obstacles><robots><robot id='r1' team='red' x='-4' y='0'><sensors><lidar id='scan' "
         "x='0' rays='120' max_range='2'/></sensors><behaviors><vfh_plus x='4' y='0'/></behaviors>"
         "<coordinator><arbiter_suppression/></coordinator></robot></robots></world>";
}

}  // namespace

TEST_CASE("vfh_plus: it arrives through random clutter, and touches nothing") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    testing::World world = testing::World::from_text(vfh_world(seed, ""), {}, vfh_plugins());
    CAPTURE(seed);
    CHECK(world.run_until([](const testing::World& now) { return now.count("arrived") > 0; }, 100));
    CHECK(world.count("collision") == 0);
  }
}

TEST_CASE("vfh_plus: at any control period") {
  for (const std::string physics :
       {"step='0.001'", "step='0.01' control_steps='5'", "step='0.1'"}) {
    testing::World world = testing::World::from_text(vfh_world(3, physics), {}, vfh_plugins());
    CAPTURE(physics);
    CHECK(world.run_until([](const testing::World& now) { return now.count("arrived") > 0; }, 100));
    CHECK(world.count("collision") == 0);
  }
}

TEST_CASE("vfh_plus refuses what it cannot do") {
  CHECK_THROWS_WITH(vfh_to(2, 0).equip(Situation()), Catch::Contains("it needs a lidar"));
  CHECK_NOTHROW(vfh_to(2, 0).equip(Situation().beam(0, 1)));
  CHECK_NOTHROW(vfh_to(2, 0).equip(vfh_sees({})));
  CHECK_THROWS_WITH(vfh_to(2, 0, {{"low", 0.7}}), Catch::Contains("low must not be the larger"));
  CHECK_THROWS_WITH(vfh_to(2, 0, {{"sectors", 7}}), Catch::Contains("sectors"));
  CHECK(vfh_to(2, 0)->notes().empty());
  REQUIRE(vfh_to(2, 0, {{"mu2", 3}})->notes().size() == 1);
}
