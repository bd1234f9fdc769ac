// Sensors on the segments that a robot pulls.
#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/simulation/simulation.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// A robot with two segments in line behind it, between walls 1 m to its left and 2 m to its right.
/// Waggon b ends 0.32 m behind the robot's middle.
const std::string kTrain = R"(<segments><segment id="a"/><segment id="b"/></segments><sensors>)";
const std::string kWalls = R"(<obstacles>
    <static_box id="left" y="1.5" length="6" width="1" height="1"/>
    <static_box id="right" y="-2.5" length="6" width="1" height="1"/></obstacles>)";

Simulation with(const std::string& sensors, const std::string& engine = "ode",
                const std::string& control = "") {
  return of("<physics engine=\"" + engine + "\"/>" + kWalls,
            kTrain + sensors + "</sensors>" + control);
}

}  // namespace

TEST_CASE("An odometer adds up every step of a control period") {
  Simulation simulation = of(R"(<physics control_steps="25"/>)",
                             R"(<sensors><odometer/></sensors>
                                <behaviors><wander restlessness="3"/></behaviors>
                                <coordinator><arbiter_suppression/></coordinator>)");
  double path = 0.0;  // of the middle, by the wheels
  for (int step = 0; step < 1001; ++step) {
    simulation.step();
    if (step < 1000) path += 0.01 * simulation.robot(0).state->odometry.forward;
  }
  const std::vector<double> reading = numbers_of(simulation, 0, 0);
  CHECK(0.5 * (reading[0] + reading[1]) == Approx(path).epsilon(1e-9));
}

TEST_CASE("A sensor on a segment measures from there, in either engine") {
  for (const char* engine : {"ode", "planar"}) {
    CAPTURE(engine);
    Simulation simulation =
        with(R"(<beam_range id="l" segment="b" x="0" yaw_deg="90" max_range="5"/>
                <beam_range id="r" segment="b" x="0" y="-0.1" yaw_deg="-90" max_range="5"/>
                <beam_range id="own" yaw_deg="-90" max_range="5"/>
                <gps id="place" segment="b" x="0"/>)",
             engine);
    simulation.step();
    CHECK(numbers_of(simulation, 0, 0)[0] == Approx(1.0).margin(1e-3));
    CHECK(numbers_of(simulation, 0, 1)[0] == Approx(1.9).margin(1e-3));
    CHECK(numbers_of(simulation, 0, 2)[0] == Approx(2.0).margin(1e-3));
    const simulation::SegmentView waggon = simulation.segment(0, 1);
    CHECK(numbers_of(simulation, 0, 3)[0] == Approx(waggon.pose.x).margin(1e-6));
    CHECK(waggon.pose.x < -0.2);
  }
}

TEST_CASE("By default it is at the front and on top of its segment") {
  Simulation simulation = with(R"(<beam_range id="l" segment="a"/>)");
  const Frame frame = simulation.sensor_frame(0, 0);
  const simulation::SegmentView waggon = simulation.segment(0, 0);
  CHECK(frame.origin.x == Approx(waggon.pose.x + 0.04));
  CHECK(frame.origin.z == Approx(waggon.frame.origin.z + 0.09));
  CHECK(simulation.sensor(0, 0).mounting->segment == 1);
}

TEST_CASE("It turns with its segment while the robot drives in a circle") {
  Simulation simulation =
      with(R"(<beam_range id="b" segment="b" yaw_deg="90" max_range="9"/>)", "planar",
           R"(<behaviors><braitenberg weights="2 -2" base="5"/></behaviors>
              <coordinator><arbiter_suppression/></coordinator>)");
  for (int i = 0; i < 300; ++i) simulation.step();
  const simulation::SegmentView waggon = simulation.segment(0, 1);
  const Frame frame = simulation.sensor_frame(0, 0);
  CHECK(std::abs(waggon.yaw_rad) > 0.01);
  CHECK(std::atan2(frame.forward.y, frame.forward.x) ==
        Approx(wrap_angle(waggon.pose.heading_rad + radians(90.0))));
}

TEST_CASE("A segment that carries a sensor is not removed alone, and sensors are added there") {
  Simulation simulation = with(R"(<beam_range id="l" segment="b" x="0" yaw_deg="90"/>)");
  simulation.step();
  CHECK_THAT(refusal(simulation, "robot[r1]/segment[b]/@remove", "true"),
             Catch::Contains("is mounted on the segment 'b'"));
  const Frame before = simulation.sensor_frame(0, 0);
  simulation.edit("robot[r1]/sensor[+]",
                  R"(<beam_range id="m" segment="a" x="0" yaw_deg="90" max_range="5"/>)");
  CHECK(simulation.sensor_frame(0, 0).origin.x == before.origin.x);
  simulation.step();
  CHECK(numbers_of(simulation, 0, 1)[0] == Approx(1.0).margin(1e-3));
}

TEST_CASE("A segment that the robot does not pull is refused with those that it pulls") {
  CHECK_THAT(why_no_world([] { with(R"(<beam_range id="l" segment="c"/>)"); }),
             Catch::Contains("the sensor 'l' is mounted on the segment 'c', and") &&
                 Catch::Contains("pulls none of that name"));
}
