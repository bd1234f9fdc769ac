#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("Suppression runs only the behaviour of highest priority and passes its command on") {
  Team team;
  team.member("low", 1, wheels(1, 2))
      .member("high", 3, wheels(5, 6))
      .member("middle", 2, wheels(3, 4));
  Coordinated robot("arbiter_suppression", team);
  CHECK(rates(robot.decide()) == WheelRates{5, 6});
  CHECK(team.asked(0) == 0);
  CHECK(team.asked(1) == 1);
  CHECK(team.asked(2) == 0);

  CHECK(team.trace(1).asked);
  CHECK(team.trace(1).share == 1.0);
  CHECK(team.reason(1) == "highest priority");
  CHECK(team.trace(0).share == 0.0);
  CHECK(team.trace(0).inhibited_by == 1);
  CHECK(team.reason(0) == "suppressed");
}

TEST_CASE(
    "With suppression the first in the file wins a tie, and an inactive winner still decides") {
  Team team;
  team.member("a", -1, active(0.0, wheels(7, 8))).member("b", -1, wheels(1, 1));
  Coordinated robot("arbiter_suppression", team);
  CHECK(rates(robot.decide()) == WheelRates{7, 8});
}
