#include <elsie/testing/catch.h>

using namespace elsie::testing;

TEST_CASE("The most active behaviour drives") {
  Team team;
  team.member("calm", 1, active(0.2, wheels(10, 10))).member("alarmed", 1, active(0.9, wheels(-5, 5)));
  Coordinator @name@("@name@", team);
  CHECK_THAT(@name@.decide(), commands_wheels(-5, 5));
  CHECK(team.trace("alarmed").share == 1.0);
  CHECK(team.trace("calm").share == 0.0);
}

TEST_CASE("A small difference does not change the winner") {
  Team team;
  team.member("one", 1, active(0.5, wheels(10, 10))).member("other", 1, active(0.55, wheels(-5, 5)));
  Coordinator @name@("@name@", team, {{"margin", 0.1}});
  CHECK_THAT(@name@.decide(), commands_wheels(10, 10));
  team.next_step().answer(1).activation = 0.65;
  CHECK_THAT(@name@.decide(), commands_wheels(-5, 5));
}

TEST_CASE("Without behaviours it stands") {
  Team nobody;
  Coordinator @name@("@name@", nobody);
  CHECK_THAT(@name@.decide(), stands());
}

TEST_CASE("It keeps its promises, whatever it is given") {
  CHECK_THAT(check_plugin(elsie::PluginKind::coordinator, "@name@"), finds_nothing());
}
