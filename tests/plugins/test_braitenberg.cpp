#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {
plugin::Object<Behavior> vehicle(test::Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "braitenberg", std::move(parameters));
}
}  // namespace

TEST_CASE("A Braitenberg vehicle sums weight times excitation, range sensors first") {
  const auto behavior =
      vehicle({{"base", 5.0}, {"weights", std::vector<double>{1, 2, 3, 4, 10, 20}}});
  Situation now;
  now.proximity(0, true).beam(30, 0.5).beam(-30, 0.75);
  behavior->equipped(now.perception());
  // 5 + 0.5 x (1, 2) + 0.25 x (3, 4) + 1 x (10, 20)
  const WheelRates command = rates(behavior->respond(now.perception()).command);
  CHECK(command.left == Approx(16.25));
  CHECK(command.right == Approx(27.0));
}

TEST_CASE("Without weights it turns away from the side that sees something") {
  const auto behavior = vehicle();
  Situation left, right, clear;
  left.beam(30, 0.2).beam(-30, 1.0);
  right.beam(30, 1.0).beam(-30, 0.2);
  clear.beam(30, 1.0).beam(-30, 1.0);
  behavior->equipped(left.perception());
  const WheelRates away_from_left = rates(behavior->respond(left.perception()).command);
  CHECK(away_from_left.left > away_from_left.right);
  const WheelRates away_from_right = rates(behavior->respond(right.perception()).command);
  CHECK(away_from_right.right == Approx(away_from_left.left));
  CHECK(away_from_right.left == Approx(away_from_left.right));
  CHECK(rates(behavior->respond(clear.perception()).command) == WheelRates{10, 10});
}

TEST_CASE("Weights that do not fit the robot's sensors are refused before the run") {
  Situation now;
  now.beam(30, 0.5).beam(-30, 0.75);
  CHECK_THROWS_WITH(
      vehicle({{"weights", std::vector<double>{1, 2, 3}}})->equipped(now.perception()),
      "weights has 3 numbers, but the robot's 2 sensors need two each, left and right: 4");
  Situation blind;
  CHECK_THROWS_WITH(
      vehicle()->equipped(blind.perception()),
      "it is wired to range, proximity and infra-red sensors, and the robot has none; add "
      "one");
}
