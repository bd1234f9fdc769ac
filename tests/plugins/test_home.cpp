#include <cmath>

#include <catch2/catch.hpp>

#include "group.h"

using namespace elsie;
using namespace elsie::test;

namespace {

plugin::Object<Behavior> homing(Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "home", std::move(parameters));
}

}  // namespace

TEST_CASE("home: in the end all are at home") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const double period : {1e-2, 0.1}) {
      CAPTURE(seed, period);
      Group group("home", {{"x", 1.0}, {"y", -2.0}}, Group::scattered(8, 3.0, seed));
      group.run(60.0, period);
      for (const Pose& pose : group.poses()) CHECK(std::hypot(pose.x - 1.0, pose.y + 2.0) <= 0.21);
    }
  }
  Group turned("home", {{"gain", 0.0}}, Group::scattered(8, 3.0, 1));
  turned.run(60.0);
  CHECK(turned.radius() > 1.0);
}

TEST_CASE("home: the nest of the team comes before the place") {
  const auto behavior = homing({{"x", 0.0}, {"y", 5.0}});
  Situation now;
  CHECK(behavior->respond(now.perception()).command.turn == Approx(3.0 * radians(90)));
  now.nest(0, -5);
  CHECK(behavior->respond(now.perception()).command.turn == Approx(-3.0 * radians(90)));
  // The nest has a radius of its own: 0.5 m.
  now.at(0, -4.51, 0);
  const Response in = behavior->respond(now.perception());
  REQUIRE(in.events.size() == 1);
  CHECK(in.events[0].name == "at_home");
}

TEST_CASE("home: it drives in, stops in the inner half, and stays until it has left home") {
  const auto behavior = homing();
  const auto at = [&](double x) {
    Situation now;
    return behavior->respond(now.at(x, 0, 180).perception());
  };
  CHECK(at(2.0).command.forward == Approx(0.4));
  CHECK(at(0.41).events.empty());
  const Response rim = at(0.39);
  CHECK(rim.command.forward == Approx(0.4));
  CHECK(rim.activation == 1.0);
  REQUIRE(rim.events.size() == 1);
  CHECK(rim.events[0].name == "at_home");
  CHECK(at(0.25).command.forward == Approx(0.4 * 0.25 / 0.3));
  for (const double x : {0.19, 0.0, 0.3, 0.39}) {
    CAPTURE(x);
    const Response stands = at(x);
    CHECK(stands.command == Motion{});
    CHECK(stands.activation == 0.0);
    CHECK(stands.events.empty());
  }
  const Response out = at(0.41);
  CHECK(out.command.forward == Approx(0.4));
  REQUIRE(out.events.size() == 1);
  CHECK(out.events[0].name == "left_home");
  CHECK(at(0.39).command.forward > 0.0);
}

TEST_CASE("home: a reset forgets that it was at home") {
  const auto behavior = homing();
  Situation now;
  CHECK(behavior->respond(now.perception()).events.size() == 1);
  CHECK(behavior->respond(now.perception()).events.empty());
  Random random;
  behavior->reset(random);
  CHECK(behavior->respond(now.perception()).events.size() == 1);
}

TEST_CASE("home: parameters that mean nothing are refused") {
  CHECK_THROWS_WITH(homing({{"radius", 0.0}}), Catch::Contains("radius"));
  CHECK_THROWS_WITH(homing({{"stop_within", 1.5}}), Catch::Contains("stop_within"));
}
