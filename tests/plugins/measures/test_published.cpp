// Numbers that plugins publish, as a measure has them.
#include <cmath>
#include <limits>

#include "support.h"

using namespace elsie::test;

namespace {

Scene exploring() {
  Scene now;
  now.robot("r1").publishes("explore.known", "m2").robot("r2").publishes("explore.known", "m2");
  return now.robot("r3");
}

}  // namespace

TEST_CASE("A published number has a mean, a range and an end, over time and robots") {
  Scene now = exploring();
  Measure known("published", {{"number", "explore.known"}});
  known.observe(now);
  CHECK_FALSE(known.value("mean"));
  CHECK_FALSE(known.value("end"));
  for (int i = 1; i <= 10; ++i) {
    now.number("r1", "explore.known") = i;
    now.number("r2", "explore.known") = 2.0 * i;
    known.observe(now.step());
  }
  CHECK(known.value("mean") == Approx(1.5 * 5.5));
  CHECK(known.value("least") == 1.0);
  CHECK(known.value("greatest") == 20.0);
  CHECK(known.value("end") == Approx(15.0));
}

TEST_CASE("A number that does not exist for a while is left out") {
  Scene now = exploring();
  Measure known("published", {{"number", "explore.known"}, {"robot", "r1"}});
  known.observe(now);
  for (const double value : {2.0, std::numeric_limits<double>::quiet_NaN(), 4.0}) {
    now.number("r1", "explore.known") = value;
    known.observe(now.step());
  }
  CHECK(known.value("mean") == 3.0);
  now.number("r1", "explore.known") = std::numeric_limits<double>::quiet_NaN();
  known.observe(now.step());
  CHECK_FALSE(known.value("end"));
}

TEST_CASE("A number that a rule publishes is measured without a robot") {
  Scene now;
  now.publishes("respawn.returned").robot("r1");
  Measure returned("published", {{"number", "respawn.returned"}});
  returned.observe(now);
  now.number("", "respawn.returned") = 3.0;
  returned.observe(now.step());
  CHECK(returned.value("end") == 3.0);
  CHECK(refusal(Measure("published", {{"number", "respawn.returned"}, {"robot", "r1"}}), now) ==
        "no plugin of these robots publishes 'respawn.returned'; they publish nothing");
}

TEST_CASE("In a run, the numbers of rules are measured after each step") {
  elsie::testing::World world = elsie::testing::World::from_text(R"(
    <world format="1">
      <resources><resource id="food" x="0.3" y="0"/></resources>
      <robots>
        <robot id="r1">
          <behaviors><go_to_point x="3" y="0"/></behaviors>
          <coordinator><arbiter_suppression/></coordinator>
        </robot>
      </robots>
      <measures><published id="back" number="respawn.returned"/></measures>
      <rules><respawn after="1" where="random"/></rules>
    </world>)");
  world.run_for(5.0);
  REQUIRE(world.measured("back.end"));
  CHECK(*world.measured("back.end") >= 1.0);
}

TEST_CASE("Its curve covers a run of any length with at most 400 points") {
  for (const int steps : {1, 399, 400, 401, 12345}) {
    CAPTURE(steps);
    Scene now = exploring();
    Measure known("published", {{"number", "explore.known"}, {"robot", "r1"}});
    known.observe(now);
    for (int i = 1; i <= steps; ++i) {
      now.number("r1", "explore.known") = 3.0 * now.step().time_s();
      known.observe(now);
    }
    const auto curves = known->curves();
    REQUIRE(curves.size() == 1);
    const auto& points = curves[0].points;
    REQUIRE_FALSE(points.empty());
    CHECK(points.size() <= 400);
    CHECK(points.size() >= std::min<std::size_t>(static_cast<std::size_t>(steps), 199));
    CHECK(points.back().x > 0.98 * now.time_s());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(points[i].y == Approx(3.0 * points[i].x));
      if (i > 0) CHECK(points[i].x > points[i - 1].x);
    }
  }
}

TEST_CASE("A number that nobody publishes is refused with those that there are") {
  CHECK(refusal(Measure("published", {{"number", "explore.area"}}), exploring()) ==
        "no plugin of the world publishes 'explore.area'; there are: explore.known");
  CHECK(
      refusal(Measure("published", {{"number", "explore.known"}, {"robot", "r3"}}), exploring()) ==
      "no plugin of these robots publishes 'explore.known'; they publish nothing");
}
