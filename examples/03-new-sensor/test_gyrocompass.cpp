#include <elsie/testing/catch.h>

#include "gyrocompass_reading.h"

namespace testing = elsie::testing;
using elsie::radians;

TEST_CASE("The gyrocompass tells which way the robot looks, and how far it is off") {
  testing::Surroundings field;
  field.at(1, 2, 30);
  testing::Sensor exact("gyrocompass");
  CHECK(exact.sense<GyrocompassReading>(field).heading_rad == Approx(radians(30)));
  testing::Sensor off("gyrocompass", {{"deviation_deg", 10}});
  CHECK(off.sense<GyrocompassReading>(field).heading_rad == Approx(radians(40)));
}

TEST_CASE("Noise is drawn from the seed") {
  testing::Sensor noisy("gyrocompass", {{"error_deg", 5}});
  const double first = noisy.sense<GyrocompassReading>(testing::Surroundings()).heading_rad;
  noisy.reset(1);
  CHECK(noisy.sense<GyrocompassReading>(testing::Surroundings()).heading_rad == first);
  noisy.reset(2);
  CHECK(noisy.sense<GyrocompassReading>(testing::Surroundings()).heading_rad != first);
}

TEST_CASE("The behaviour turns to its course, the short way round") {
  testing::Behavior hold("hold_course", {{"course_deg", 170}});
  const auto heading = [](double heading_deg) {
    return testing::Situation().reading(GyrocompassReading{radians(heading_deg)});
  };
  CHECK_THAT(hold.respond(heading(170)), testing::drives_straight_on());
  CHECK_THAT(hold.respond(heading(100)), testing::turns_left());
  CHECK_THAT(hold.respond(heading(-170)), testing::turns_right());
}

TEST_CASE("Nothing else is wrong with either") {
  CHECK_THAT(testing::check_plugin(elsie::PluginKind::sensor, "gyrocompass"),
             testing::finds_nothing());
  CHECK_THAT(testing::check_plugin(elsie::PluginKind::behavior, "hold_course"),
             testing::finds_nothing());
}
