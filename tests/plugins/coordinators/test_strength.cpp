#include "support.h"
#include "wheels.h"

using namespace elsie;
using Catch::Contains;
using namespace elsie::test;

namespace {

/// A wish for a forward speed and a turn, as wheel rates.
Response wish(double speed, double turn, double strength = 1.0) {
  Response response(wheels(speed - turn, speed + turn));
  response.strength = strength;
  return response;
}
Motion command(double speed, double turn) { return wheels(speed - turn, speed + turn); }

}  // namespace

TEST_CASE("Lower priorities fill the strength that higher ones leave") {
  Team team;
  team.member("low", 1, wish(20, 0, 0.9))
      .member("high", 3, wish(0, 10, 0.6))
      .member("middle", 2, wish(10, -10, 0.3));
  Coordinated robot("arbiter_strength", team);
  // 0.6 of high, 0.3 of middle, and the last 0.1 of low
  check_near(robot.decide(), command(0.3 * 10 + 0.1 * 20, 0.6 * 10 - 0.3 * 10));
  CHECK(team.trace(1).weight == Approx(0.6));
  CHECK(team.trace(1).share == Approx(0.6));
  CHECK(team.reason(1) == "full strength");
  CHECK(team.trace(0).weight == Approx(0.1));
  CHECK(team.reason(0) == "fills what is left");
}

TEST_CASE("What the strengths leave is left open: the command is their weighted mean") {
  Team team;
  team.member("a", 2, wish(10, 0, 0.2)).member("b", 1, wish(20, 4, 0.2));
  Coordinated robot("arbiter_strength", team);
  check_near(robot.decide(), command(15, 2));
  CHECK(team.trace(0).weight == Approx(0.2));
  CHECK(team.trace(0).share == Approx(0.5));
}

TEST_CASE("Equal priorities are averaged, weighted by strength, and share what is left") {
  Team team;
  team.member("top", 2, wish(0, 0, 0.5))
      .member("a", 1, wish(12, 0, 0.9))
      .member("b", 1, wish(24, 0, 0.3));
  Coordinated robot("arbiter_strength", team);
  // The group's value is (0.9 x 12 + 0.3 x 24) / 1.2 = 15; it gets the other half.
  check_near(robot.decide(), command(7.5, 0));
  CHECK(team.trace(1).share == Approx(0.375));
  CHECK(team.trace(2).share == Approx(0.125));
}

TEST_CASE("Once nothing is left, lower priorities are not even asked") {
  Team team;
  team.member("low", -1, wish(20, 0)).member("high", 0, wish(5, 5));
  Coordinated robot("arbiter_strength", team);
  check_near(robot.decide(), command(5, 5));
  CHECK(team.asked(0) == 0);
  CHECK(team.trace(0).inhibited_by == 1);
  CHECK(team.reason(0) == "no strength left");
}

TEST_CASE("Speed and turn are resolved apart") {
  Team team;
  Response steer = wish(0, 6);
  steer.speed_strength = 0.0;  // it only steers
  Response brake = wish(2, 0, 0.5);
  brake.turn_strength = 0.0;
  team.member("steer", 3, steer).member("brake", 2, brake).member("cruise", 1, wish(20, -20));
  Coordinated robot("arbiter_strength", team);
  check_near(robot.decide(), command(0.5 * 2 + 0.5 * 20, 6));
  CHECK(team.reason(0) == "full strength: turn");
  CHECK(team.reason(1) == "full strength: speed");
  CHECK(team.reason(2) == "fills what is left");
  CHECK(team.trace(0).share == Approx(0.5));
  CHECK(team.trace(1).share == Approx(0.25));
  CHECK(team.trace(2).share == Approx(0.25));
}

TEST_CASE("The strengths of a behaviour may be set in the world file") {
  Team team;
  team.member("steer", 2, wish(0, 6)).member("cruise", 1, wish(20, 0));
  Coordinated robot("arbiter_strength", team, {},
                    {{"strength", {{"of", std::string("steer")}, {"speed", 0.25}, {"turn", 0.5}}}});
  check_near(robot.decide(), command(0.75 * 20, 0.5 * 6));

  const auto refusal = [&](const std::vector<ElementValue>& elements) -> std::string {
    try {
      Coordinated("arbiter_strength", team, {}, elements);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const ElementValue wrong{"strength", {{"of", std::string("steel")}}};
  const ElementValue right{"strength", {{"of", std::string("steer")}}};
  CHECK_THAT(refusal({wrong}), Contains("did you mean 'steer'?"));
  CHECK_THAT(refusal({right, right, wrong}), Contains("is given twice") && Contains("; "));
}

TEST_CASE("How far a behaviour is active scales its strength, gates it, or does nothing") {
  const auto decided = [](const char* activation, double how_far) {
    Team team;
    Response half = wish(10, 0);
    half.activation = how_far;
    team.member("a", 2, half).member("b", 1, wish(20, 0));
    Coordinated robot("arbiter_strength", team, {{"activation", std::string(activation)}});
    return rates(robot.decide()).left;
  };
  CHECK(decided("scale", 0.5) == Approx(15));
  CHECK(decided("gate", 0.5) == Approx(10));
  CHECK(decided("gate", 0.0) == Approx(20));
  CHECK(decided("ignore", 0.0) == Approx(10));
}

TEST_CASE("A behaviour without strength has no part, and the trace says which it lacks") {
  Team team;
  team.member("weak", 2, wish(10, 0, 0.0)).member("b", 1, wish(20, 0));
  Response idle = wish(5, 5);
  idle.activation = 0.0;
  team.member("idle", 3, idle);
  Coordinated robot("arbiter_strength", team);
  check_near(robot.decide(), command(20, 0));
  CHECK(team.reason(0) == "no strength");
  CHECK(team.reason(2) == "not active");
  team.answer(1).strength = 0.0;
  CHECK(robot.decide() == Motion{});
}
