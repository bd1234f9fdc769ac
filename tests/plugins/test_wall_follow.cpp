#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "elsie/readings/lidar.h"

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using elsie::test::Situation;

namespace {

plugin::Object<Behavior> wall_follow(test::Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "wall_follow", std::move(parameters));
}

/// Beams of 2 m ahead and to both sides that see an endless wall at this distance in this
/// direction.
Situation beside(double distance_m, double direction_deg) {
  Situation now;
  for (const double azimuth : {90, 50, 0, -50, -90}) {
    const double towards = std::cos(radians(azimuth - direction_deg));
    now.beam(azimuth, towards > 1e-9 ? std::min(2.0, distance_m / towards) : 2.0, 2.0);
  }
  return now;
}
/// Beams in the same directions with given readings.
Situation seeing(double left, double front_left, double ahead, double front_right, double right) {
  Situation now;
  now.beam(90, left, 2).beam(50, front_left, 2).beam(0, ahead, 2);
  return now.beam(-50, front_right, 2).beam(-90, right, 2);
}
Situation nothing() { return seeing(2, 2, 2, 2, 2); }

Motion answer(Situation now, test::Parameters parameters = {}) {
  return wall_follow(std::move(parameters))->respond(now.perception()).command;
}
void check_motion(const Motion& motion, double forward, double turn) {
  CHECK(motion.forward == Approx(forward).margin(1e-9));
  CHECK(motion.turn == Approx(turn).margin(1e-9));
}

}  // namespace

TEST_CASE("Next to the wall, at the distance, it drives straight on") {
  check_motion(answer(beside(0.3, -90)), 0.2, 0);
  check_motion(answer(beside(0.3, 90), {{"side", "left"}}), 0.2, 0);
}

TEST_CASE("Too far away it steers towards the wall, too near away from it, as pure pursuit does") {
  // The point to reach is 0.3 m ahead and 0.1 m to the side: a circle of curvature 2 y / (x2 + y2).
  check_motion(answer(beside(0.4, -90)), 0.2, -0.2 * 2 * 0.1 / 0.1);
  check_motion(answer(beside(0.2, -90)), 0.2, 0.2 * 2 * 0.1 / 0.1);
  check_motion(answer(beside(0.4, 90), {{"side", "left"}}), 0.2, 0.2 * 2 * 0.1 / 0.1);
  check_motion(answer(beside(0.4, -90), {{"lookahead", 0.4}}), 0.2, -0.2 * 2 * 0.1 / 0.17);
}

TEST_CASE("It turns along a wall that it heads for or away from") {
  const double turn = 0.2 * 2 * std::sin(radians(20)) / 0.3;
  check_motion(answer(beside(0.3, -70)), 0.2, turn);
  check_motion(answer(beside(0.3, -110)), 0.2, -turn);
  check_motion(answer(beside(0.3, 70), {{"side", "left"}}), 0.2, -turn);
}

TEST_CASE("Where the turn would be faster than it may, it slows down") {
  const Motion slow = answer(beside(0.4, -90), {{"turn_rate", 0.1}});
  CHECK(slow.turn == Approx(-0.1));
  CHECK(slow.forward / slow.turn == Approx(0.2 / -0.4));
}

TEST_CASE("It ignores what is on its other side") {
  check_motion(answer(beside(0.2, 90)), 0.2, 0);
  check_motion(answer(beside(0.2, -90), {{"side", "left"}}), 0.2, 0);
  CHECK(wall_follow()->respond(beside(0.2, 90).perception()).activation == 0.0);
}

TEST_CASE("Something nearer ahead than the distance makes it turn away from the wall's side") {
  check_motion(answer(seeing(2, 2, 0.3, 2, 0.3)), 0.2, 0);
  check_motion(answer(seeing(2, 2, std::nextafter(0.3, 0.0), 2, 0.3)), 0, 1.5);
  check_motion(answer(seeing(0.3, 2, 0.29, 2, 2), {{"side", "left"}}), 0, -1.5);
  check_motion(answer(seeing(2, 2, 0.29, 2, 2)), 0, 1.5);  // a wall straight ahead
}

TEST_CASE("It drives on once the way is clear by a fifth more") {
  const auto behavior = wall_follow();
  const auto ahead = [&](double distance_m) {
    return behavior->respond(seeing(2, 2, distance_m, 2, 0.3).perception()).command;
  };
  check_motion(ahead(0.31), 0.2, 0);
  check_motion(ahead(0.29), 0, 1.5);
  check_motion(ahead(0.359), 0, 1.5);
  check_motion(ahead(0.361), 0.2, 0);
  check_motion(ahead(0.31), 0.2, 0);
}

TEST_CASE("Beams look ahead up to the front angle, and to the side beyond") {
  const auto at = [](double azimuth_deg, test::Parameters parameters = {}) {
    Situation now;
    now.beam(azimuth_deg, 0.25);
    return answer(std::move(now), std::move(parameters));
  };
  check_motion(at(30), 0, 1.5);
  check_motion(at(-30), 0, 1.5);
  check_motion(at(31), 0.2, 0);  // to the left, where no wall is expected
  CHECK(at(-31).turn > 0.0);
  CHECK(at(-31).forward > 0.0);  // the wall, too near
  check_motion(at(31, {{"front_angle", 31.0}}), 0, 1.5);
  CHECK(at(-150).turn < 0.0);  // around the corner that it has passed
  check_motion(at(-151), 0.2, 0);
}

TEST_CASE("What is farther than the reach is no wall") {
  const auto activation = [](double distance_m) {
    return wall_follow()->respond(seeing(2, 2, 2, 2, distance_m).perception()).activation;
  };
  CHECK(activation(0.75) > 0.0);
  CHECK(activation(0.7501) == 0.0);
}

TEST_CASE("A single point is taken for a wall across the line of sight") {
  const auto turn = [](double azimuth_deg, double distance_m) {
    return answer(Situation().beam(0, 2, 2).beam(azimuth_deg, distance_m, 2)).turn;
  };
  CHECK(turn(-90, 0.3) == Approx(0.0).margin(1e-9));
  CHECK(turn(-60, 0.3) == Approx(0.2 * 2 * std::sin(radians(30)) / 0.3));
  CHECK(turn(-120, 0.3) == Approx(-0.2 * 2 * std::sin(radians(30)) / 0.3));
}

TEST_CASE("A wall once found is kept up to a fifth more than the reach, but not found there") {
  const auto behavior = wall_follow();
  const auto activation = [&](double distance_m) {
    return behavior->respond(seeing(2, 2, 2, 2, distance_m).perception()).activation;
  };
  CHECK(activation(0.89) == 0.0);
  CHECK(activation(0.74) > 0.0);
  CHECK(activation(0.89) > 0.0);
  CHECK(activation(0.91) == 0.0);
  CHECK(activation(0.89) == 0.0);
}

TEST_CASE("A wall that it was still approaching is lost when it goes out of sight") {
  const auto after = [](double distance_m) {
    const auto behavior = wall_follow();
    behavior->respond(beside(distance_m, -90).perception());
    return behavior->respond(nothing().perception());
  };
  CHECK(after(0.52).activation == 1.0);  // half-way between distance and reach: a corner
  const Response lost = after(0.53);
  CHECK(lost.activation == 0.0);
  REQUIRE(lost.events.size() == 1);
  CHECK(lost.events[0].name == "wall_lost");
}

TEST_CASE("Two points too far apart are not taken for one wall") {
  // A near edge at the side, and the wall of the next room beyond it.
  const auto turn = [](double reach_m) {
    return answer(Situation().beam(0, 2, 2).beam(-40, 0.74, 2).beam(-140, 0.3, 2),
                  {{"reach", reach_m}})
        .turn;
  };
  CHECK(turn(0.75) == Approx(-0.2 * 2 * std::sin(radians(50)) / 0.3));  // the near edge alone
  CHECK(turn(0.9) == Approx(-0.26761).epsilon(1e-4));  // both as one wall: computed by hand
}

TEST_CASE("The order of the sensors does not matter") {
  Situation other;
  other.beam(-90, 0.35, 2).beam(0, 2, 2).beam(-50, 0.45, 2);
  const Motion same = answer(seeing(2, 2, 2, 0.45, 0.35));
  check_motion(answer(std::move(other)), same.forward, same.turn);
}

TEST_CASE("Where the wall ends it goes round the corner, and after three quarters has lost it") {
  for (const double side : {-1.0, 1.0}) {
    const auto behavior = wall_follow({{"side", side < 0 ? "right" : "left"}});
    behavior->respond(beside(0.3, side * 90).perception());
    Situation now = nothing();
    double heading_deg = 170.0;  // and over the seam at 180
    int steps = 0;
    for (; steps < 400; ++steps) {
      now.self.pose.heading_rad = wrap_angle(radians(heading_deg));
      const Response response = behavior->respond(now.perception());
      if (response.activation == 0.0) {
        REQUIRE(response.events.size() == 1);
        CHECK(response.events[0].name == "wall_lost");
        check_motion(response.command, 0.2, 0);
        break;
      }
      CHECK(response.activation == 1.0);
      CHECK(response.events.empty());
      check_motion(response.command, 0.2, side * 0.2 / 0.3);
      heading_deg += side;
    }
    CHECK(steps == Approx(270).margin(1));
  }
}

TEST_CASE("A wall that it finds again on its way round is followed on") {
  const auto behavior = wall_follow();
  behavior->respond(beside(0.3, -90).perception());
  behavior->respond(nothing().perception());
  const Response again = behavior->respond(beside(0.3, -90).perception());
  check_motion(again.command, 0.2, 0);
  CHECK(again.events.empty());
}

TEST_CASE("Without a wall it drives straight on and is not active; finding one raises an event") {
  const auto behavior = wall_follow();
  const Response searching = behavior->respond(nothing().perception());
  check_motion(searching.command, 0.2, 0);
  CHECK(searching.activation == 0.0);
  CHECK(searching.strength == 0.0);
  CHECK(searching.events.empty());
  const Response found = behavior->respond(beside(0.3, -90).perception());
  REQUIRE(found.events.size() == 1);
  CHECK(found.events[0].name == "wall_found");
}

TEST_CASE("The farther off the distance, the higher the activation") {
  const auto activation = [](double distance_m) {
    return wall_follow()->respond(beside(distance_m, -90).perception()).activation;
  };
  CHECK(activation(0.3) == Approx(0.5));
  CHECK(activation(0.15) == Approx(0.75));
  CHECK(activation(0.45) == Approx(0.75));
  CHECK(activation(0.02) == Approx(0.5 + 0.5 * 0.28 / 0.3));
  CHECK(activation(0.7) == Approx(1.0));
}

TEST_CASE("After a reset, and when others drove meanwhile, no wall is remembered") {
  const auto behavior = wall_follow();
  behavior->respond(beside(0.3, -90).perception());
  Random random;
  behavior->reset(random);
  CHECK(behavior->respond(nothing().perception()).activation == 0.0);
  behavior->respond(beside(0.3, -90).perception());
  CHECK(behavior->respond(nothing().time(0.5).perception()).activation == 1.0);
  CHECK(behavior->respond(nothing().time(1.01).perception()).activation == 0.0);
}

TEST_CASE("It sees the same wall by a lidar") {
  const auto by_lidar = [](double distance_m, double direction_deg) {
    LidarReading scan;
    scan.max_range_m = 2.0;
    scan.first_rad = radians(150);
    scan.step_rad = radians(1);
    for (int ray = 0; ray <= 300; ++ray) {
      const double towards = std::cos(radians(150.0 - ray - direction_deg));
      scan.ranges_m.push_back(towards > 1e-9 ? std::min(2.0, distance_m / towards) : 2.0);
    }
    Situation now;
    now.reading(scan);
    return now;
  };
  for (const double direction : {-110.0, -90.0, -75.0}) {
    for (const double distance : {0.28, 0.3, 0.35}) {  // where the beams see two points
      CAPTURE(direction, distance);
      const Motion expected = answer(beside(distance, direction));
      check_motion(answer(by_lidar(distance, direction)), expected.forward, expected.turn);
    }
  }
  check_motion(answer(by_lidar(0.4, 90), {{"side", "left"}}), 0.2, 0.2 * 2 * 0.1 / 0.1);
  check_motion(answer(by_lidar(0.29, 0)), 0, 1.5);
  CHECK_NOTHROW(wall_follow()->equipped(by_lidar(2.0, 0).perception()));
}

TEST_CASE("The floor is no wall, and the sensors of segments see none") {
  const auto activation = [](const Mounting& mounting) {
    return wall_follow()
        ->respond(Situation().reading(RangeReading{0.3, 1.0, true}, mounting).perception())
        .activation;
  };
  const double aside = radians(-90);
  CHECK(activation({{0, 0, 0.1}, aside, 0.0}) > 0.0);
  CHECK(activation({{0, 0, 0.1}, aside, radians(-10)}) > 0.0);  // 5 cm above the floor
  CHECK(activation({{0, 0, 0.1}, aside, radians(-20)}) == 0.0);
  CHECK(activation({{0, 0, 0.1}, aside, 0.0, 1}) == 0.0);
}

TEST_CASE("wall_follow refuses what it cannot do") {
  CHECK_THROWS_WITH(wall_follow({{"reach", 0.3}}),
                    Catch::Contains("reach is 0.3 m and distance 0.3 m"));
  const auto equip = [](Situation now, test::Parameters parameters = {}) {
    wall_follow(std::move(parameters))->equipped(now.perception());
  };
  CHECK_NOTHROW(equip(nothing()));
  CHECK_THROWS_WITH(equip(nothing(), {{"distance", 0.05}}), Catch::Contains("corners"));
  CHECK_THROWS_WITH(equip(Situation().beam(0, 1).beam(90, 1)),
                    Catch::Contains("to the right (-30 to -150), and the robot has none of the "
                                    "second"));
  CHECK_THROWS_WITH(equip(Situation().beam(-90, 1)), Catch::Contains("none of the first"));
  CHECK_THROWS_WITH(equip(Situation().beam(180, 1), {{"side", "left"}}),
                    Catch::Contains("to the left (30 to 150), and the robot has none of either"));
}
