#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {
plugin::Object<Behavior> to(double x, double y) {
  return test::make<Behavior>(PluginKind::behavior, "go_to_point", {{"x", x}, {"y", y}});
}
}  // namespace

TEST_CASE("A place far ahead is driven to straight, at full speed") {
  Situation now;
  const WheelRates command = rates(to(2, 0)->respond(now.perception()).command);
  CHECK(command.left == Approx(0.4 / 0.02));
  CHECK(command.right == Approx(command.left));
}

TEST_CASE("It turns towards a place on either side, and in place when it lies behind") {
  Situation now;
  const WheelRates left = rates(to(1, 1)->respond(now.perception()).command);
  CHECK(left.right > left.left);
  const WheelRates right = rates(to(1, -1)->respond(now.perception()).command);
  CHECK(right.left == Approx(left.right));
  const WheelRates behind = rates(to(-1, 0.001)->respond(now.perception()).command);
  CHECK(behind.left == Approx(-behind.right));
}

TEST_CASE("It slows down near the place, stops there, and says once that it has arrived") {
  Situation now;
  const auto behavior = to(0, 0);
  now.at(-0.15, 0, 0);
  CHECK(rates(behavior->respond(now.perception()).command).left == Approx(10.0));
  CHECK(behavior->respond(now.perception()).status == Status::running);
  now.at(-0.04, 0, 0);
  const Response first = behavior->respond(now.perception());
  CHECK(first.command == Motion{});
  CHECK(first.activation == 0.0);
  CHECK(first.status == Status::success);
  REQUIRE(first.events.size() == 1);
  CHECK(first.events[0].name == "arrived");
  CHECK(behavior->respond(now.perception()).events.empty());
}
