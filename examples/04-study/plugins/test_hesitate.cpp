#include <elsie/testing/catch.h>

using namespace elsie::testing;

TEST_CASE("The nearer something is, the slower it drives") {
  Behavior hesitate("hesitate", {{"caution", 0.4}});
  CHECK_THAT(hesitate.respond(Situation().beam(0, 1.0)), commands_wheels(10, 10));
  CHECK_THAT(hesitate.respond(Situation().beam(0, 0.2)), commands_wheels(5, 5, 1e-6));
}

TEST_CASE("It never stops") {
  Behavior hesitate("hesitate");
  CHECK_THAT(hesitate.respond(Situation().beam(0, 0.0)), commands_wheels(3, 3, 1e-6));
}

TEST_CASE("It keeps its promises, whatever it is given") {
  CHECK_THAT(check_plugin(elsie::PluginKind::behavior, "hesitate"), finds_nothing());
}
