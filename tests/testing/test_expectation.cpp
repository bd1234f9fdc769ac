#include <limits>

#include "elsie/testing/catch.h"

using namespace elsie::testing;
using elsie::Motion;
using elsie::Response;

namespace {

Response answer(double left, double right) { return wheels(left, right); }

}  // namespace

TEST_CASE("Directions follow from the wheels") {
  struct {
    double left, right;
    bool turns_left, turns_right, straight, forward, backs, on_the_spot, stands;
  } const cases[] = {
      {1, 2, true, false, false, true, false, false, false},
      {2, 1, false, true, false, true, false, false, false},
      {2, 2, false, false, true, true, false, false, false},
      {-2, -2, false, false, false, false, true, false, false},
      {-2, 2, true, false, false, false, false, true, false},
      {0, 0, false, false, false, false, false, false, true},
  };
  for (const auto& c : cases) {
    const Response r = answer(c.left, c.right);
    CAPTURE(r);
    CHECK(turns_left().match(r) == c.turns_left);
    CHECK(turns_right().match(r) == c.turns_right);
    CHECK(drives_straight_on().match(r) == c.straight);
    CHECK(drives_forward().match(r) == c.forward);
    CHECK(backs_up().match(r) == c.backs);
    CHECK(turns_on_the_spot().match(r) == c.on_the_spot);
    CHECK(stands().match(r) == c.stands);
  }
  CHECK_FALSE(turns_left(1.0).match(answer(1, 2)));
}

TEST_CASE("No expectation of a command is met by a NaN") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Expectation& expectation :
       {turns_left(), turns_right(), drives_straight_on(), drives_forward(), backs_up(), stands(),
        turns_on_the_spot(), commands({}, 1e9), commands_wheels(0, 0, 1e9)}) {
    CHECK_FALSE(expectation.match(answer(nan, nan)));
  }
}

TEST_CASE("Activation, strength, events, charging") {
  Response r = answer(1, 1);
  r.activation = 0.0;
  r.strength = 0.25;
  CHECK_THAT(r, is_not_active() && !is_active() && has_activation(0) && has_strength(0.25));
  CHECK_THAT(r, raises_nothing() && !asks_to_be_charged());
  r.events.push_back({"arrived"});
  r.charge = true;
  CHECK_THAT(r, raises("arrived") && !raises("arrive") && asks_to_be_charged());
  CHECK_THAT(r, commands_wheels(1, 2) || commands_wheels(1.05, 1, 0.1));
  CHECK_THAT(r, commands({0.02, 0, 0}) && !commands({0.02, 0.01, 0}));
}

TEST_CASE("A bare command serves as an answer") {
  CHECK_THAT(Response(wheels(1, 2)), turns_left());
  CHECK(turns_left().check(wheels(1, 2)));
}

TEST_CASE("An expectation that is not met gives a sentence") {
  Response r = active(0.5, {0.05, 0, -0.2});
  r.events.push_back({"stuck"});
  const Verdict verdict = (turns_left() && !raises("freed")).check(r);
  CHECK_FALSE(verdict);
  CHECK(verdict.sentence ==
        "the answer should turn left and not raise freed, but is command (forward 0.05 m/s, turn "
        "-0.2 rad/s), activation 0.5, raises stuck");
  CHECK(turns_right().check(r).sentence.empty());
  CHECK(commands_wheels(1, 2, 0.5).toString() ==
        "should command wheel rates of 1 and 2 rad/s within 0.5");
  CHECK(commands({0.1, 0.2, 3}, 0.5).toString() ==
        "should command (forward 0.1 m/s, lateral 0.2 m/s, turn 3 rad/s) within 0.5");
}

TEST_CASE("Catch prints answers and commands in words") {
  const Motion motion{0.1, 0, 2};
  CHECK(Catch::Detail::stringify(Response(motion)) ==
        "command (forward 0.1 m/s, turn 2 rad/s), activation 1");
  CHECK(Catch::Detail::stringify(motion) == "command (forward 0.1 m/s, turn 2 rad/s)");
}
