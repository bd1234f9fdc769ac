// Noise and failures that a world file gives a sensor.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/readings/lidar.h"
#include "elsie/simulation/simulation.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;

namespace {

constexpr double kPeriod = 0.01;  // s

/// A robot that stands in front of a wall, 1 m from its sensor, with this in the sensor's element.
Simulation in_front(const std::string& inside, std::uint64_t seed = 1,
                    const std::string& more = "") {
  return of(
      R"(<obstacles><static_box id="wall" x="1.54" width="4" length="1" height="1"/></obstacles>)" +
          more,
      R"(<sensors><beam_range id="ahead" max_range="3">)" + inside + "</beam_range></sensors>",
      {.seed = seed});
}

double reading(Simulation& simulation) { return numbers_of(simulation, 0, 0).front(); }

std::vector<double> readings(Simulation simulation, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) {
    simulation.step();
    all.push_back(reading(simulation));
  }
  return all;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}
double deviation(const std::vector<double>& values) {
  const double middle = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

std::string why_refused(const std::string& inside, const std::string& more = "") {
  return why_no_world([&] { in_front(inside, 1, more); });
}

}  // namespace

TEST_CASE("Scale and bias change a number in this order") {
  CHECK(readings(in_front(R"(<noise on="distance_m" scale="2" bias="0.1"/>)"), 1)[0] ==
        Approx(2.1));
}

TEST_CASE("Several noises apply one after the other") {
  CHECK(
      readings(in_front(R"(<noise on="distance_m" bias="0.1"/><noise on="distance_m" scale="2"/>)"),
               1)[0] == Approx(2.2));
}

TEST_CASE("Gaussian, proportional and uniform noise have the deviations that they say") {
  constexpr int kCount = 4000;
  const double tolerance = 4.0 / std::sqrt(2.0 * kCount);  // four standard errors of a deviation
  const auto gaussian = readings(in_front(R"(<noise on="distance_m" gaussian="0.02"/>)"), kCount);
  CHECK(mean(gaussian) == Approx(1.0).margin(0.002));
  CHECK(deviation(gaussian) == Approx(0.02).epsilon(tolerance));
  const auto part =
      readings(in_front(R"(<noise on="distance_m" scale="2" proportional="0.02"/>)"), kCount);
  CHECK(deviation(part) == Approx(0.04).epsilon(tolerance));
  const auto uniform = readings(in_front(R"(<noise on="distance_m" uniform="0.03"/>)"), kCount);
  CHECK(deviation(uniform) == Approx(0.03 / std::sqrt(3.0)).epsilon(tolerance));
  CHECK(*std::max_element(uniform.begin(), uniform.end()) <= 1.03);
}

TEST_CASE("A number is rounded to the resolution, then kept within the clamp") {
  CHECK(readings(in_front(R"(<noise on="distance_m" bias="0.06" resolution="0.25"/>)"), 1)[0] ==
        Approx(1.0));
  CHECK(readings(in_front(R"(<noise on="distance_m" bias="5" clamp="0 1.7"/>)"), 1)[0] == 1.7);
}

TEST_CASE("Noise applies to every number of an array, each by itself") {
  Simulation simulation = of(
      R"(<obstacles><static_box x="1.54" width="4" length="1" height="1"/></obstacles>)",
      R"(<sensors><lidar id="scan" rays="5" fov_deg="10"><noise on="ranges" gaussian="0.01"/></lidar></sensors>)");
  simulation.step();
  const std::vector<double> ranges = numbers_of(simulation, 0, 0);
  REQUIRE(ranges.size() == 5);
  for (std::size_t i = 1; i < ranges.size(); ++i) {
    CHECK(ranges[i] != ranges[0]);
    CHECK(ranges[i] == Approx(1.0).margin(0.06));
  }
}

TEST_CASE("A reading is seen as late as its latency says") {
  Simulation simulation = in_front(R"(<failure latency="0.05"/>)");
  const double before = reading(simulation);
  for (int i = 0; i < 5; ++i) {
    simulation.step();
    CHECK(reading(simulation) == before);  // nothing has arrived yet
  }
  simulation.step();
  CHECK(reading(simulation) == Approx(1.0));
}

TEST_CASE("What is missed by dropout leaves the reading as it was, as often as said") {
  constexpr int kCount = 2000;
  const auto all = readings(
      in_front(R"(<noise on="distance_m" gaussian="0.01"/><failure dropout="0.25"/>)"), kCount);
  int missed = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    missed += all[i] == all[i - 1] ? 1 : 0;
  }
  CHECK(missed / double(kCount) == Approx(0.25).margin(4 * std::sqrt(0.25 * 0.75 / kCount)));
}

TEST_CASE("A sensor that is stuck keeps its last reading") {
  const auto all = readings(
      in_front(R"(<noise on="distance_m" gaussian="0.01"/><failure stuck_from="0.5"/>)"), 100);
  CHECK(all[48] != all[49]);
  for (std::size_t i = 51; i < all.size(); ++i) {
    CHECK(all[i] == all[50]);
  }
}

TEST_CASE("A new noise changes nothing that the sensor and others draw") {
  const auto with = [](const std::string& inside) {
    return readings(of("", R"(<sensors><proximity id="other" error="0.5"/>
        <beam_range id="ahead" error="0.1">)" +
                               inside + "</beam_range></sensors>"),
                    50);
  };
  // The first sensor is the one that has no noise.
  CHECK(with("") == with(R"(<noise on="distance_m" gaussian="0.1"/><failure dropout="0.5"/>)"));
  const auto own = [](const std::string& inside) {
    return readings(in_front(R"(<noise on="distance_m" gaussian="0.1"/>)" + inside), 50);
  };
  CHECK(own("") == own(R"(<failure dropout="0"/>)"));
}

TEST_CASE("Each seed has its own noise, and the same seed the same") {
  const char* const noise = R"(<noise on="distance_m" gaussian="0.1"/>)";
  CHECK(readings(in_front(noise, 3), 20) == readings(in_front(noise, 3), 20));
  CHECK(readings(in_front(noise, 3), 20) != readings(in_front(noise, 4), 20));
  Simulation simulation = in_front(noise, 3);
  simulation.step();
  const double first = reading(simulation);
  simulation.reset();
  simulation.step();
  CHECK(reading(simulation) == first);
}

TEST_CASE("An edit sets a noise while the robot runs") {
  Simulation simulation = in_front(R"(<noise on="distance_m" bias="0.1"/>)");
  simulation.step();
  CHECK(reading(simulation) == Approx(1.1));
  simulation.edit("robot[r1]/sensor[ahead]/noise[1]/@bias", "0.3");
  simulation.step();
  CHECK(reading(simulation) == Approx(1.3));
}

TEST_CASE("An edit of something else keeps the readings under way, and the streams") {
  const auto seen = [](bool edits) {
    Simulation simulation = in_front(
        R"(<noise on="distance_m" gaussian="0.1"/><failure latency="0.05" dropout="0.1"/>)");
    std::vector<double> all;
    for (int i = 0; i < 40; ++i) {
      if (edits && i == 20) {
        simulation.edit("robot[r1]/sensor[+]", R"(<beam_range id="other" yaw_deg="90"/>)");
        // Refused, and undone.
        CHECK_FALSE(refusal(simulation, "robot[r1]/sensor[ahead]/noise[1]/@on", "hit").empty());
      }
      simulation.step();
      all.push_back(reading(simulation));
    }
    return all;
  };
  CHECK(seen(true) == seen(false));
}

TEST_CASE("A sensor with late readings may get other arrays by an edit") {
  Simulation simulation =
      of("", R"(<sensors><lidar id="scan" rays="5"><failure latency="0.05"/></lidar></sensors>)");
  advance(simulation, 10);
  simulation.edit("robot[r1]/sensor[scan]/@rays", "9");
  advance(simulation, 10);
  CHECK(numbers_of(simulation, 0, 0).size() == 9);
}

TEST_CASE("Noise that makes a number that is not finite ends the run and names its sensor") {
  Simulation simulation = in_front(R"(<noise on="distance_m" scale="1e200"/>
                                      <noise on="distance_m" scale="1e200"/>)");
  CHECK_THROWS_WITH(simulation.step(),
                    Catch::Contains("'ahead'") && Catch::Contains("of robot 'r1'") &&
                        Catch::Contains("its <noise on=\"distance_m\"> makes a number that is not "
                                        "finite"));
}

TEST_CASE("One deviation more in a noise changes no other") {
  const auto seen = [](const std::string& more) {
    return readings(in_front("<noise on=\"distance_m\" gaussian=\"0.01\" " + more + "/>"), 20);
  };
  const auto alone = seen(""), more = seen(R"(uniform="1e-12" proportional="1e-12")");
  for (std::size_t i = 0; i < alone.size(); ++i) CHECK(more[i] == Approx(alone[i]).margin(1e-10));
}

TEST_CASE("Before its first reading arrives, a beam sees nothing within its range") {
  Simulation simulation = in_front(R"(<failure dropout="1"/>)");
  simulation.step();
  CHECK(reading(simulation) == 3.0);
}

TEST_CASE("A live edit of a lidar holds for all of its next reading") {
  const auto lidar = [](Simulation& simulation) {
    simulation.step();
    return *static_cast<const LidarReading*>(simulation.sensor(0, 0).sensor->reading());
  };
  Simulation simulation = of("", R"(<sensors><lidar id="scan" rays="5" fov_deg="90"/></sensors>)");
  CHECK(lidar(simulation).azimuth_rad(0) == Approx(radians(45.0)));
  simulation.edit("robot[r1]/sensor[scan]/@fov_deg", "180");
  simulation.edit("robot[r1]/sensor[scan]/@max_range", "1.5");
  CHECK(lidar(simulation).azimuth_rad(0) == Approx(radians(90.0)));
  CHECK(lidar(simulation).max_range_m == 1.5);
}

TEST_CASE("An edit that leads to nothing is noted in the result") {
  Simulation simulation = in_front("");
  simulation.edit("robot[team=green]/@max_speed", "0.1");
  simulation.edit("sensor[plugin=sonar]/noise[+]", R"(<noise on="x"/>)");
  simulation.edit("robot[team=green]/@remove", "true");
  std::vector<std::string> notes;
  for (const simulation::Note& note : simulation.result().notes) {
    notes.push_back(note.plugin + ": " + note.text);
  }
  const auto said = [](const std::string& edit) {
    return "changes: The edit " + edit +
           " at 0 s leads to nothing in this world, and has no effect.";
  };
  CHECK(notes == std::vector<std::string>{said("robot[team=green]/@max_speed=0.1"),
                                          said(R"(sensor[plugin=sonar]/noise[+]=<noise on="x"/>)"),
                                          said("robot[team=green]/@remove=true")});
}

TEST_CASE("What does not fit a sensor is refused with a sentence") {
  CHECK_THAT(why_refused(R"(<noise on="distance" bias="1"/>)"),
             Catch::Contains("its <noise on=\"distance\"> names no number of its reading") &&
                 Catch::Contains("distance_m"));
  CHECK_THAT(why_refused(R"(<noise on="hit" bias="1"/>)"), Catch::Contains("is true or false"));
  CHECK_THAT(why_refused(R"(<noise on="distance_m" clamp="1"/>)"), Catch::Contains("clamp"));
  CHECK_THAT(why_refused(R"(<noise on="distance_m" clamp="2 1"/>)"), Catch::Contains("clamp"));
  CHECK_THAT(why_refused(R"(<noise on="distance_m" gaussian="-1"/>)"),
             Catch::Contains("at least 0"));
  CHECK_THAT(why_refused(R"(<noise bias="1"/>)"), Catch::Contains("lacks the attribute 'on'"));
  CHECK_THAT(why_refused(R"(<failure latency="60"/>)"),
             Catch::Contains("no reading arrives before the run ends, at 60 s; expected less"));
  CHECK_THAT(
      why_refused(R"(<failure latency="30"/><failure latency="31"/>)"),
      Catch::Contains("latency=\"61\" of <failure>: no reading arrives before the run ends"));
  CHECK_THAT(why_refused(R"(<failure latency="1"/>)", R"(<physics step="1e-6"/>)"),
             Catch::Contains("more than 100,000 readings would be under way") &&
                 Catch::Contains("expected at most 0.1 s"));
  CHECK_THAT(why_refused(R"(<failure dropout="2"/>)"), Catch::Contains("dropout"));
}

namespace {

/// A robot on this drive that wants to drive ahead at 0.1 m/s; wheels of 0.02 m.
Simulation driving(const std::string& drive, const simulation::Options& options = {}) {
  return of(
      R"(<physics engine="planar"/>)",
      R"(<body wheel_torque="1"/><drive>)" + drive +
          R"(</drive><sensors><beam_range/></sensors><behaviors><braitenberg base="5" weights="0 0"/></behaviors>
                   <coordinator><arbiter_suppression/></coordinator>)",
      options);
}

Simulation driving_with(const std::string& inside, const simulation::Options& options = {}) {
  return driving("<differential>" + inside + "</differential>", options);
}

double rate(const Simulation& simulation, std::size_t joint = 0) {
  return simulation.robot(0).joints[joint].rate_rad_s;
}

/// The rates of the first robot's wheels after each of so many steps, rad/s.
std::vector<double> wheels(Simulation simulation, int steps, std::size_t joint = 0) {
  std::vector<double> all;
  for (int i = 0; i < steps; ++i) {
    simulation.step();
    all.push_back(rate(simulation, joint));
  }
  return all;
}

std::string why_no_drive(const std::string& drive) {
  return why_no_world([&] { driving(drive); });
}

}  // namespace

TEST_CASE("Noise of a drive applies to the set points of its joints") {
  CHECK(wheels(driving_with(R"(<noise on="left_wheel.rate" scale="0.5"/>)"), 1)[0] == Approx(2.5));
  CHECK(wheels(driving_with(R"(<noise on="left_wheel.rate" scale="0.5"/>)"), 1, 1)[0] ==
        Approx(5.0));
  const auto noisy = wheels(driving_with(R"(<noise on="left_wheel.rate" gaussian="0.3"/>)"), 2000);
  CHECK(deviation(noisy) == Approx(0.3).epsilon(0.07));
  CHECK(mean(noisy) == Approx(5.0).margin(0.03));
}

TEST_CASE("A robot with a dead wheel turns about it, and its command stays what it wants") {
  Simulation simulation = driving_with(R"(<noise on="left_wheel.rate" scale="0"/>)");
  for (int i = 0; i < 100; ++i) simulation.step();
  const simulation::RobotView robot = simulation.robot(0);
  CHECK(robot.moving.turn > 0.9);  // 0.1 m/s over the 0.09 m between the wheels is 1.1 rad/s
  CHECK(robot.command.forward == Approx(0.1));
}

TEST_CASE("Commands of a drive come late, are missed or stay") {
  const auto late = wheels(driving_with(R"(<failure latency="0.03"/>)"), 5);
  CHECK(late[2] == 0.0);
  CHECK(late[3] == Approx(5.0));
  CHECK(wheels(driving_with(R"(<failure dropout="1"/>)"), 9).back() == 0.0);
  CHECK(wheels(driving_with(R"(<failure stuck_from="0"/>)"), 9).back() == 0.0);
  Simulation simulation = driving_with(R"(<failure stuck_from="0.05"/>)");
  for (int i = 0; i < 5; ++i) simulation.step();
  simulation.edit("robot[r1]/behavior[braitenberg]/@base", "1");
  for (int i = 0; i < 5; ++i) simulation.step();
  CHECK(rate(simulation) == Approx(5.0));
  CHECK(simulation.robot(0).command.forward == Approx(0.02));
}

TEST_CASE("A steered angle with noise stays within the limit of its joint") {
  Simulation simulation = driving(
      R"(<tricycle max_steer_deg="30"><noise on="front_wheel.angle" bias="2"/></tricycle>)");
  for (int i = 0; i < 50; ++i) simulation.step();
  CHECK(simulation.robot(0).joints[0].angle_rad == Approx(radians(30.0)));
}

TEST_CASE("Noise of a drive is edited in place, and its stream goes on") {
  const std::string noise = R"(<noise on="left_wheel.rate" gaussian="0.3"/>)";
  Simulation plain = driving_with(noise);
  Simulation edited = driving_with(noise);
  for (int i = 0; i < 10; ++i) {
    plain.step();
    edited.step();
  }
  edited.edit("robot[r1]/drive/noise[1]/@gaussian", "0.6");
  plain.step();
  edited.step();
  CHECK(rate(edited) - 5.0 == Approx(2.0 * (rate(plain) - 5.0)));
  edited.edit("robot[r1]/@max_speed", "0.3");  // what is under way stays
  CHECK(rate(edited) - 5.0 == Approx(2.0 * (rate(plain) - 5.0)));
}

TEST_CASE("Another noise of a drive changes nothing else, and a reset repeats the run") {
  const std::string left = R"(<noise on="left_wheel.rate" gaussian="0.3"/>)";
  const std::string right = R"(<noise on="right_wheel.rate" uniform="0.3"/>)";
  CHECK(wheels(driving_with(left + right), 50) == wheels(driving_with(left), 50));
  Simulation simulation = driving_with(left + right + "<failure dropout=\"0.3\"/>", {.seed = 3});
  const auto run = [&] {
    for (int i = 0; i < 50; ++i) simulation.step();
    return simulation.state_hash();
  };
  const auto first = run();
  simulation.reset(3);
  CHECK(run() == first);
}

TEST_CASE("A disturbance that does not fit a drive is refused with what there is") {
  CHECK_THAT(why_no_drive(R"(<differential><noise on="left.rate"/></differential>)"),
             Catch::Contains("its <noise on=\"left.rate\"> names no number of its joints") &&
                 Catch::Contains("left_wheel.rate") && Catch::Contains("small.xml:1"));
  CHECK_THAT(why_no_drive(R"(<differential><noise on="left_wheel.angle"/></differential>)"),
             Catch::Contains("names no number of its joints"));
  CHECK_THAT(why_no_drive(R"(<differential><failure latency="1e9"/></differential>)"),
             Catch::Contains("no command arrives before the run ends"));
  CHECK_THAT(
      why_no_drive(R"(<differential><noise on="left_wheel.rate" clamp="1"/></differential>)"),
      Catch::Contains("a clamp that is no range"));
}
