#include <elsie/testing/catch.h>

#include "@name@_reading.h"

using namespace elsie::testing;

TEST_CASE("It sees less with the square of the distance") {
  Sensor @name@("@name@", {{"lamp_x", 2.04}});  // the sensor is 4 cm ahead of the robot's middle
  CHECK(@name@.sense<@Class@Reading>(Surroundings().at(2, 0)).brightness == Approx(1.0));
  CHECK(@name@.sense<@Class@Reading>(Surroundings().at(1, 0)).brightness == Approx(0.5));
  CHECK(@name@.sense<@Class@Reading>(Surroundings().at(0, 0)).brightness == Approx(0.2));
}

TEST_CASE("The behaviour turns to the side that is brighter") {
  Behavior seek("seek_@name@");
  const auto sees = [](double left, double right) {
    return Situation().reading(@Class@Reading{left}, 45).reading(@Class@Reading{right}, -45);
  };
  CHECK_THAT(seek.respond(sees(0.5, 0.5)), drives_straight_on());
  CHECK_THAT(seek.respond(sees(0.6, 0.4)), turns_left());
  CHECK_THAT(seek.respond(sees(0.4, 0.6)), turns_right());
}

TEST_CASE("Both keep their promises, whatever they are given") {
  CHECK_THAT(check_plugin(elsie::PluginKind::sensor, "@name@"), finds_nothing());
  CHECK_THAT(check_plugin(elsie::PluginKind::behavior, "seek_@name@"), finds_nothing());
}
