#include <cmath>

#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("Vector summation divides the sum of the commands by the number of behaviours") {
  Team team;
  team.member("a", 1, wheels(20, 20))
      .member("b", 5, wheels(-4, 10))
      .member("c", 1, active(0.0, wheels(2, 0)));  // active or not
  Coordinated robot("fusion_vector_summation", team);
  CHECK(rates(robot.decide()) == WheelRates{6, 10});
}

TEST_CASE("Weighted vector summation takes each command times its priority") {
  Team team;
  team.member("a", 0.5, wheels(20, 20)).member("b", 2, wheels(-5, 10));
  Coordinated robot("fusion_vector_summation", team, {{"weighted", true}});
  // (0.5 x (20, 20) + 2 x (-5, 10)) / 2
  CHECK(rates(robot.decide()) == WheelRates{0, 15});
  CHECK(team.trace(0).weight == 0.5);
  CHECK(team.trace(0).share + team.trace(1).share == Approx(1.0));
  CHECK(team.trace(0).share == Approx(std::sqrt(200.0) / (std::sqrt(200.0) + std::sqrt(500.0))));
}

TEST_CASE("A priority of zero adds nothing but counts in the number; one below zero repels") {
  Team team;
  team.member("a", 0, wheels(20, 20)).member("b", -1, wheels(4, 8));
  Coordinated robot("fusion_vector_summation", team, {{"weighted", true}});
  CHECK(rates(robot.decide()) == WheelRates{-2, -4});
  CHECK(team.trace(1).weight == -1.0);
  CHECK(team.trace(1).share == 1.0);
  CHECK(team.reason(0) == "priority zero");
}

TEST_CASE("Behaviours that all say 'stop' have their shares in it, too") {
  Team team;
  team.member("a", 1, Motion{}).member("b", 3, Motion{});
  Coordinated robot("fusion_vector_summation", team, {{"weighted", true}});
  CHECK(robot.decide() == Motion{});
  CHECK(team.trace(0).share == 0.25);
  CHECK(team.trace(1).share == 0.75);
}

TEST_CASE("Priorities of gain times number make it Arkin's sum of motor schemas") {
  // Vectors ahead and to the left, and gains. A schema's motion is linear in its vector.
  struct Schema {
    double ahead, left, gain;
  };
  const auto motion = [](double ahead, double left) { return Motion{ahead, 0.0, left / 0.05}; };
  const std::vector<Schema> schemas{{0.3, 0.0, 1.0}, {-0.1, 0.2, 2.5}, {0.0, -0.4, 0.5}, {0, 0, 3}};
  for (std::size_t n = 1; n <= schemas.size(); ++n) {
    Team team;
    double ahead = 0.0, left = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const Schema& schema = schemas[i];
      team.member("schema" + std::to_string(i), static_cast<double>(n) * schema.gain,
                  motion(schema.ahead, schema.left));
      ahead += schema.gain * schema.ahead;
      left += schema.gain * schema.left;
    }
    Coordinated robot("fusion_vector_summation", team, {{"weighted", true}});
    check_near(robot.decide(), motion(ahead, left));
  }
}
