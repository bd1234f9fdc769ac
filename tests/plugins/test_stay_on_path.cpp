#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "schemas.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// From (0, 0) to the east, and at (2, 0) to the north.
testing::Elements path_points() {
  return {{"point", {{"x", 0.0}, {"y", 0.0}}},
          {"point", {{"x", 2.0}, {"y", 0.0}}},
          {"point", {{"x", 2.0}, {"y", 2.0}}}};
}

Puppet path_robot(testing::Settings more = {}) {
  testing::Settings settings{{"width", 0.4}, {"off_path", 0.3}, {"on_path", 0.1}};
  more.merge(settings);
  return {"stay_on_path", more, path_points()};
}

}  // namespace

TEST_CASE("Off the path the vector leads to its middle with a given length, on it linearly less") {
  Puppet robot = path_robot();
  for (const double heading : {0.0, 100.0, -45.0}) {
    check_vector(robot.lead_at(1.0, 0.9, heading).velocity(), 0.0, -0.3);
    check_vector(robot.lead_at(1.0, -0.21, heading).velocity(), 0.0, 0.3);
    check_vector(robot.lead_at(1.0, 0.2, heading).velocity(), 0.0, -0.1);  // the edge
    check_vector(robot.lead_at(1.0, 0.05, heading).velocity(), 0.0, -0.025);
    check_vector(robot.lead_at(1.0, 0.0, heading).velocity(), 0.0, 0.0);
    check_vector(robot.lead_at(-0.3, 0.4, heading).velocity(), 0.3 * 0.6, -0.3 * 0.8);
  }
}

TEST_CASE("Its activation is that part of the length on the path, and 1 off it") {
  Puppet robot = path_robot();
  CHECK(robot.lead_at(1.0, 0.0, 0.0).ask().activation == Approx(0.0).margin(1e-12));
  CHECK(robot.lead_at(1.0, 0.05, 0.0).ask().activation == Approx(0.25));
  CHECK(robot.lead_at(1.0, 0.5, 0.0).ask().activation == 1.0);
}

TEST_CASE("A vector along the path follows its parts, and ends at its last point") {
  Puppet robot = path_robot({{"along", 0.2}});
  check_vector(robot.lead_at(1.0, 0.0, 30.0).velocity(), 0.2, 0.0);
  check_vector(robot.lead_at(2.0, 0.0, 30.0).velocity(), 0.0, 0.2);  // at the corner
  check_vector(robot.lead_at(2.0, 1.0, 30.0).velocity(), 0.0, 0.2);
  check_vector(robot.lead_at(2.0, 2.0, 30.0).velocity(), 0.0, 0.0);
  check_vector(robot.lead_at(2.0, 2.1, 30.0).velocity(), 0.0, -0.05);
}

TEST_CASE("It comes to the path in a straight line, and then exponentially nearer") {
  // From 0.5 m off: 0.3 m/s to the edge at 0.2 m, and d' = -0.3 d / 0.2 from there on.
  Puppet robot = path_robot({{"on_path", 0.3}});
  robot.lead_at(1.0, 0.5, 180.0);
  while (robot.time_s < 4.0) {
    robot.step(1e-3);
    const double expected =
        robot.time_s < 1.0 ? 0.5 - 0.3 * robot.time_s : 0.2 * std::exp(-1.5 * (robot.time_s - 1.0));
    REQUIRE(robot.lead().y == Approx(expected).margin(0.002));
    REQUIRE(robot.lead().x == Approx(1.0).margin(0.002));
  }
}

TEST_CASE("It keeps to the path to its end, within the way of a control period") {
  for (const double period : {1e-3, 0.01, 0.1}) {
    CAPTURE(period);
    Puppet robot = path_robot({{"along", 0.2}, {"on_path", 0.3}});
    robot.lead_at(0.0, 0.5, 180.0);
    double worst = 0.0;
    while (robot.time_s < 40.0) {
      robot.step(period);
      if (robot.time_s < 8.0) continue;  // 0.2 exp(-1.5 * 7) m, and what the turn at first cost
      const Vector2 at = robot.lead();
      // To the nearest point of the two parts.
      const double first = std::hypot(at.x - std::clamp(at.x, 0.0, 2.0), at.y);
      const double second = std::hypot(at.x - 2.0, at.y - std::clamp(at.y, 0.0, 2.0));
      worst = std::max(worst, std::min(first, second));
    }
    // At the corner, and at the end, it sees only after a period that it is past them.
    CHECK(worst <= 0.2 * period + 1e-4);
    check_vector(robot.lead(), 2.0, 2.0, 0.2 * period + 1e-4);
  }
}

TEST_CASE("A closed path leads round and round, over the corner at its first point, too") {
  Puppet robot("stay_on_path", {{"along", 0.3}, {"closed", true}}, path_points());
  robot.lead_at(0.0, 0.0, 0.0);
  int rounds = 0;
  bool was_far = false;
  while (robot.time_s < 90.0) {
    robot.step(0.01);
    const double away = std::hypot(robot.lead().x, robot.lead().y);
    was_far = was_far || away > 1.0;
    if (was_far && away < 0.2) {
      ++rounds;
      was_far = false;
    }
  }
  // A round is 2 + 2 + 2 sqrt(2) m.
  CHECK(rounds == 3);
}

TEST_CASE("A path of one point, or with a point twice in a row, is refused") {
  CHECK_THROWS_WITH(testing::Behavior("stay_on_path", {}, {{"point", {{"x", 1.0}}}}),
                    Catch::Contains("a path has two points or more"));
  testing::Elements twice = path_points();
  twice.insert(twice.begin() + 1, twice[1]);
  CHECK_THROWS_WITH(testing::Behavior("stay_on_path", {}, twice),
                    Catch::Contains("points 2 and 3 are the same place"));
  testing::Elements back = path_points();
  back.push_back(back[0]);
  CHECK_NOTHROW(testing::Behavior("stay_on_path", {}, back));
  CHECK_THROWS_WITH(testing::Behavior("stay_on_path", {{"closed", true}}, back),
                    Catch::Contains("points 4 and 1 are the same place"));
}

TEST_CASE("A robot passes the lane between the boxes, and not by the pull to the place alone") {
  CHECK(succeeds("lane"));
  CHECK_FALSE(succeeds("lane", {"robot[r1]/behavior[stay_on_path]/@priority=0"}));
  CHECK_FALSE(succeeds("lane", {"robot[r1]/behavior[move_to]/@priority=0"}));  // it is too slow
}
