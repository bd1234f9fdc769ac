#include <cmath>

#include <catch2/catch.hpp>

#include "schemas.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// A dock at the origin that is approached to the east, from the west.
Puppet docking_robot(testing::Settings more = {}) {
  testing::Settings settings{
      {"speed", 0.3}, {"controlled", 0.6}, {"coercive", 0.5}, {"cone_deg", 30.0}};
  more.merge(settings);
  return {"dock", more};
}

}  // namespace

TEST_CASE("Far from the dock it pulls there, with full length, and linearly less when controlled") {
  Puppet robot = docking_robot();
  check_vector(robot.lead_at(2.0, 0.0, 20.0).velocity(), -0.3, 0.0);
  check_vector(robot.lead_at(0.0, -0.9, 20.0).velocity(), 0.0, 0.3);
  check_vector(robot.lead_at(0.55, 0.0, 20.0).velocity(), -0.3 * 0.55 / 0.6, 0.0);
}

TEST_CASE("The coercive zone leads around the dock on the shorter way, at the same distance") {
  Puppet robot = docking_robot();
  const double length = 0.3 * 0.4 / 0.6;
  check_vector(robot.lead_at(0.0, 0.4, 0.0).velocity(), -length, 0.0);
  check_vector(robot.lead_at(0.0, -0.4, 0.0).velocity(), -length, 0.0);
  check_vector(robot.lead_at(0.4, 1e-6, 0.0).velocity(), 0.0, length, 1e-6);
  check_vector(robot.lead_at(0.4, -1e-6, 0.0).velocity(), 0.0, -length, 1e-6);
  // Exactly behind the dock it takes one of the two.
  CHECK(std::abs(robot.lead_at(0.4, 0.0, 0.0).velocity().y) == Approx(length));
  // It comes to the cone at the distance at which it began.
  robot.lead_at(0.4, 0.01, 90.0);
  while (std::atan2(std::abs(robot.lead().y), -robot.lead().x) > radians(30.5)) {
    robot.step(0.001);
    REQUIRE(robot.time_s < 60.0);
    CHECK(std::hypot(robot.lead().x, robot.lead().y) == Approx(0.4).margin(0.005));
  }
}

TEST_CASE("In the guiding zone its way is left = c before^guidance, tangent to the axis") {
  for (const double guidance : {1.0, 2.0, 3.0}) {
    Puppet robot = docking_robot({{"guidance", guidance}});
    robot.lead_at(-0.4, 0.15, 0.0);
    const double c = 0.15 / std::pow(0.4, guidance);
    while (robot.lead().x < -0.1) {
      robot.step(0.001);
      REQUIRE(robot.time_s < 60.0);
      CHECK(robot.lead().y == Approx(c * std::pow(-robot.lead().x, guidance)).margin(1e-3));
    }
  }
}

TEST_CASE("From all around it docks in the direction of the approach, with any control period") {
  for (const double period : {1e-3, 0.01, 0.1}) {
    for (double from = 0.0; from < 360.0; from += 60.0) {
      Puppet robot = docking_robot({{"approach_deg", 90.0}, {"tolerance", 0.03}});
      robot.at(1.5 * std::cos(radians(from)), 1.5 * std::sin(radians(from)), 17.0);
      int docked = 0;
      while (docked == 0 && robot.time_s < 60.0) {
        docked += static_cast<int>(robot.step(period).events.size());
      }
      CHECK(docked == 1);
      CHECK(std::abs(degrees(robot.heading_rad) - 90.0) < 25.0);
      CHECK(robot.y < 0.0);  // on the side of the approach
      CHECK(robot.ask().activation == 0.0);
      CHECK(robot.ask().events.empty());
    }
  }
}

TEST_CASE("Docking refuses zones that contradict each other") {
  CHECK_THROWS_WITH(testing::Behavior("dock", {{"coercive", 0.7}, {"controlled", 0.6}}),
                    Catch::Contains("coercive must not be the larger one"));
  CHECK_THROWS_WITH(testing::Behavior("dock", {{"tolerance", 0.5}}),
                    Catch::Contains("tolerance must be the smaller one"));
  CHECK_THROWS_WITH(testing::Behavior("dock", {{"cone_deg", 90.0}}), Catch::Contains("cone_deg"));
}

TEST_CASE("A bay is entered by its open side, which a pull to the dock alone does not find") {
  CHECK(succeeds("docking"));
  CHECK_FALSE(succeeds("docking", {"robot[r1]/behavior[dock]=<move_to id=\"dock\" x=\"1\"/>",
                                   "goal[2]/@name=arrived"}));
}
