// The smoothness of commands, and which behaviours gave them.
#include <cmath>

#include "support.h"
#include "wheels.h"

namespace testing = elsie::testing;
using elsie::Motion;
using namespace elsie::test;
using elsie::test::wheels;

namespace {

/// A robot that executes these commands for a while.
template <class Command>
void drive(Scene& now, Measure& measure, int steps, Command command) {
  measure.observe(now);
  for (int i = 1; i <= steps; ++i) {
    now["r1"].command = command(0.01 * i);
    measure.observe(now.step());
  }
}

}  // namespace

TEST_CASE("A robot that stands still is perfectly smooth; without a step there is nothing to say") {
  Scene now;
  now.robot("r1");
  Measure smooth("command_smoothness");
  smooth.observe(now);
  CHECK_FALSE(smooth.value("variation"));
  CHECK_FALSE(smooth.value("jerk"));
  smooth.observe(now.step());
  CHECK(smooth.value("variation") == 0.0);
  CHECK(smooth.value("jerk") == 0.0);
}

TEST_CASE("A steady ramp varies by its slope and jerks at its foot alone") {
  Scene now;
  now.robot("r1");
  Measure smooth("command_smoothness");
  drive(now, smooth, 100, [](double t) { return wheels(2.0 * t, -4.0 * t); });
  CHECK(smooth.value("variation") == Approx(3.0));  // rad/s2, mean of 2 and 4
  // One second difference is not zero: that of the first command, 0.02 and -0.04 in 0.01 s, twice.
  const double first = 0.5 * (200.0 * 200.0 + 400.0 * 400.0);
  CHECK(smooth.value("jerk") == Approx(std::sqrt(first / 100.0)));
}

TEST_CASE("A command that flips each time varies the most, whatever the period") {
  for (const int control_steps : {1, 5}) {
    CAPTURE(control_steps);
    Scene now;
    now.steps_of(0.01, control_steps).robot("r1");
    Measure smooth("command_smoothness");
    int decisions = 0;
    smooth.observe(now);
    for (int i = 0; i < 1000; ++i) {
      now.step();
      if (now.observation().decided) {
        ++decisions;
        now["r1"].command = decisions % 2 == 1 ? wheels(10, 10) : Motion{};
      }
      smooth.observe(now);
    }
    // 10 rad/s each period, both wheels.
    CHECK(smooth.value("variation") == Approx(10.0 / (0.01 * control_steps)));
    // 10 at first, then 20 from each change to the opposite one.
    const double period = 0.01 * control_steps;
    const double squares = 100.0 + 400.0 * (decisions - 1);
    CHECK(smooth.value("jerk") == Approx(std::sqrt(squares / decisions) / (period * period)));
  }
}

TEST_CASE("A sine has the variation and the jerk that calculus gives") {
  Scene now;
  now.steps_of(0.001).robot("r1");
  Measure smooth("command_smoothness");
  const double w = 2.0 * 3.14159265358979, a = 5.0;
  smooth.observe(now);
  for (int i = 1; i <= 10'000; ++i) {
    const double u = a * (1.0 - std::cos(w * 0.001 * i));  // starts at rest
    now["r1"].command = wheels(u, u);
    smooth.observe(now.step());
  }
  CHECK(smooth.value("variation") == Approx(4.0 * a).epsilon(0.001));  // 4 amplitudes a second
  CHECK(smooth.value("jerk") == Approx(a * w * w / std::sqrt(2.0)).epsilon(0.001));
}

TEST_CASE("The smoothness of several robots is their mean") {
  Scene now;
  now.robot("r1").robot("r2");
  Measure smooth("command_smoothness");
  drive(now, smooth, 50, [](double t) { return wheels(2.0 * t, 2.0 * t); });
  CHECK(smooth.value("variation") == Approx(1.0));  // the other one stands still
}

namespace {

Scene with_behaviors() {
  Scene now;
  now.robot("r1").behaves("avoid").behaves("explore");
  now.behaves("explore/seek").behaves("explore/wander");
  return now;
}

void share(Scene& now, double avoid, double seek, double wander) {
  now.behavior("r1", "avoid").share = avoid;
  now.behavior("r1", "explore").share = seek + wander > 0.0 ? 1.0 - avoid : 0.0;
  now.behavior("r1", "explore/seek").share = seek;
  now.behavior("r1", "explore/wander").share = wander;
}

}  // namespace

TEST_CASE("The share of time is that of who had the largest share in the command") {
  Scene now = with_behaviors();
  Measure time("time_share");
  share(now, 1, 0, 0);
  time.observe(now);  // the start has no weight
  CHECK_FALSE(time.value("decided.avoid"));
  share(now, 1, 0, 0);
  time.observe(now.step());
  share(now, 0.25, 0.6, 0.4);
  time.observe(now.step());
  time.observe(now.step());
  share(now, 0, 0.5, 0.5);  // two with equal shares: neither decides
  time.observe(now.step());
  CHECK(time.value("decided.avoid") == Approx(0.25));
  CHECK(time.value("decided.explore") == Approx(0.75));
  CHECK(time.value("decided.explore/seek") == Approx(0.5));
  CHECK(time.value("decided.explore/wander") == Approx(0.0));
  CHECK(time.value("share.avoid") == Approx((1.0 + 0.25 + 0.25) / 4.0));
  CHECK(time.value("share.explore") == Approx((0.75 + 0.75 + 1.0) / 4.0));
  // Inner shares are parts of the outer one.
  CHECK(time.value("share.explore/seek") == Approx((2.0 * 0.75 * 0.6 + 0.5) / 4.0));
  CHECK(time.value("share.explore/wander") == Approx((2.0 * 0.75 * 0.4 + 0.5) / 4.0));
}

TEST_CASE("One behaviour may be asked for, on all robots that have it") {
  Scene now = with_behaviors();
  now.robot("r2").behaves("avoid").robot("r3");
  Measure time("time_share", {{"behavior", "avoid"}});
  time.observe(now);
  share(now, 1, 0, 0);
  time.observe(now.step());
  REQUIRE(time.quantities().size() == 2);
  CHECK(time.value("decided") == Approx(0.5));  // r1 yes, r2 no, r3 does not have it
  CHECK(time.value("share") == Approx(0.5));
  CHECK(refusal(Measure("time_share", {{"behavior", "seek"}}), now) ==
        "there is no behaviour 'seek' on the robots; there are 'avoid', 'explore', "
        "'explore/seek', 'explore/wander'");
  CHECK(refusal(Measure("time_share", {{"behavior", "avoid"}, {"robot", "r3"}}), now) ==
        "there is no behaviour 'avoid' on the robots; they have none");
  CHECK(refusal(Measure("time_share", {{"robot", "r3"}}), now) == "the robots have no behaviours");
}
