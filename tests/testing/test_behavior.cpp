#include "elsie/testing/catch.h"

using namespace elsie::testing;
using elsie::Motion;

TEST_CASE("It keeps its state from one answer to the next, until it is reset") {
  Behavior finder("find_resource");
  finder.respond(Situation().camera());
  CHECK_THAT(finder.respond(Situation().blob(50)), raises("resource_in_view"));
  CHECK_THAT(finder.respond(Situation().blob(50)), raises_nothing());
  finder.reset();
  CHECK_THAT(finder.respond(Situation().blob(50)), raises("resource_in_view"));
}

TEST_CASE("The same seed draws the same numbers, another one others") {
  const Settings restless{{"restlessness", 1000}};
  const auto first = [&](std::uint64_t seed) {
    Behavior wander("wander", restless);
    wander.reset(seed);
    return wander.respond(Situation()).command;
  };
  CHECK(first(3) == first(3));
  CHECK(first(3) != first(4));
}

TEST_CASE("Before its first answer it is equipped for the robot, and may refuse") {
  Behavior follower("wall_follow");
  CHECK_THROWS_WITH(follower.respond(Situation().beam(0, 1)),
                    Catch::Contains("one that looks to the right"));
}

TEST_CASE("Parameters change while it runs; the others keep their values") {
  Behavior wander("wander", {{"speed", 3}, {"restlessness", 0}});
  CHECK_THAT(wander.respond(Situation()), commands_wheels(3, 3));
  wander.set({{"speed", 4}});
  CHECK_THAT(wander.respond(Situation()), commands_wheels(4, 4));
  CHECK_THROWS_WITH(wander.set({{"speed", -1}}), Catch::Contains("speed is -1"));
}

TEST_CASE("What is inside a behaviour that holds others answers what the test says") {
  Behavior blend("blend");
  blend.inside().answer = active(0.5, wheels(3, 4));
  CHECK_THAT(blend.respond(Situation()), commands_wheels(3, 4) && has_activation(0.5));
  CHECK(blend.inside().asked == 1);
}

TEST_CASE("A sequence gives an answer for each instant") {
  Behavior finder("find_resource");
  Sequence way;
  way.hold(0.05, Situation().camera()).hold(0.05, Situation().blob(20));
  const auto answers = finder.respond(way);
  REQUIRE(answers.size() == 10);
  CHECK_THAT(answers[4], turns_left() && raises_nothing());
  CHECK_THAT(answers[5], raises("resource_in_view"));
}

TEST_CASE("A successor continues with what the other one remembers, and its random stream") {
  Behavior before("wander");
  before.reset(7);
  for (int i = 0; i < 50; ++i) {
    before.respond(Situation().time(0.01 * i));
  }
  Behavior after("wander");
  CHECK(after.take_over(before));
  for (int i = 50; i < 100; ++i) {
    const Situation now = Situation().time(0.01 * i);
    CHECK(after.respond(now).command == before.respond(now).command);
  }
  Behavior still("braitenberg"), other("braitenberg");
  CHECK_FALSE(other.take_over(still));  // nothing to remember
}
