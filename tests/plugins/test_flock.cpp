#include <cmath>

#include <catch2/catch.hpp>

#include "group.h"

using namespace elsie;
using namespace elsie::test;

namespace {

plugin::Object<Behavior> flocking(Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "flock", std::move(parameters));
}

/// The way that it wants to drive, deg to the left; only these weights count.
double flock_wants_deg(const Situation& now, double separation, double alignment, double cohesion) {
  const auto behavior =
      flocking({{"separation", separation}, {"alignment", alignment}, {"cohesion", cohesion}});
  return degrees(behavior->respond(now.perception()).command.turn / 3.0);
}

double flock_publishes(const Behavior& behavior, const std::string& name) {
  for (const auto& each : test::shipped().find(PluginKind::behavior, "flock")->published) {
    if (each.name == name) return each.get(behavior);
  }
  throw std::runtime_error(name);
}

}  // namespace

TEST_CASE("flock: from random headings all soon drive the same way, and stay together") {
  for (const char* from : {"team", "messages"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      CAPTURE(from, seed);
      Group group("flock", {{"from", std::string(from)}}, Group::scattered(10, 0.7, seed), 1.0);
      const double start = group.mean_distance();
      REQUIRE(group.order() < 0.7);
      for (int i = 0; i < 6; ++i) {
        group.run(10.0);
        CHECK(group.mean_distance() < 1.5 * start);
        CHECK(group.least_distance() > 0.08);  // robots have bodies
      }
      CHECK(group.order() > 0.95);
    }
  }
}

TEST_CASE("flock: without alignment they mill about; without cohesion they come apart") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const auto start = Group::scattered(10, 0.7, seed);
    Group milling("flock", {{"alignment", 0.0}}, start, 1.0);
    milling.run(60.0);
    CHECK(milling.order() < 0.7);
    Group apart("flock", {{"alignment", 0.0}, {"cohesion", 0.0}}, start, 1.0);
    apart.run(60.0);
    CHECK(apart.mean_distance() > 5.0);
    Group near("flock", {{"separation", 0.0}}, start, 1.0);
    near.run(60.0);
    CHECK(near.least_distance() < 0.08);
  }
}

TEST_CASE("flock: any control period will do") {
  for (const double period : {1e-3, 1e-2, 0.1}) {
    CAPTURE(period);
    Group group("flock", {}, Group::scattered(5, 0.4, 2));
    group.run(20.0, period);
    CHECK(group.order() > 0.9);
  }
}

TEST_CASE("flock: each rule alone, added to driving straight on") {
  const auto angle = [](double ahead, double left) { return degrees(std::atan2(left, ahead)); };
  // One robot on the left, at half of the separation radius, that looks back.
  Situation now;
  now.mate("a", 0, 0.125, false, 180);
  CHECK(flock_wants_deg(now, 1, 0, 0) == Approx(angle(1.0, -0.5)));
  CHECK(flock_wants_deg(now, 0, 0.5, 0) == Approx(0.0).margin(1e-6));  // 1 - 0.5 ahead
  CHECK(flock_wants_deg(now, 0, 0, 1) == Approx(angle(1.0, 0.125)));
  // Alignment is the mean heading, however many there are; separation is a sum.
  now.mate("b", 0, -0.125, false, 90);
  CHECK(flock_wants_deg(now, 1, 0, 0) == Approx(0.0).margin(1e-6));
  CHECK(flock_wants_deg(now, 0, 1, 0) == Approx(angle(0.5, 0.5)));
  CHECK(flock_wants_deg(now, 0, 0, 1) == Approx(0.0).margin(1e-6));
  // Those at the radii and beyond count for nothing.
  Situation far;
  far.mate("a", 0, 1.0, false, 90);
  CHECK(flock_wants_deg(far, 1, 1, 1) == Approx(0.0).margin(1e-6));
}

TEST_CASE("flock: one at its own place, and one that comes straight towards it") {
  Situation same, towards;
  same.mate("a", 0, 0, false, 180);
  towards.mate("a", 0.1, 0, false, 180);
  for (const Situation& now : {same, towards}) {
    const Motion command = flocking()->respond(now.perception()).command;
    CHECK(std::isfinite(command.forward));
    CHECK(std::isfinite(command.turn));
  }
}

TEST_CASE("flock: alone it drives straight on, and is not active") {
  const auto behavior = flocking();
  const Response response = behavior->respond(Situation().perception());
  CHECK(response.command == Motion{0.2, 0.0, 0.0});
  CHECK(response.activation == 0.0);
  CHECK(response.strength == 0.0);
  CHECK(std::isnan(flock_publishes(*behavior, "order")));
  CHECK(std::isnan(flock_publishes(*behavior, "bearing")));
}

TEST_CASE("flock: it publishes the order around it") {
  const auto behavior = flocking();
  Situation now;
  now.at(0, 0, 90).mate("a", 0.5, 0, false, 90).mate("b", 0, 0.5, false, -90);
  behavior->respond(now.perception());
  CHECK(flock_publishes(*behavior, "order") == Approx(1.0 / 3.0));
  CHECK(flock_publishes(*behavior, "mates") == 2.0);
}

TEST_CASE("flock: what others say of their headings is from east, whatever the own heading") {
  const auto behavior = flocking({{"from", std::string("messages")},
                                  {"separation", 0.0},
                                  {"cohesion", 0.0},
                                  {"alignment", 1000.0}});
  Situation now;
  now.at(0, 0, 30).hear(HeadingMessage{static_cast<float>(radians(90))}, "", 0.5, 0);
  CHECK(behavior->respond(now.perception()).command.turn ==
        Approx(3.0 * radians(60)).epsilon(0.01));
}

TEST_CASE("flock: parameters that mean nothing are refused") {
  CHECK_THROWS_WITH(flocking({{"separation_radius", 0.0}}), Catch::Contains("separation_radius"));
  CHECK_THROWS_WITH(flocking({{"cohesion", -1.0}}), Catch::Contains("cohesion"));
}
