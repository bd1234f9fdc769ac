#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {
const Motion kA{1, 1}, kB{2, 2}, kC{3, 3};

void set(Team& team, double a, double b, double c) {
  team.answer(0).activation = a;
  team.answer(1).activation = b;
  team.answer(2).activation = c;
}
void fill(Team& team) { team.member("a", 1, kA).member("b", 4, kB).member("c", 0.5, kC); }
}  // namespace

TEST_CASE("The most active behaviour decides, whatever the priorities") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_action_selection", team);
  set(team, 0.3, 0.0, 0.8);
  CHECK(robot.decide() == kC);
  CHECK(team.trace(2).share == 1.0);
  CHECK(team.reason(2) == "highest activation");
  CHECK(team.trace(0).inhibited_by == 2);
  CHECK(team.reason(0) == "lower activation");
  CHECK(team.trace(1).inhibited_by == -1);  // it was not active
  CHECK(team.reason(1) == "not active");
  set(team, 0.3, 0.4, 0.2);
  CHECK(robot.decide() == kB);
}

TEST_CASE("Of equally active behaviours the first in the file decides, whoever did before") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_action_selection", team);
  set(team, 0.0, 0.5, 0.5);
  CHECK(robot.decide() == kB);
  CHECK(team.reason(2) == "equally active");
  set(team, 0.5, 0.5, 0.5);
  CHECK(robot.decide() == kA);
}

TEST_CASE("Activation may count times priority; nobody of priority zero is asked then") {
  Team team;
  fill(team);
  team.member("d", 0, wheels(4, 4));
  Coordinated robot("arbiter_action_selection", team, {{"by_priority", true}});
  set(team, 0.9, 0.3, 1.0);  // levels 0.9, 1.2, 0.5
  CHECK(robot.decide() == kB);
  CHECK(team.asked(3) == 0);
  CHECK(team.reason(3) == "priority not above zero");
}

TEST_CASE("With a margin, another must be more active by more than that to take over") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_action_selection", team, {{"margin", 0.25}});
  set(team, 0.5, 0.0, 0.0);
  CHECK(robot.decide() == kA);
  set(team, 0.5, 0.75, 0.0);
  CHECK(robot.decide() == kA);
  CHECK(team.reason(0) == "kept: margin");
  CHECK(team.reason(1) == "higher, but must wait");
  CHECK(team.trace(1).inhibited_by == 0);
  set(team, 0.5, 0.76, 0.0);
  CHECK(robot.decide() == kB);
  set(team, 0.76, 0.75, 0.0);  // and back needs a margin again
  CHECK(robot.decide() == kB);
  set(team, 0.1, 0.0, 0.0);  // an inactive behaviour keeps nobody waiting
  CHECK(robot.decide() == kA);
}

TEST_CASE("A margin keeps two behaviours of about the same activation from flickering") {
  for (const double margin : {0.0, 0.1}) {
    Team team;
    fill(team);
    Coordinated robot("arbiter_action_selection", team, {{"margin", margin}});
    int changes = 0;
    Motion last = kA;
    for (int step = 0; step < 100; ++step) {
      set(team, 0.5, step % 2 == 0 ? 0.45 : 0.55, 0.0);
      const Motion command = robot.decide_at(0.01 * step);
      changes += command != last;
      last = command;
    }
    CHECK(changes == (margin > 0.0 ? 0 : 99));
  }
}

TEST_CASE("Whoever took over decides for a minimum time, as long as it is active") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_action_selection", team, {{"hold", 0.5}});
  set(team, 0.5, 0.0, 0.0);
  CHECK(robot.decide_at(1.0) == kA);
  set(team, 0.5, 1.0, 0.0);
  CHECK(robot.decide_at(1.49) == kA);
  CHECK(team.reason(0) == "kept: minimum time");
  CHECK(robot.decide_at(1.5) == kB);
  set(team, 1.0, 0.0, 0.5);
  CHECK(robot.decide_at(1.51) == kA);  // b is no longer active
  set(team, 0.9, 0.0, 1.0);
  CHECK(robot.decide_at(2.0) == kA);
  CHECK(robot.decide_at(2.01) == kC);
}

TEST_CASE("What is not above the threshold takes no part") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_action_selection", team, {{"threshold", 0.2}});
  set(team, 0.2, 0.1, 0.2);
  CHECK(robot.decide() == Motion{});
  CHECK(team.reason(0) == "nobody is active");
  set(team, 0.2, 0.1, 0.21);
  CHECK(robot.decide() == kC);
}
