#include <algorithm>
#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/readings/omnidirectional_camera.h"

#include "schemas.h"

using namespace elsie;
using namespace elsie::test;

namespace {

constexpr Colour kDodgedBall{0x30, 0x60, 0xd0};

/// A ball that flies straight, and a robot that may dodge it.
struct DodgedFlight {
  Puppet robot;
  double x, y, east, north;  // the ball and its velocity

  /// The answer, after which both have moved.
  Response step(double period_s, bool moves = true) {
    const Pose pose{robot.x, robot.y, robot.heading_rad};
    robot.now.clear_readings();
    robot.now.reading(
        OmnidirectionalReading{{{std::hypot(x - pose.x, y - pose.y), bearing(pose, x, y),
                                 kDodgedBall.red, kDodgedBall.green, kDodgedBall.blue}},
                               10});
    const Response response = robot.step(period_s);
    if (!moves) robot.at(pose.x, pose.y, degrees(pose.heading_rad));
    x += period_s * east;
    y += period_s * north;
    return response;
  }
  /// The answer after half a second, in which the robot stands.
  Response after_a_while(double period_s = 0.01) {
    Response response;
    for (double time = 0.0; time < 0.5; time += period_s) response = step(period_s, false);
    return response;
  }
};

DodgedFlight dodged_flight(double x, double y, double east, double north,
                           const testing::Settings& settings = {}) {
  return {Puppet("dodge", settings), x, y, east, north};
}

}  // namespace

TEST_CASE("It sidesteps across the way of what comes, to the side on which it is already") {
  // From the east, 1.5 m away after half a second, and it would pass 0.1 m to the north or south.
  const Response south = dodged_flight(2.0, 0.1, -1.0, 0.0).after_a_while();
  CHECK(south.activation == 1.0);
  CHECK(south.command.forward == Approx(0.0).margin(1e-6));
  CHECK(south.command.turn == Approx(-0.3 / kLead));
  const Response north = dodged_flight(2.0, -0.1, -1.0, 0.0).after_a_while();
  CHECK(north.command.turn == Approx(0.3 / kLead));
  // Across its heading it drives on, or back.
  CHECK(dodged_flight(-0.1, 2.0, 0.0, -1.0).after_a_while().command.forward == Approx(0.3));
  CHECK(dodged_flight(0.1, 2.0, 0.0, -1.0).after_a_while().command.forward == Approx(-0.3));
  // Straight at it from the side: where it is heading.
  CHECK(dodged_flight(0.0, 2.0, 0.0, -1.0).after_a_while().command.forward == Approx(0.3));
  CHECK(dodged_flight(0.0, -2.0, 0.0, 1.0).after_a_while().command.forward == Approx(0.3));
}

TEST_CASE("It lets pass what stands, leaves, is slow, passes far enough or comes late") {
  CHECK(dodged_flight(1.0, 0.0, 0.0, 0.0).after_a_while().activation == 0.0);
  CHECK(dodged_flight(1.0, 0.0, 1.0, 0.0).after_a_while().activation == 0.0);
  CHECK(dodged_flight(1.0, 0.0, -0.04, 0.0).after_a_while().activation == 0.0);
  CHECK(dodged_flight(2.0, 0.41, -1.0, 0.0).after_a_while().activation == 0.0);
  CHECK(dodged_flight(2.0, 0.39, -1.0, 0.0).after_a_while().activation == 1.0);
  CHECK(dodged_flight(3.6, 0.0, -1.0, 0.0).after_a_while().activation == 0.0);
  CHECK(dodged_flight(3.4, 0.0, -1.0, 0.0).after_a_while().activation == 1.0);
  CHECK(dodged_flight(2.0, 0.0, -1.0, 0.0, {{"colour", std::string("#ff0000")}})
            .after_a_while()
            .activation == 0.0);
  testing::Behavior blind("dodge");
  const Response nothing =
      blind.respond(testing::Situation().reading(OmnidirectionalReading{{}, 10}));
  CHECK(nothing.activation == 0.0);
  CHECK(nothing.command == Motion{});
}

TEST_CASE("A dodged ball misses by the clearance; with any control period it would have hit") {
  for (const double period : {1e-3, 0.01, 0.1}) {
    for (double from = 0.0; from < 360.0; from += 45.0) {
      const double c = std::cos(radians(from)), s = std::sin(radians(from));
      DodgedFlight ball = dodged_flight(2.5 * c, 2.5 * s, -0.5 * c, -0.5 * s);
      double nearest = 10.0;
      while (ball.robot.time_s < 10.0) {
        ball.step(period);
        nearest = std::min(nearest, std::hypot(ball.x - ball.robot.x, ball.y - ball.robot.y));
      }
      CHECK(nearest > 0.38);
      CHECK(nearest < 0.6);  // and it does not run away
    }
  }
}

TEST_CASE("It keeps to its side although the measured way wavers") {
  DodgedFlight ball = dodged_flight(2.0, 0.0, -0.5, 0.0);
  ball.robot.at(0.0, 0.0, 0.0);
  int sides = 0, last = 0;
  for (int i = 0; i < 200; ++i) {
    ball.y = 0.001 * std::sin(1.7 * i);
    const double turn = ball.step(0.01, false).command.turn;
    const int side = turn > 0.0 ? 1 : turn < 0.0 ? -1 : 0;
    sides += side != 0 && side != last;
    if (side != 0) last = side;
  }
  CHECK(sides == 1);
}

TEST_CASE("After a time without readings it measures anew, and so it does after a jump") {
  DodgedFlight ball = dodged_flight(3.0, 0.0, -1.0, 0.0);
  CHECK(ball.after_a_while().activation == 1.0);
  ball.robot.time_s += 1.0;
  CHECK(ball.step(0.01, false).activation == 0.0);
  CHECK(ball.after_a_while().activation == 1.0);
  ball.x = 1.0;  // another one: nearer by far more than the first can be
  CHECK(ball.step(0.01, false).activation == 0.0);
  ball.robot.behavior.reset();
  CHECK(ball.step(0.01, false).activation == 0.0);
}

TEST_CASE("A colour that is none is refused by dodge, and so is a robot without a camera") {
  CHECK_THROWS_WITH(testing::Behavior("dodge", {{"colour", std::string("blue")}}),
                    Catch::Contains("expected six hexadecimal digits after #"));
  const auto robot_with = [](const std::string& sensors) {
    return testing::World::from_text(
        "<world format='1'><robots><robot id='r1'><sensors>" + sensors +
        "</sensors><behaviors><dodge/></behaviors><coordinator><arbiter_suppression/></coordinator>"
        "</robot></robots></world>");
  };
  CHECK_THROWS_WITH(robot_with("<beam_range/>"),
                    Catch::Contains("'dodge' needs readings of the kind 'omnidirectional'") &&
                        Catch::Contains("add <omnidirectional_camera>"));
  CHECK_NOTHROW(robot_with("<omnidirectional_camera/>"));
}

TEST_CASE("A robot that dodges stays untouched where another one goes round and round") {
  CHECK(succeeds("dodge"));
  CHECK_FALSE(succeeds("dodge", {"robot[r1]/behavior[dodge]/@horizon=0"}));
}
