#include <elsie/testing/catch.h>

#include "@name@_command.h"

using namespace elsie::testing;

TEST_CASE("It shines while it is on") {
  Actuator @name@("@name@", {{"intensity", 0.7}});
  CHECK_FALSE(@name@.hold().shine);
  CHECK(@name@.act(@Class@Command{true}).intensity == 0.7);
  CHECK(@name@.hold().shine);
  CHECK_FALSE(@name@.act(@Class@Command{false}).shine);
}

TEST_CASE("Both keep their promises, whatever they are given") {
  CHECK_THAT(check_plugin(elsie::PluginKind::actuator, "@name@"), finds_nothing());
  CHECK_THAT(check_plugin(elsie::PluginKind::behavior, "use_@name@"), finds_nothing());
}
