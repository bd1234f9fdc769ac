#include <cmath>

#include "support.h"

using namespace elsie;
using elsie::test::active;
using elsie::test::Coordinated;
using elsie::test::Team;

TEST_CASE("Vector summation divides the sum of the commands by the number of behaviours") {
  Team team;
  team.member("a", 1, MotorCommand{20, 20})
      .member("b", 5, MotorCommand{-4, 10})
      .member("c", 1, active(0.0, {2, 0}));  // active or not
  Coordinated robot("fusion_vector_summation", team);
  CHECK(robot.decide() == MotorCommand{6, 10});
}

TEST_CASE("Weighted vector summation takes each command times its priority") {
  Team team;
  team.member("a", 0.5, MotorCommand{20, 20}).member("b", 2, MotorCommand{-5, 10});
  Coordinated robot("fusion_vector_summation", team, {{"weighted", true}});
  // (0.5 x (20, 20) + 2 x (-5, 10)) / 2
  CHECK(robot.decide() == MotorCommand{0, 15});
  CHECK(team.trace(0).weight == 0.5);
  CHECK(team.trace(0).share + team.trace(1).share == Approx(1.0));
  CHECK(team.trace(0).share == Approx(std::sqrt(200.0) / (std::sqrt(200.0) + std::sqrt(500.0))));
}

TEST_CASE("A priority of zero adds nothing but counts in the number; one below zero repels") {
  Team team;
  team.member("a", 0, MotorCommand{20, 20}).member("b", -1, MotorCommand{4, 8});
  Coordinated robot("fusion_vector_summation", team, {{"weighted", true}});
  CHECK(robot.decide() == MotorCommand{-2, -4});
  CHECK(team.trace(1).weight == -1.0);
  CHECK(team.trace(1).share == 1.0);
  CHECK(team.reason(0) == "priority zero");
}

TEST_CASE("Behaviours that all say 'stop' have their shares in it, too") {
  Team team;
  team.member("a", 1, MotorCommand{}).member("b", 3, MotorCommand{});
  Coordinated robot("fusion_vector_summation", team, {{"weighted", true}});
  CHECK(robot.decide() == MotorCommand{});
  CHECK(team.trace(0).share == 0.25);
  CHECK(team.trace(1).share == 0.75);
}
