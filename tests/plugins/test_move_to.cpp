#include <cmath>

#include <catch2/catch.hpp>

#include "schemas.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("Move-to pulls with full length far away, and linearly less in the controlled zone") {
  Puppet robot("move_to", {{"x", 2.0}, {"y", 1.0}, {"speed", 0.4}, {"controlled", 0.8}});
  for (const double heading : {0.0, 70.0, 180.0, -135.0}) {
    check_vector(robot.lead_at(2.0 - 3.0, 1.0, heading).velocity(), 0.4, 0.0);
    check_vector(robot.lead_at(2.0, 1.0 + 0.8, heading).velocity(), 0.0, -0.4);
    check_vector(robot.lead_at(2.0 + 0.2, 1.0, heading).velocity(), -0.1, 0.0);
  }
}

TEST_CASE("Two move-to that pull to either side cancel, whatever the robot's heading") {
  Puppet east("move_to", {{"x", 1.0}}), west("move_to", {{"x", -1.0}});
  for (const double heading : {0.0, 30.0, 90.0, -170.0}) {
    const Motion sum = east.lead_at(0.0, 0.0, heading).ask().command +
                       west.lead_at(0.0, 0.0, heading).ask().command;
    CHECK(sum.forward == Approx(0.0).margin(1e-12));
    CHECK(sum.turn == Approx(0.0).margin(1e-12));
  }
  // Go-to-point is no vector: to both sides it turns with its full gain, so that its turns cancel
  // only by chance.
  testing::Behavior to_east("go_to_point", {{"x", 1.0}}), to_west("go_to_point", {{"x", -1.0}});
  const testing::Situation now = testing::Situation().at(0.0, 0.0, 30.0);
  const Motion sum = to_east.respond(now).command + to_west.respond(now).command;
  CHECK(std::abs(sum.turn) > 1.0);
}

TEST_CASE("In the controlled zone the distance falls exponentially, with any control period") {
  for (const double period : {1e-3, 0.01, 0.1}) {
    Puppet robot("move_to", {{"x", 0.5}, {"speed", 0.25}, {"controlled", 0.5}});
    robot.lead_at(0.0, 0.0, 0.0);
    while (robot.time_s < 2.0 - 0.5 * period) robot.step(period);
    // d' = -speed / controlled d
    CHECK(0.5 - robot.lead().x == Approx(0.5 * std::exp(-0.5 * 2.0)).epsilon(0.04));
    CHECK(robot.lead().y == Approx(0.0).margin(1e-9));
  }
}

TEST_CASE("It arrives from every direction, with any control period") {
  for (const double period : {1e-3, 0.01, 0.1}) {
    for (double heading = -180.0; heading < 180.0; heading += 45.0) {
      Puppet robot("move_to", {{"x", 1.0}, {"y", -1.0}});
      robot.at(0.0, 0.0, heading);
      int arrivals = 0;
      while (robot.time_s < 20.0) arrivals += static_cast<int>(robot.step(period).events.size());
      CHECK(arrivals == 1);
      CHECK(std::hypot(robot.lead().x - 1.0, robot.lead().y + 1.0) <= 0.02);
    }
  }
}

TEST_CASE("At the place it rests, without an activation, and says once that it has arrived") {
  Puppet robot("move_to", {{"x", 1.0}});
  const Response first = robot.lead_at(1.0, 0.0, 90.0).ask();
  CHECK(first.command == Motion{});
  CHECK(first.activation == 0.0);
  REQUIRE(first.events.size() == 1);
  CHECK(std::string(first.events[0].name) == "arrived");
  CHECK(robot.ask().events.empty());
  robot.behavior.reset();
  CHECK(robot.ask().events.size() == 1);
}

TEST_CASE("A drive that moves sideways moves with the vector, and keeps its heading") {
  Puppet robot("move_to", {{"y", 3.0}});
  robot.now.self.channels.lateral = true;
  const Motion motion = robot.lead_at(0.0, 0.0, 0.0).ask().command;
  CHECK(motion.lateral == Approx(0.3));
  CHECK(motion.turn == 0.0);
}

TEST_CASE("Move-to refuses a zone without a size, and a point on the axle") {
  CHECK_THROWS_WITH(testing::Behavior("move_to", {{"controlled", 0.0}}),
                    Catch::Contains("controlled"));
  CHECK_THROWS_WITH(testing::Behavior("move_to", {{"lead", 0.0}}), Catch::Contains("lead"));
}
