// What a robot believes of its place, and who gets the truth.
#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/simulation/simulation.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// A robot that drives to (3, 0), where it believes that to be.
Simulation traveller(const std::string& localisation, const std::string& more = "") {
  const std::string inside =
      (localisation.empty() ? "" : "<localisation>" + localisation + "</localisation>") +
      R"(<sensors/><behaviors><go_to_point x="3" y="0"/></behaviors>
         <coordinator><arbiter_suppression/></coordinator>)";
  return of(more, inside);
}

double apart(const Simulation& simulation) {
  const simulation::RobotView robot = simulation.robot(0);
  return distance(robot.pose, robot.state->pose);
}

}  // namespace

TEST_CASE("A robot without localisation, or with an exact one, believes the truth") {
  Simulation plain = traveller(""), exact = traveller("<exact/>");
  advance(plain, 300);
  advance(exact, 300);
  CHECK(plain.state_hash() == exact.state_hash());
  CHECK(apart(plain) == 0.0);
  CHECK(apart(exact) == 0.0);
  CHECK(exact.robot(0).state->moving == exact.robot(0).moving);
}

TEST_CASE("Unequal wheels bend the believed way of a straight drive by e L / (2 a)") {
  constexpr double kError = 0.02;
  Simulation simulation =
      of("", R"(<localisation><odometry left_radius_error="0.02"/></localisation>
      <behaviors><braitenberg base="10"/></behaviors><coordinator><arbiter_suppression/></coordinator>
      <sensors><beam_range max_range="0.001"/></sensors>)");
  advance(simulation, 200);
  const simulation::RobotView robot = simulation.robot(0);
  const double way = robot.distance_m;
  const double expected = -kError * way / (2.0 * robot.state->wheels.half_axle);
  CHECK(robot.pose.heading_rad == Approx(0.0).margin(0.01));
  CHECK(wrap_angle(robot.state->pose.heading_rad - expected) == Approx(0.0).margin(0.03));
}

TEST_CASE("A robot that errs goes to another place than it believes") {
  Simulation simulation = traveller(R"(<odometry slip="0.2"/>)");
  advance(simulation, 3000);
  const simulation::RobotView robot = simulation.robot(0);
  CHECK(robot.state->pose.x == Approx(3.0).margin(0.2));
  CHECK(robot.pose.x == Approx(3.0 / 0.8).margin(0.3));
}

TEST_CASE("Goals and measures have the truth") {
  const std::string goal =
      R"(<goals><reach robot="r1" x="3" y="0" radius="0.3"/></goals><limits time="30"/>)";
  CHECK(traveller("", goal).run().outcome == simulation::Outcome::success);
  CHECK(traveller(R"(<odometry slip="0.3"/>)", goal).run().outcome ==
        simulation::Outcome::time_limit);
}

TEST_CASE("A beacon tells the place every so often") {
  Simulation simulation = traveller(R"(<beacon period="0.5" slip="0.2"/>)");
  double most = 0.0, least = 1.0;
  for (int i = 0; i < 400; ++i) {
    simulation.step();
    most = std::max(most, apart(simulation));
    if (i >= 50) least = std::min(least, apart(simulation));
  }
  CHECK(most > 0.01);
  CHECK(most < 0.5 * 0.5 * 0.2 + 0.02);  // half a second at full speed
  CHECK(least == Approx(0.0).margin(1e-9));
  std::string published;
  simulation.visit_published(0, [&](const simulation::PublishedValue& value) {
    published += std::string(value.path) + "." + value.number.name + "=" +
                 std::to_string(static_cast<int>(value.value));
  });
  CHECK(published == "beacon.fixes=8");
}

TEST_CASE("A robot that is placed elsewhere believes what it did, unless it knows exactly") {
  const auto after = [](const std::string& localisation) {
    Simulation simulation = traveller(localisation);
    advance(simulation, 10);
    place(simulation, 0, {1.0, 2.0, 0.0});
    return simulation.robot(0).state->pose;
  };
  CHECK(after("<odometry/>").y == Approx(0.0).margin(0.01));
  CHECK(after("<exact/>").y == Approx(2.0).margin(0.01));
  CHECK(after("").y == Approx(2.0).margin(0.01));
}

TEST_CASE("Every seed draws its own errors, and edits change them while it drives") {
  const auto believed = [](std::uint64_t seed) {
    Simulation simulation = traveller(R"(<odometry wheel_noise="0.05" radius_spread="0.02"/>)");
    simulation.reset(seed);
    advance(simulation, 200);
    return simulation.robot(0).state->pose;
  };
  CHECK(believed(1) == believed(1));
  CHECK_FALSE(believed(1) == believed(2));
  Simulation simulation = traveller("<odometry/>");
  advance(simulation, 100);
  simulation.edit("robot[r1]/localisation/@slip", "0.5");
  advance(simulation, 100);
  CHECK(apart(simulation) > 0.05);
}

TEST_CASE("Mates tell what they believe of themselves") {
  // The mate believes itself half as far away from where it started as it is.
  const std::string world = R"(<world format="1"><robots>
    <robot id="r1" x="0" y="1" coverage="10"><behaviors/><coordinator><arbiter_suppression/></coordinator></robot>
    <robot id="r2" coverage="10"><localisation><odometry slip="0.5"/></localisation>
      <behaviors><go_to_point x="2" y="0"/></behaviors>
      <coordinator><arbiter_suppression/></coordinator></robot></robots></world>)";
  Simulation simulation(world::parse_world(world, "mates.xml", shipped()), shipped());
  advance(simulation, 300);
  const simulation::RobotView mate = simulation.robot(1);
  CHECK(mate.state->pose.x == Approx(0.5 * mate.pose.x).epsilon(0.05));
}
