// How networks combine behaviours.
#include <catch2/catch.hpp>

#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::rates;

TEST_CASE("Fusion takes each command times the network's output and divides by their number") {
  Files files;
  const Object fusion = coordinator(kFusion, {{"weights", files.weights({simple_network()})}});
  Team team;
  add_two_behaviors(team);
  start(*fusion, team);
  const WheelRates command = rates(decide(*fusion, team, 0.4, 0.7));
  const double first = logistic(0.4), second = logistic(1.0 - 2.0 * 0.7);
  CHECK(command.left == Approx((first * -10 + second * 20) / 2));
  CHECK(command.right == Approx((first * 10 + second * 20) / 2));
  CHECK(weight(team, 0) == Approx(first));
  CHECK(weight(team, 1) == Approx(second));
  // Shares are parts of the sum of all contributions' lengths.
  CHECK(share(team, 0) == Approx(first * 10 / (first * 10 + second * 20)));
  CHECK(share(team, 0) + share(team, 1) == Approx(1.0));
  CHECK(reason(team, 1) == "priority from the network");
}

TEST_CASE("Arbitration runs the behaviour with the largest output, and no other") {
  Files files;
  const Object arbiter = coordinator(kArbiter, {{"weights", files.weights({simple_network()})}});
  Team team;
  add_two_behaviors(team);
  start(*arbiter, team);
  CHECK(rates(decide(*arbiter, team, 0.4, 0.7)) == WheelRates{-10, 10});
  CHECK(team.asked(0) == 1);
  CHECK(team.asked(1) == 0);
  CHECK(weight(team, 0) == Approx(logistic(0.4)));
  CHECK(weight(team, 1) == Approx(logistic(-0.4)));  // shown although it was not asked
  CHECK(share(team, 0) == 1.0);
  CHECK(share(team, 1) == 0.0);
  CHECK(team.members()[1].trace.inhibited_by == 0);
  CHECK(team.members()[0].trace.inhibited_by == -1);
  CHECK(reason(team, 0) == "largest priority");
  CHECK(reason(team, 1) == "smaller priority");

  CHECK(rates(decide(*arbiter, team, 0.1, 0.2)) == WheelRates{20, 20});
  CHECK(team.asked(1) == 1);
  CHECK(team.members()[0].trace.inhibited_by == 1);
}

TEST_CASE("Asked to ask all, arbitration runs every behaviour, and the winner's command counts") {
  Files files;
  const std::string weights = files.weights({simple_network()});
  for (const bool asks_all : {false, true}) {
    CAPTURE(asks_all);
    const Object arbiter = coordinator(
        kArbiter, {{"weights", weights}, {"ask", std::string(asks_all ? "all" : "winner")}});
    // The second one, which has a timer, drives ever faster.
    double timer_s = 0.0;
    Team team;
    team.member("avoid", 1, wheels(-10, 10)).member("timed", 1, [&](const Perception& now) {
      timer_s += now.period_s();
      return wheels(timer_s, timer_s);
    });
    start(*arbiter, team);
    for (int step = 0; step < 10; ++step) {
      CHECK(rates(decide(*arbiter, team, 0.4, 0.7)) == WheelRates{-10, 10});
    }
    CHECK(team.asked(0) == 10);
    CHECK(team.asked(1) == (asks_all ? 10 : 0));
    CHECK(timer_s == Approx(asks_all ? 0.1 : 0.0));
    const TraceRow& loser = team.trace("timed");
    CHECK(loser.asked == asks_all);
    CHECK(rates(loser.command).left == Approx(timer_s));
    CHECK(loser.share == 0.0);
    CHECK(loser.inhibited_by == 0);
    CHECK(reason(team, 1) == "smaller priority");
    // Once it decides, it goes on from there.
    CHECK(rates(decide(*arbiter, team, 0.1, 0.2)).left == Approx(asks_all ? 0.11 : 0.01));
  }
}

TEST_CASE("With equal outputs the first behaviour in the file wins") {
  Files files;
  const Object arbiter =
      coordinator(kArbiter, {{"weights", files.weights({neural::Network({2, 2})})}});
  Team team;
  add_two_behaviors(team);
  start(*arbiter, team);
  CHECK(rates(decide(*arbiter, team, 0.4, 0.7)) == WheelRates{-10, 10});
  CHECK(weight(team, 0) == 0.5);
  CHECK(weight(team, 1) == 0.5);
}

TEST_CASE("Nested, the arbiter wishes what its winner wishes") {
  Files files;
  const Object arbiter = coordinator(kArbiter, {{"weights", files.weights({simple_network()})}});
  Team team;
  add_two_behaviors(team);
  start(*arbiter, team);
  const Motion given = decide(*arbiter, team, 0.4, 0.7);
  const Motion candidates[] = {wheels(-10, 10), wheels(20, 20)};
  double wished[2], of_winner[2];
  const Situation now;
  arbiter->rate(team.members(), now.perception(), given, candidates, wished);
  team.members()[0].rate(candidates, of_winner);
  CHECK(wished[0] == of_winner[0]);
  CHECK(wished[1] == of_winner[1]);
  const CommandSets sets = arbiter->command_sets(team.members(), now.perception(), given);
  CHECK(sets.left == team.members()[0].command_sets().left);
}

TEST_CASE("Trained on the reference samples, the network avoids near obstacles and seeks else") {
  for (const char* hidden : {"2 2", "4 4"}) {
    const Object arbiter = coordinator(kArbiter, {{"hidden", std::string(hidden)}});
    Team team;
    add_two_behaviors(team);
    start(*arbiter, team);
    CAPTURE(hidden);
    CHECK(rates(decide(*arbiter, team, 1, 1)) == WheelRates{20, 20});
    CHECK(weight(team, 1) == Approx(1).margin(0.05));
    CHECK(rates(decide(*arbiter, team, 0.2, 1)) == WheelRates{-10, 10});
    CHECK(rates(decide(*arbiter, team, 1, 0.6)) == WheelRates{-10, 10});
    CHECK(rates(decide(*arbiter, team, 0.2, 0.2)) == WheelRates{-10, 10});
    CHECK(weight(team, 0) == Approx(0.3).margin(0.05));
  }
}

TEST_CASE("Normalised readings are parts of the maximum range") {
  Files files;
  for (const bool normalise : {false, true}) {
    const Object fusion = coordinator(
        kFusion, {{"weights", files.weights({simple_network()})}, {"normalise", normalise}});
    Team team;
    add_two_behaviors(team);
    start(*fusion, team);
    Situation now;
    now.beam(15, 1.0, 4.0).beam(-15, 1.0, 2.0);
    fusion->coordinate(team.members(), now.perception());
    CHECK(weight(team, 0) == Approx(logistic(normalise ? 0.25 : 1.0)));
    CHECK(weight(team, 1) == Approx(logistic(1.0 - 2.0 * (normalise ? 0.5 : 1.0))));
  }
}

TEST_CASE("Without behaviours the command is zero, and there is nothing to train") {
  for (const char* name : {kFusion, kArbiter}) {
    const Object object = coordinator(name);
    Situation now = beams(1, 1);
    object->equipped({}, now.perception());
    Random random(1);
    object->reset(random);
    CHECK(object->coordinate({}, now.perception()) == Motion{});
    CHECK(object->notes().empty());
  }
}

TEST_CASE("Behaviours that all wish to stand still share by their priorities") {
  Files files;
  const Object fusion = coordinator(kFusion, {{"weights", files.weights({simple_network()})}});
  Team team;
  team.member("a", 1, Motion{}).member("b", 1, Motion{});
  start(*fusion, team);
  CHECK(decide(*fusion, team, 0.4, 0.7) == Motion{});
  CHECK(share(team, 0) == Approx(logistic(0.4)));  // the two outputs add up to 1 here
  CHECK(share(team, 0) + share(team, 1) == Approx(1.0));
}

TEST_CASE("A reading that is no finite number is an error, not a guess") {
  const Object fusion = coordinator(kFusion);
  Team team;
  add_two_behaviors(team);
  start(*fusion, team);
  CHECK_THROWS_WITH(decide(*fusion, team, std::numeric_limits<double>::quiet_NaN(), 1),
                    Catch::Contains("not a finite number"));
}
