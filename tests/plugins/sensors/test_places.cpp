// Sensors of the robot's own place and motion.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "elsie/readings/battery.h"
#include "elsie/readings/compass.h"
#include "elsie/readings/gps.h"
#include "elsie/readings/imu.h"
#include "elsie/readings/odometer.h"
#include "elsie/testing/sensor.h"

using namespace elsie;
using testing::Sensor;
using testing::Surroundings;

TEST_CASE("A compass tells its heading, and where north is") {
  Sensor compass("compass");
  const auto& reading = compass.sense<CompassReading>(Surroundings().at(3, 2, 30));
  CHECK(reading.heading_rad == Approx(radians(30)));
  CHECK(reading.north_rad == Approx(radians(60)));
  compass.turned(180);
  CHECK(compass.sense<CompassReading>(Surroundings().at(0, 0, 30)).heading_rad ==
        Approx(radians(-150)));
}

TEST_CASE("Satellite navigation tells the place of the sensor, not of the robot") {
  Sensor gps("gps");
  gps.mounted({{0.1, 0.0, 0.2}, 0.0, 0.0});
  const auto& reading =
      gps.sense<GpsReading>(Surroundings().at(1, 2, 90).moving({{0.3, 0.4, 0.0}, {}}));
  CHECK(reading.x_m == Approx(1.0));
  CHECK(reading.y_m == Approx(2.1));
  CHECK(reading.z_m == Approx(0.2));
  CHECK(reading.speed_m_s == Approx(0.5));
}

TEST_CASE("An inertial unit at rest reads gravity upwards, along its own axes") {
  Sensor imu("imu");
  auto reading = imu.sense<ImuReading>(Surroundings());
  CHECK(reading.acceleration_m_s2[2] == Approx(9.81));
  CHECK(reading.acceleration_m_s2[0] == Approx(0.0).margin(1e-12));
  imu.turned(0, 90);  // it looks up
  reading = imu.sense<ImuReading>(Surroundings());
  CHECK(reading.acceleration_m_s2[0] == Approx(9.81));
}

TEST_CASE("An inertial unit off the middle of a turning body reads w squared r, inwards") {
  // The robot turns about its origin with w; the sensor is r ahead of it.
  constexpr double kTurn = 2.0, kArm = 0.5, kPeriod = 0.01;
  Sensor imu("imu");
  imu.mounted({{kArm, 0.0, 0.0}, 0.0, 0.0});
  ImuReading reading;
  for (int i = 0; i < 3; ++i) {
    const double heading = degrees(i * kTurn * kPeriod);
    reading =
        imu.sense<ImuReading>(Surroundings().at(0, 0, heading).moving({{}, {0.0, 0.0, kTurn}}));
  }
  CHECK(reading.acceleration_m_s2[0] == Approx(-kTurn * kTurn * kArm).epsilon(0.001));
  CHECK(std::abs(reading.acceleration_m_s2[1]) < 0.03);  // half a period late
  CHECK(reading.turning_rad_s[2] == Approx(kTurn));
}

TEST_CASE("An odometer adds up the paths of the wheels, in whole counts of its encoders") {
  Surroundings road;
  road.carrier.odometry = {0.2, 0.0, 0.5};
  Sensor fine("odometer"), coarse("odometer", {{"tick", 0.001}});
  OdometerReading smooth, counted;
  double forward = 0.0, counted_turn = 0.0;
  for (int i = 0; i < 100; ++i) {
    smooth = fine.sense<OdometerReading>(road);
    counted = coarse.sense<OdometerReading>(road);
    forward += smooth.forward_m;
    counted_turn += counted.turn_rad;
  }
  // In a second, with half an axle a: forward -+ turn a.
  const double half_axle = road.carrier.wheels.half_axle;
  CHECK(smooth.left_m == Approx(0.2 - 0.5 * half_axle));
  CHECK(smooth.right_m == Approx(0.2 + 0.5 * half_axle));
  CHECK(forward == Approx(0.2));
  CHECK(counted.left_m == Approx(std::floor(smooth.left_m * 1000) / 1000));
  CHECK(counted_turn == Approx(0.5).margin(0.001 / half_axle));
}

TEST_CASE("The battery's charge is a fraction of its capacity") {
  Surroundings room;
  room.carrier.energy = 1000.0;
  room.carrier.capacity = 4000.0;
  room.carrier.charging = true;
  Sensor battery("battery");
  const auto& reading = battery.sense<BatteryReading>(room);
  CHECK(reading.charge == 0.25);
  CHECK(reading.energy == 1000.0);
  CHECK(reading.charging);
}
