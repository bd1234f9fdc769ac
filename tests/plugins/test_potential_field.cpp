#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/readings/lidar.h"

#include "schemas.h"

using namespace elsie;
using namespace elsie::test;

namespace {

constexpr double kKhatibXi = 0.5, kKhatibEta = 0.001, kKhatibRho0 = 0.5;  // by default

/// Khatib's repulsion at a distance.
double khatib_hill(double rho) {
  return rho < kKhatibRho0 ? kKhatibEta * (1.0 / rho - 1.0 / kKhatibRho0) / (rho * rho) : 0.0;
}

/// A beam on the robot's nose, at the point that moves: what it measures is rho.
testing::Situation& khatib_beam(testing::Situation& now, double azimuth_deg, double rho) {
  return now.reading(RangeReading{rho, 1.0, rho < 1.0},
                     Mounting{{kLead, 0.0, 0.1}, radians(azimuth_deg), 0.0});
}

Puppet khatib_robot(testing::Settings more = {}) {
  testing::Settings settings{{"x", 0.0}, {"speed", 50.0}};
  more.merge(settings);
  return {"potential_field", more};
}

/// The answer of the obstacles alone to beams on the nose.
Motion khatib_repulsion(const std::vector<std::pair<double, double>>& beams,
                        double apart_deg = 45.0) {
  Puppet robot = khatib_robot({{"attraction", 0.0}, {"apart_deg", apart_deg}});
  for (const auto& [azimuth, rho] : beams) khatib_beam(robot.now, azimuth, rho);
  return robot.ask().command;
}

}  // namespace

TEST_CASE("The goal pulls with xi times the distance, and beyond the parabola with a constant") {
  Puppet robot = khatib_robot({{"conic_beyond", 0.6}});
  khatib_beam(robot.now, 0.0, 1.0);
  for (const double heading : {0.0, 50.0, -160.0}) {
    check_vector(robot.lead_at(0.4, 0.0, heading).velocity(), -kKhatibXi * 0.4, 0.0);
    check_vector(robot.lead_at(0.0, -0.6, heading).velocity(), 0.0, kKhatibXi * 0.6);
    check_vector(robot.lead_at(0.0, -5.0, heading).velocity(), 0.0, kKhatibXi * 0.6);
  }
}

TEST_CASE("A wall repels by eta (1/rho - 1/rho0) / rho^2 within rho0, and not beyond") {
  for (const double rho : {0.1, 0.2, 0.3, 0.45, 0.5, 0.7}) {
    CHECK(khatib_repulsion({{0.0, rho}}).forward == Approx(-khatib_hill(rho)).margin(1e-12));
    CHECK(khatib_repulsion({{90.0, rho}}).turn == Approx(-khatib_hill(rho) / kLead).margin(1e-12));
  }
}

TEST_CASE("The vector is no longer than the speed, and is finite at the surface and in it") {
  Puppet robot = khatib_robot({{"attraction", 0.0}, {"speed", 0.3}});
  for (const double rho : {0.0, 1e-300, 1e-9, 0.01}) {
    robot.now.clear_readings();
    khatib_beam(robot.now, 0.0, rho);
    CHECK(robot.ask().command.forward == Approx(-0.3));
  }
  // A beam from behind the point sees a surface that the point is in.
  robot.now.clear_readings().beam(0.0, 0.02);
  CHECK(robot.ask().command.forward == Approx(-0.3));
}

TEST_CASE("An obstacle counts once, at its nearest point, however many rays see it") {
  const double alone = khatib_repulsion({{0.0, 0.2}}).forward;
  CHECK(khatib_repulsion({{0.0, 0.2}, {20.0, 0.213}, {-20.0, 0.213}}).forward == Approx(alone));
  CHECK(khatib_repulsion({{-20.0, 0.213}, {0.0, 0.2}, {20.0, 0.213}}).turn ==
        Approx(0.0).margin(1e-12));
  // Two that are as near share it.
  const Motion even = khatib_repulsion({{20.0, 0.2}, {-20.0, 0.2}});
  CHECK(even.forward == Approx(alone * std::cos(radians(20.0))));
  CHECK(even.turn == Approx(0.0).margin(1e-12));
  // Two walls of a corner are two obstacles.
  const Motion corner = khatib_repulsion({{0.0, 0.2}, {45.0, 0.283}, {90.0, 0.2}}, 50.0);
  CHECK(corner.forward == Approx(-khatib_hill(0.2)));
  CHECK(corner.turn == Approx(-khatib_hill(0.2) / kLead));
}

TEST_CASE("It sees by a lidar what it sees by beams") {
  Puppet robot = khatib_robot({{"attraction", 0.0}});
  LidarReading scan;
  scan.ranges_m = {1.0, 0.25, 0.2, 0.3, 1.0};
  scan.max_range_m = 1.0;
  scan.first_rad = radians(20.0);
  scan.step_rad = radians(10.0);
  robot.now.reading(scan, Mounting{{kLead, 0.0, 0.1}, radians(30.0), 0.0});
  const Motion seen = robot.ask().command;
  CHECK(seen.forward == Approx(-khatib_hill(0.2) * std::cos(radians(30.0))));
  CHECK(seen.turn == Approx(-khatib_hill(0.2) * std::sin(radians(30.0)) / kLead));
}

TEST_CASE("In front of a wall before the goal it comes to rest where pull and push are equal") {
  // xi conic_beyond = eta (1/rho - 1/rho0) / rho^2, the goal far behind the wall
  double low = 1e-3, high = kKhatibRho0;
  for (int i = 0; i < 100; ++i) {
    const double rho = 0.5 * (low + high);
    (khatib_hill(rho) > kKhatibXi * 0.6 ? low : high) = rho;
  }
  for (const double period : {1e-3, 0.01, 0.1}) {
    Puppet robot = khatib_robot({{"x", 5.0}, {"speed", 0.3}});
    robot.at(0.0, 0.0, 0.0);
    while (robot.time_s < 20.0) {
      robot.now.clear_readings();
      khatib_beam(robot.now, 0.0, std::min(1.0, 2.0 - robot.lead().x));
      robot.step(period);
    }
    CHECK(2.0 - robot.lead().x == Approx(low).margin(1e-6));
  }
}

TEST_CASE("It arrives once, rests there, and is not active where nothing is near") {
  Puppet robot = khatib_robot();
  khatib_beam(robot.now, 0.0, 1.0);
  const Response first = robot.lead_at(0.03, 0.0, 0.0).ask();
  CHECK(first.events.size() == 1);
  CHECK(first.activation == 0.0);
  CHECK(first.command == Motion{});
  CHECK(robot.ask().events.empty());
  robot.now.clear_readings();
  khatib_beam(robot.now, 0.0, 0.2);
  CHECK(robot.ask().command.forward == Approx(-khatib_hill(0.2)));
  CHECK(robot.ask().activation == 1.0);
}

TEST_CASE("A robot that sees no ranges is refused by the potential field") {
  testing::Behavior blind("potential_field");
  CHECK_THROWS_WITH(blind.respond(testing::Situation()),
                    Catch::Contains("it needs a lidar, or range sensors"));
  CHECK_THROWS_WITH(testing::Behavior("potential_field", {{"influence", 0.0}}),
                    Catch::Contains("influence"));
}

TEST_CASE("In a U before the goal it is stuck, and without the back of the U it arrives") {
  CHECK(succeeds("local_minimum"));  // whose goal is to be there after a minute
  testing::World open = testing::World::from_file(source_path("worlds/local_minimum.xml"),
                                                  {.set = {"obstacle[back]/@remove=true"}});
  CHECK(open.run_until([](const testing::World& world) { return world.count("arrived") == 1; },
                       20.0));
  CHECK(open.count("collision") == 0);
}
