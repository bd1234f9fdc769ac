#include "elsie/commands/led.h"
#include "elsie/testing/catch.h"

using namespace elsie::testing;
using elsie::FuzzySet;
using elsie::LedCommand;
using elsie::Motion;
using elsie::Perception;
using elsie::RangeReading;
using elsie::Response;

TEST_CASE("A coordinator decides among made-up behaviours, and its trace can be read by name") {
  Team team;
  team.member("avoid", 2, active(0.5, wheels(10, -10))).member("seek", 1, wheels(20, 20));
  Coordinator arbiter("arbiter_suppression", team);
  CHECK_THAT(arbiter.decide(), commands_wheels(10, -10));
  CHECK(team.trace("avoid").share == 1.0);
  CHECK(team.trace("seek").inhibited_by == 0);
  CHECK(team.asked("avoid") == 1);
  CHECK(team.asked("seek") == 0);
  CHECK_THROWS_WITH(team.trace("avod"), Catch::Contains("did you mean 'avoid'?"));
}

TEST_CASE("Members may follow a script; they perceive what the coordinator does") {
  Team team;
  team.member("shy", 1, [](const Perception& now) {
    return Response(wheels(now.readings<RangeReading>()[0]->distance_m, 0));
  });
  Coordinator arbiter("arbiter_suppression", team);
  CHECK_THAT(arbiter.decide(Situation().beam(0, 0.5)), commands_wheels(0.5, 0));
  CHECK_THAT(arbiter.decide(Situation().beam(0, 0.7)), commands_wheels(0.7, 0));
  Sequence way;
  way.hold(0.02, Situation().beam(0, 0.1)).hold(0.01, Situation().beam(0, 0.2));
  const auto commands = arbiter.decide(way);
  REQUIRE(commands.size() == 3);
  CHECK_THAT(commands[2], commands_wheels(0.2, 0));
}

TEST_CASE("A coordinator gets the ratings and sets of the team's members") {
  Team team;
  team.member("picky", 1, wheels(5, 5))
      .rating([](const Motion& c) { return c.forward > 0 ? 0.75 : 0.25; })
      .sets({FuzzySet::triangle(3, 1), FuzzySet::triangle(4, 1)});
  Coordinator arbiter("arbiter_suppression", team);
  arbiter.decide();
  CHECK(arbiter.rate({wheels(1, 0), wheels(-1, 0)}) == std::vector<double>{0.75, 0.25});
  CHECK(arbiter.sets().left == FuzzySet::triangle(3, 1));
}

TEST_CASE("A team that a coordinator cannot work with is refused at its first decision") {
  Team team;
  team.member("a", 1, Motion{});
  Coordinator layers("arbiter_subsumption", team, {}, {{"suppress", {{"by", "b"}, {"of", "a"}}}});
  CHECK_THROWS_WITH(layers.decide(), Catch::Contains("by=\"b\"> names no behaviour"));
}

TEST_CASE("A coordinator says whose command an actuator gets") {
  Team team;
  team.member("avoid", 1, Motion{}).member("seek", 2, Motion{});
  Coordinator arbiter("arbiter_suppression", team);
  arbiter.decide();
  const Wish red("avoid", LedCommand{{255, 0, 0}, 1.0}), blue("seek", LedCommand{{0, 0, 255}, 1.0});
  CHECK(arbiter.resolve("lamp", {red, blue}) == 1);
  CHECK(arbiter.resolve("lamp", {blue, red}) == 0);
  CHECK_THROWS_WITH(arbiter.resolve("lamp", {red, {"sek", LedCommand{}}}),
                    Catch::Contains("did you mean 'seek'?"));
}
