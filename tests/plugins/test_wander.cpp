#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("Wander keeps its mean speed and changes its direction now and then") {
  const auto wander = test::make<Behavior>(PluginKind::behavior, "wander",
                                           {{"speed", 12.0}, {"restlessness", 2.0}, {"turn", 4.0}});
  Situation now;
  int changes = 0;
  double bias = 0.0;
  const int steps = 100000;  // of 0.01 s
  for (int i = 0; i < steps; ++i) {
    const WheelRates command = rates(wander->respond(now.perception()).command);
    REQUIRE(command.left + command.right == Approx(24.0));
    const double new_bias = 0.5 * (command.right - command.left);
    REQUIRE(std::abs(new_bias) <= 4.0);
    changes += new_bias != bias;
    bias = new_bias;
  }
  // Two a second on average, over 1000 s; the standard deviation of the count is about 45.
  CHECK(changes == Approx(2000).margin(200));
}

TEST_CASE("Wander goes straight on after a reset") {
  const auto wander =
      test::make<Behavior>(PluginKind::behavior, "wander", {{"restlessness", 1000.0}});
  Situation now;
  CHECK(rates(wander->respond(now.perception()).command).left != 10.0);
  const Declaration* declaration = test::shipped().find(PluginKind::behavior, "wander");
  plugin::apply_parameters(*declaration, *wander, {{"restlessness", 0.0}});
  CHECK(rates(wander->respond(now.perception()).command).left != 10.0);  // it keeps its direction
  Random random(1);
  wander->reset(random);
  CHECK(rates(wander->respond(now.perception()).command) == WheelRates{10, 10});
}
