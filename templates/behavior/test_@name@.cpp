#include <elsie/testing/catch.h>

using namespace elsie::testing;

TEST_CASE("It drives on where all is clear") {
  Behavior @name@("@name@");
  CHECK_THAT(@name@.respond(Situation().beam(0, 1.0)), drives_straight_on() && commands_wheels(10, 10));
}

TEST_CASE("It stops in front of obstacles") {
  Behavior @name@("@name@", {{"distance", 0.4}});
  CHECK_THAT(@name@.respond(Situation().beam(0, 0.3)), commands_wheels(5, 5, 1e-6));
  CHECK_THAT(@name@.respond(Situation().beam(0, 0.2)), stands());
}

TEST_CASE("It keeps its promises, whatever it is given") {
  CHECK_THAT(check_plugin(elsie::PluginKind::behavior, "@name@"), finds_nothing());
}
