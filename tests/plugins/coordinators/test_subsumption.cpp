#include "support.h"
#include "wheels.h"

using namespace elsie;
using Catch::Contains;
using namespace elsie::test;

namespace {

const Motion kWander{1, 0, 1}, kSeek{2, 0, 2}, kAvoid{3, 0, 3};

void fill(Team& team) {
  team.member("wander", 1, kWander).member("seek", 1, kSeek).member("avoid", 1, kAvoid);
}
void set(Team& team, double wander, double seek, double avoid) {
  team.answer(0).activation = wander;
  team.answer(1).activation = seek;
  team.answer(2).activation = avoid;
}

ElementValue suppress(const char* by, const char* of) {
  return {"suppress", {{"by", std::string(by)}, {"of", std::string(of)}}};
}
ElementValue inhibit(const char* by, const char* of) {
  return {"inhibit", {{"by", std::string(by)}, {"of", std::string(of)}}};
}
ElementValue held(ElementValue link, double hold) {
  link.parameters["hold"] = hold;
  return link;
}

std::string refusal(const std::vector<ElementValue>& links) {
  Team team;
  fill(team);
  try {
    Coordinated robot("arbiter_subsumption", team, {}, links);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Without links the highest active layer decides: the last in the file") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_subsumption", team);
  set(team, 1, 1, 1);
  CHECK(robot.decide() == kAvoid);
  CHECK(team.trace(2).share == 1.0);
  CHECK(team.reason(2) == "its signal reaches the motors");
  for (const std::size_t lower : {0, 1}) {
    CHECK(team.trace(lower).inhibited_by == 2);
    CHECK(team.reason(lower) == "suppressed");
    CHECK(team.asked(lower) == 1);  // lower layers still run
  }
  set(team, 1, 1, 0);
  CHECK(robot.decide() == kSeek);
  CHECK(team.reason(2) == "not active");
  CHECK(team.trace(0).inhibited_by == 1);
  set(team, 1, 0, 0);
  CHECK(robot.decide() == kWander);
}

TEST_CASE("Suppression replaces a signal; inhibition removes it and puts nothing in its place") {
  for (const bool suppressing : {true, false}) {
    Team team;
    team.member("drive", 1, wheels(10, 10)).member("alarm", 1, wheels(-5, 5));
    Coordinated robot("arbiter_subsumption", team, {},
                      {suppressing ? suppress("alarm", "drive") : inhibit("alarm", "drive")});
    CHECK(robot.decide() == (suppressing ? wheels(-5, 5) : wheels(0, 0)));
    CHECK(team.trace(0).inhibited_by == 1);
    CHECK(team.reason(0) == (suppressing ? "suppressed" : "inhibited"));
    CHECK(team.trace(1).share == (suppressing ? 1.0 : 0.0));
    CHECK(team.reason(1) ==
          (suppressing ? "its signal reaches the motors" : "its signal leads nowhere"));
    team.answer(1).activation = 0.0;  // an inactive layer does neither
    CHECK(rates(robot.decide()) == WheelRates{10, 10});
  }
}

TEST_CASE("An inhibited layer suppresses nothing: the lower signal passes") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_subsumption", team, {}, {inhibit("avoid", "seek")});
  set(team, 1, 1, 1);
  CHECK(robot.decide() == kWander);
  CHECK(team.trace(1).inhibited_by == 2);
  CHECK(team.reason(1) == "inhibited");
  set(team, 1, 1, 0);
  CHECK(robot.decide() == kSeek);  // it has no link, so it suppresses all below it

  // With suppression instead, avoid's signal takes that way.
  Team other;
  fill(other);
  Coordinated suppressed("arbiter_subsumption", other, {}, {suppress("avoid", "seek")});
  set(other, 1, 1, 1);
  CHECK(suppressed.decide() == kAvoid);
  set(other, 1, 0, 1);
  CHECK(suppressed.decide() == kAvoid);  // even where seek is inactive
}

TEST_CASE("Of several nodes on one line that of the highest layer is nearest to the motors") {
  Team team;
  fill(team);
  const auto with = [&](const std::vector<ElementValue>& links) {
    Team again;
    fill(again);
    return Coordinated("arbiter_subsumption", again, {}, links).decide();
  };
  CHECK(with({suppress("avoid", "wander"), inhibit("seek", "wander")}) == kAvoid);
  CHECK(with({inhibit("seek", "wander"), suppress("avoid", "wander")}) == kAvoid);
  CHECK(with({suppress("seek", "wander"), inhibit("avoid", "wander")}) == Motion{});
}

TEST_CASE("A link stays in effect for its time constant, with the last signal") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_subsumption", team, {},
                    {held(suppress("avoid", "wander"), 0.5), held(inhibit("seek", "wander"), 0.2)});
  set(team, 1, 0, 1);
  CHECK(robot.decide_at(0.0) == kAvoid);
  set(team, 1, 0, 0);
  team.answer(2).command = {9, 0, 9};  // the response of a silent layer does not matter
  CHECK(robot.decide_at(0.5) == kAvoid);
  CHECK(team.reason(2) == "held");
  CHECK(team.trace(2).share == 1.0);
  CHECK(robot.rate({kAvoid})[0] == 1.0);  // outwards it stands for the executed command
  CHECK(robot.decide_at(0.51) == kWander);
  set(team, 1, 1, 0);
  CHECK(robot.decide_at(1.0) == Motion{});
  set(team, 1, 0, 0);
  CHECK(robot.decide_at(1.2) == Motion{});
  CHECK(team.reason(0) == "inhibited");
  CHECK(robot.decide_at(1.21) == kWander);
  robot.reset();
  CHECK(robot.decide_at(1.22) == kWander);
}

TEST_CASE(
    "Layers without links have a time constant, too, and it does not add up over the layers") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_subsumption", team, {{"hold", 0.3}});
  set(team, 1, 1, 1);
  CHECK(robot.decide_at(0.0) == kAvoid);
  set(team, 1, 0, 0);
  CHECK(robot.decide_at(0.3) == kAvoid);
  CHECK(robot.decide_at(0.31) == kWander);
}

TEST_CASE("A layer is active above a threshold") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_subsumption", team, {{"threshold", 0.4}});
  set(team, 1, 0.41, 0.4);
  CHECK(robot.decide() == kSeek);
}

TEST_CASE("Links that cannot be are refused when the robot is put together") {
  CHECK_THAT(
      refusal({suppress("avoyd", "wander")}),
      Contains("<suppress by=\"avoyd\"> names no behaviour") && Contains("did you mean 'avoid'?"));
  CHECK_THAT(refusal({inhibit("avoid", "wonder")}), Contains("did you mean 'wander'?"));
  CHECK_THAT(refusal({inhibit("avoid", "avoid")}), Contains("links a layer to itself"));
  CHECK_THAT(refusal({inhibit("wander", "avoid")}), Contains("goes upwards"));
  CHECK_THAT(refusal({suppress("avoid", "wander"), inhibit("wander", "avoid")}),
             Contains("closes a circle with the link from 'avoid' to 'wander'"));
  CHECK_THAT(refusal({suppress("avoid", "wander"), inhibit("avoid", "wander")}),
             Contains("is the second link of these two layers"));
  // All at once.
  CHECK_THAT(refusal({suppress("x", "wander"), inhibit("avoid", "avoid")}),
             Contains("names no behaviour") && Contains("; ") && Contains("to itself"));
}

TEST_CASE("A layer that can never reach the motors is pointed out") {
  Team team;
  fill(team);
  Coordinated robot("arbiter_subsumption", team, {}, {inhibit("avoid", "seek")});
  REQUIRE((*robot).notes().size() == 1);
  CHECK_THAT((*robot).notes()[0], Contains("layer 'avoid' never reaches the motors"));
  Team other;
  fill(other);
  CHECK((*Coordinated("arbiter_subsumption", other)).notes().empty());
}

TEST_CASE("A priority has no effect on layers, and a note says so") {
  Team team;
  team.member("wander", 1, kWander).member("seek", 5, kSeek).member("avoid", 0.5, kAvoid);
  Coordinated robot("arbiter_subsumption", team);
  REQUIRE((*robot).notes().size() == 1);
  CHECK(
      (*robot).notes()[0] ==
      "the attribute 'priority' of seek, avoid has no effect: the order in the file decides which "
      "layer is higher");
}
