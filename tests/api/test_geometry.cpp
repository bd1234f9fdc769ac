#include <numbers>

#include <catch2/catch.hpp>

#include "elsie/api/geometry.h"
#include "elsie/api/perception.h"

using namespace elsie;

TEST_CASE("Angles wrap into (-180, 180] degrees") {
  CHECK(degrees(wrap_angle(radians(190))) == Approx(-170));
  CHECK(degrees(wrap_angle(radians(-190))) == Approx(170));
  CHECK(degrees(wrap_angle(radians(720 + 30))) == Approx(30));
  CHECK(wrap_angle(-std::numbers::pi) == Approx(std::numbers::pi));
  CHECK(wrap_angle(std::numbers::pi) == Approx(std::numbers::pi));
}

TEST_CASE("A bearing is relative to the heading and positive to the left") {
  CHECK(degrees(bearing({0, 0, 0}, 1, 1)) == Approx(45));
  CHECK(degrees(bearing({1, 1, radians(90)}, 2, 1)) == Approx(-90));
  CHECK(degrees(bearing({0, 0, radians(170)}, -1, -0.1)) == Approx(15.7106).epsilon(1e-4));
}

TEST_CASE("A turned frame looks along its yaw, and up with positive pitch") {
  const Frame frame = Frame::turned({1, 2, 3}, radians(90), radians(30));
  CHECK(frame.forward.x == Approx(0).margin(1e-12));
  CHECK(frame.forward.y == Approx(std::cos(radians(30))));
  CHECK(frame.forward.z == Approx(0.5));
  CHECK(dot(frame.forward, frame.left) == Approx(0).margin(1e-12));
  CHECK(dot(frame.forward, frame.up) == Approx(0).margin(1e-12));
  CHECK(frame.point({1, 0, 0}).z == Approx(3.5));
}

TEST_CASE("A frame within a frame") {
  const Frame robot = Frame::turned({10, 0, 0}, radians(90), 0);
  const Frame sensor = Frame::turned({0.1, 0, 0.05}, radians(90), 0);
  const Frame in_world = robot.frame(sensor);
  CHECK(in_world.origin.x == Approx(10));
  CHECK(in_world.origin.y == Approx(0.1));
  CHECK(in_world.forward.x == Approx(-1));
}

TEST_CASE("Kinematics of the differential drive, and back") {
  OwnState self;
  self.wheels = {.radius = 0.02, .half_axle = 0.05};
  const Motion straight = self.wheels.motion({20, 20});
  CHECK(straight.forward == Approx(0.4));
  CHECK(straight.lateral == 0.0);
  CHECK(straight.turn == 0.0);
  const WheelRates turn = self.wheels.wheel_rates({0.0, 0.3, 1.0});
  CHECK(turn.left == Approx(-2.5));
  CHECK(turn.right == Approx(2.5));
  const WheelRates back = self.wheels.wheel_rates(self.wheels.motion({3, -7}));
  CHECK(back.left == Approx(3));
  CHECK(back.right == Approx(-7));
  CHECK(self.max_wheel_rate() == Approx(25));
}

TEST_CASE("Motions are apart by their wheel rates and their lateral speed") {
  const WheelPair wheels;
  CHECK(wheels.distance_squared(wheels.motion({3, 4}), {}) == Approx(25));
  CHECK(wheels.distance_squared(wheels.motion({10, 10}), wheels.motion({10, 5})) == Approx(25));
  Motion aside = wheels.motion({3, 4});
  aside.lateral = 0.1;  // as fast as a wheel of 0.02 m at 5 rad/s
  CHECK(wheels.distance_squared(aside, {}) == Approx(50));
}
