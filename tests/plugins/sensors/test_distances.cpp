// Sensors of what is around the robot.
#include <cmath>

#include <catch2/catch.hpp>

#include "elsie/readings/bumper.h"
#include "elsie/readings/depth.h"
#include "elsie/readings/infrared.h"
#include "elsie/readings/lidar.h"
#include "elsie/testing/sensor.h"

using namespace elsie;

namespace {

/// A wall across the world at this x, seen from a sensor at the origin, as high as the wall's
/// middle.
testing::Surroundings wall_at(double x) {
  testing::Surroundings room;
  room.wall(x + 0.005, -20, x + 0.005, 20);  // its middle is on the line, and it is 1 cm thick
  return room;
}

testing::Sensor in_the_middle(const std::string& name, const testing::Settings& settings) {
  testing::Sensor sensor(name, settings);
  sensor.mounted({{0.0, 0.0, 0.1}, 0.0, 0.0});
  return sensor;
}

}  // namespace

TEST_CASE("A lidar measures x / cos(azimuth) to a wall, from left to right") {
  testing::Sensor lidar = in_the_middle("lidar", {{"rays", 91}, {"fov_deg", 90}, {"max_range", 8}});
  const auto reading = lidar.sense<LidarReading>(wall_at(1.0));
  REQUIRE(reading.ranges_m.size() == 91);
  CHECK(reading.azimuth_rad(0) == Approx(radians(45)));
  CHECK(reading.azimuth_rad(90) == Approx(radians(-45)));
  for (std::size_t i = 0; i < 91; ++i) {
    CHECK(reading.ranges_m[i] == Approx(1.0 / std::cos(reading.azimuth_rad(i))).epsilon(1e-9));
  }
}

TEST_CASE("A lidar all around has evenly spaced rays, and its range where nothing is") {
  testing::Sensor lidar = in_the_middle("lidar", {{"rays", 8}, {"max_range", 3}});
  const auto reading = lidar.sense<LidarReading>(wall_at(1.0));
  CHECK(reading.step_rad == Approx(radians(45)));
  CHECK(reading.azimuth_rad(0) == Approx(radians(157.5)));
  CHECK(reading.ranges_m[0] == 3.0);
  CHECK(reading.ranges_m[3] == Approx(1.0 / std::cos(radians(22.5))));
}

TEST_CASE("A lidar of one ray looks ahead") {
  testing::Sensor lidar = in_the_middle("lidar", {{"rays", 1}});
  CHECK(lidar.sense<LidarReading>(wall_at(1.0)).ranges_m[0] == Approx(1.0));
}

TEST_CASE("A depth camera measures along the rays of its pixels") {
  testing::Sensor depth =
      in_the_middle("depth", {{"width", 4}, {"height", 2}, {"fov_deg", 90}, {"max_range", 2}});
  const auto reading = depth.sense<DepthReading>(wall_at(0.1));
  // At half the width from the pinhole, pixel middles are 0.5 and 1.5 pixels aside and 0.5 up.
  for (int column = 0; column < 4; ++column) {
    const double left = 2.0 - column - 0.5;
    CHECK(reading.depth_m(column, 0) ==
          Approx(0.1 * std::sqrt(4.0 + left * left + 0.25) / 2.0).epsilon(1e-9));
  }
  CHECK(reading.picture.bytes.size() == 8);
  CHECK(reading.picture.bytes[1] > reading.picture.bytes[0]);  // nearer, so brighter
}

TEST_CASE("Infra-red sensors have the laws of their robots") {
  const auto value = [](const char* law, double distance) {
    testing::Sensor sensor = in_the_middle("infrared", {{"law", law}});
    return sensor.sense<InfraredReading>(wall_at(distance)).value;
  };
  CHECK(value("khepera", 0.02) == Approx(450));
  CHECK(value("khepera", 0.025) == Approx(0.5 * (450 + 275)));
  CHECK(value("khepera", 0.005) == 1000);
  CHECK(value("khepera", 0.11) == 0);
  CHECK(value("khepera_iv", 0.03) == 1);
  CHECK(value("khepera_iv", 0.06) == Approx(4.14 * std::exp(-33 * 0.06) - 0.085));
  CHECK(value("khepera_iv", 0.13) == 0);
  CHECK(value("epuck", 0.03) == Approx(298.701 * 0.0009 - 36.8961 * 0.03 + 1.08212));
  CHECK(value("epuck", 0.06) == 0);
  CHECK(value("footbot", 0.005) == 1);
  CHECK(value("footbot", 0.05) == Approx(0.0100527 / (0.05 + 0.000163144)));
  CHECK(value("enki", 0.05) == Approx(1200 * (7 - 0.81) / (25 + 2 * 0.9 * 5 + 7)));
  testing::Sensor sensor = in_the_middle("infrared", {{"law", "enki"}});
  CHECK(sensor.sense<InfraredReading>(wall_at(0.05)).largest == Approx(1200 * (7 - 0.81) / 7));
}

TEST_CASE("An infra-red sensor of three rays has the mean of their values") {
  testing::Sensor one = in_the_middle("infrared", {{"law", "enki"}});
  testing::Sensor three =
      in_the_middle("infrared", {{"law", "enki"}, {"rays", 3}, {"spread_deg", 60}});
  const auto at = [&](double distance) {
    return one.sense<InfraredReading>(wall_at(distance)).value;
  };
  const double aslant = at(0.05 / std::cos(radians(30)));
  CHECK(three.sense<InfraredReading>(wall_at(0.05)).value == Approx((at(0.05) + 2 * aslant) / 3));
}

TEST_CASE("A bumper feels what touches its part of the body") {
  testing::Sensor front("bumper", {{"fov_deg", 120}}), back("bumper", {{"fov_deg", 120}});
  front.turned(0);
  back.turned(180);
  testing::Surroundings room;
  room.box(0.2, 0).touch({0.05, 0.01, 0.05}, {-1, 0, 0}, 0.02);
  CHECK(front.sense<BumperReading>(room).pressed);
  CHECK(front.sense<BumperReading>(room).force_n == Approx(0.02 / 0.01));
  CHECK_FALSE(back.sense<BumperReading>(room).pressed);
  room.at(0, 0, 180);
  CHECK(back.sense<BumperReading>(room).pressed);
  // A flat front that meets a wall is touched at its corners.
  testing::Sensor narrow("bumper", {{"fov_deg", 20}});
  narrow.turned(0);
  testing::Surroundings wall;
  wall.box(0.2, 0).touch({0.04, 0.04, 0.05}, {-1, 0, 0}, 0.02);
  CHECK(narrow.sense<BumperReading>(wall).pressed);
  narrow.turned(90);
  CHECK_FALSE(narrow.sense<BumperReading>(wall).pressed);
  testing::Sensor stiff("bumper", {{"least_force", 5}}), segment("bumper", {{"fov_deg", 360}});
  segment.mounted({{0.04, 0.0, 0.09}, 0.0, 0.0, 1});
  room.at(0, 0, 0);
  CHECK_FALSE(stiff.sense<BumperReading>(room).pressed);
  CHECK_FALSE(segment.sense<BumperReading>(room).pressed);
  room.touch({-0.3, 0, 0.05}, {1, 0, 0}, 0.01, 1);
  CHECK(segment.sense<BumperReading>(room).pressed);
}
