#include <cmath>

#include <catch2/catch.hpp>

#include "schemas.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("Noise keeps its length and its direction in the world, each for the persistence") {
  for (const double period : {1e-3, 0.01, 0.1}) {
    Puppet robot("noise", {{"gain", 0.2}, {"persistence", 0.5}});
    Vector2 last;
    double changed_s = -1.0;
    int changes = 0;
    while (robot.time_s < 20.0 - 0.5 * period) {
      robot.at(0.0, 0.0, 100.0 * robot.time_s);  // it turns as it likes
      const Vector2 now = robot.velocity();
      REQUIRE(std::hypot(now.x, now.y) == Approx(0.2));
      if (std::hypot(now.x - last.x, now.y - last.y) > 1e-6) {
        if (changes > 0) CHECK(robot.time_s - changed_s == Approx(0.5).margin(1e-6));
        changed_s = robot.time_s;
        last = now;
        ++changes;
      }
      robot.time_s += period;
    }
    CHECK(changes == 40);
  }
}

TEST_CASE("Its directions are uniform: the way grows with the root of the number of steps") {
  // A walk of n steps of length l has a mean square of n l^2; over 400 walks its relative standard
  // deviation is 0.05.
  double squares = 0.0;
  Puppet robot("noise", {{"gain", 0.2}, {"persistence", 1.0}});
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    robot.behavior.reset(seed);
    Vector2 way;
    for (int i = 0; i < 50; ++i) {
      robot.time_s = i;
      const Vector2 now = robot.velocity();
      way.x += now.x;
      way.y += now.y;
    }
    squares += way.x * way.x + way.y * way.y;
  }
  CHECK(squares / 400.0 == Approx(50.0 * 0.2 * 0.2).epsilon(0.2));
}

TEST_CASE("The same seed gives the same noise, also if it was not asked for a while") {
  Puppet one("noise", {}), other("noise", {});
  one.behavior.reset(7);
  other.behavior.reset(7);
  const Vector2 first = one.velocity();
  CHECK(other.velocity() == first);
  one.time_s = 0.5;
  CHECK(one.velocity() == first);
  one.time_s = other.time_s = 1.2;  // late, and both draw once
  const Vector2 second = one.velocity();
  CHECK(other.velocity() == second);
  CHECK_FALSE(second == first);
  one.behavior.reset(7);
  one.time_s = 0.0;
  CHECK(one.velocity() == first);
  CHECK_THROWS_WITH(testing::Behavior("noise", {{"gain", -1.0}}), Catch::Contains("gain"));
}

TEST_CASE("Its successor keeps the direction and the time") {
  testing::Behavior before("noise"), after("noise");
  const testing::Situation now = testing::Situation().time(0.4);
  const Motion motion = before.respond(now).command;
  CHECK(after.take_over(before));
  CHECK(after.respond(now).command == motion);
}

TEST_CASE("Noise gets a robot past a drum in front of which the other pulls cancel") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    CHECK(succeeds("noise", {}, seed));
    CHECK_FALSE(succeeds("noise", {"robot[r1]/behavior[noise]/@gain=0"}, seed));
  }
}
