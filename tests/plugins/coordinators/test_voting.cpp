#include <cmath>

#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {

ElementValue candidate(double left, double right) {
  return {"candidate", {{"left", left}, {"right", right}}};
}

/// Votes for three candidates by their left wheel: 1, 2, 3.
auto votes(double first, double second, double third) {
  return [=](const Motion& c) {
    return rates(c).left == 1 ? first : rates(c).left == 2 ? second : third;
  };
}
const std::vector<ElementValue> kThree = {candidate(1, 0), candidate(2, 0), candidate(3, 0)};

}  // namespace

TEST_CASE("The candidate with the highest sum of votes is done, each times its priority") {
  Team team;
  team.member("a", 1, Motion{}).rating(votes(0.9, 0.5, 0.0));
  team.member("b", 2, Motion{}).rating(votes(0.0, 0.5, 0.6));
  Coordinated robot("arbiter_voting", team, {}, kThree);
  // 0.9, 1.5, 1.2: the winner is nobody's favourite
  CHECK(rates(robot.decide()) == WheelRates{2, 0});
  CHECK(team.trace(0).weight == 0.5);  // half as much as the highest
  CHECK(team.trace(1).weight == 1.0);
  CHECK(team.trace(0).share == Approx(0.5 / 1.5));
  CHECK(team.trace(1).share == Approx(1.0 / 1.5));
  CHECK(team.reason(0) == "voted");
  // Outwards: the mean vote.
  const auto outside = robot.rate({wheels(1, 0), wheels(3, 0)});
  CHECK(outside[0] == Approx(0.9 / 3));
  CHECK(outside[1] == Approx(1.2 / 3));
}

TEST_CASE("Of equal candidates the nearest to the last command is done, then the first") {
  Team team;
  team.member("a", 1, Motion{}).rating([](const Motion& c) {
    return rates(c).left == 10 ? 0.2 : 0.7;
  });
  Coordinated robot("arbiter_voting", team, {},
                    {candidate(3, 4), candidate(4, 3), candidate(12, 0), candidate(10, 0)});
  CHECK(rates(robot.decide()) == WheelRates{3, 4});  // both are 5 from standing still
  CHECK(rates(robot.decide()) == WheelRates{3, 4});
  team.next_step();
  Team other;
  other.member("a", 1, Motion{}).rating([&](const Motion& c) {
    return other.answer(0).activation < 1.0 ? rates(c).left == 12 : 0.7;
  });
  Coordinated again("arbiter_voting", other, {{"activation", std::string("gate")}},
                    {candidate(3, 4), candidate(4, 3), candidate(12, 0)});
  other.answer(0).activation = 0.5;
  CHECK(rates(again.decide()) == WheelRates{12, 0});
  other.answer(0).activation = 1.0;
  CHECK(rates(again.decide()) == WheelRates{12, 0});
}

TEST_CASE("How far a behaviour is active scales its votes, lets it vote or not, or does nothing") {
  const auto decided = [](const char* activation) {
    Team team;
    team.member("a", 1, active(0.5, {})).rating(votes(0.9, 0.1, 0.0));
    team.member("b", 1, active(1.0, {})).rating(votes(0.0, 0.5, 0.0));
    team.member("c", 1, active(0.0, {})).rating(votes(0.0, 0.0, 1.0));
    Coordinated robot("arbiter_voting", team, {{"activation", std::string(activation)}}, kThree);
    return robot.decide();
  };
  CHECK(rates(decided("scale")) == WheelRates{2, 0});   // 0.45, 0.55, 0
  CHECK(rates(decided("gate")) == WheelRates{1, 0});    // 0.9, 0.6, 0
  CHECK(rates(decided("ignore")) == WheelRates{3, 0});  // 0.9, 0.6, 1
}

TEST_CASE("A behaviour of priority zero or less has no vote and is not asked") {
  Team team;
  team.member("a", 0, wheels(5, 5)).member("b", -1, wheels(10, 10));
  team.member("c", 1, wheels(-5, 5));
  Coordinated robot("arbiter_voting", team);
  CHECK(rates(robot.decide()) == WheelRates{-5, 5});
  CHECK(team.asked(0) + team.asked(1) == 0);
  CHECK(team.reason(1) == "priority not above zero");
}

TEST_CASE("Where nobody votes for anything, the robot stands still") {
  Team team;
  team.member("a", 1, wheels(5, 5)).rating([](const Motion&) { return 0.0; });
  Coordinated robot("arbiter_voting", team);
  CHECK(robot.decide() == Motion{});
  CHECK(team.reason(0) == "no vote for any candidate");
}

TEST_CASE("Two wishes that lie close meet in the middle, two that lie far apart do not") {
  Team near;
  near.member("a", 1, wheels(12.5, 17.5)).member("b", 1, wheels(17.5, 12.5));
  check_near(Coordinated("arbiter_voting", near).decide(), wheels(15, 15));
  Team far;
  far.member("a", 1, wheels(5, 20)).member("b", 1, wheels(20, 5));
  // The mean, (12.5, 12.5), is on the grid with exp(-4.5 / 2) of each: far less than one of them
  // alone.
  check_near(Coordinated("arbiter_voting", far).decide(), wheels(5, 20), 0.01);
}

TEST_CASE("The grid goes up to the robot's maximum speed, or up to the given limit") {
  Team team;
  team.member("a", 1, wheels(100, 100));
  Coordinated robot("arbiter_voting", team);
  CHECK(rates(robot.decide()) == WheelRates{25, 25});  // 0.5 m/s on wheels of 0.02 m
  robot.now.self.max_speed_m_s = 0.2;                  // it may change at any time
  CHECK(rates(robot.decide()) == WheelRates{10, 10});
  Coordinated narrower("arbiter_voting", team, {{"max_rate", 5.0}});
  CHECK(rates(narrower.decide()) == WheelRates{5, 5});
}

TEST_CASE("A wish beyond the wheels' limit counts at its scaled-down command") {
  Team team;
  team.member("fast", 1, wheels(40, 40)).member("slow", 0.9, wheels(-10, 10));
  Coordinated robot("arbiter_voting", team);
  CHECK(rates(robot.decide()) == WheelRates{25, 25});
  CHECK(team.trace(0).share == Approx(1.0).margin(0.01));
  // A listed command beyond the limit stands for its scaled-down form.
  Coordinated listed("arbiter_voting", team, {}, {candidate(100, 100), candidate(20, 20)});
  CHECK(rates(listed.decide()) == WheelRates{100, 100});
}

TEST_CASE("Arcs: forward from turning in place to straight on, at several speeds, and a stop") {
  const auto decided = [](WheelRates wish) {
    Team team;
    team.member("a", 1, wheels(wish.left, wish.right));
    return Coordinated("arbiter_voting", team,
                       {{"set", std::string("arcs")},
                        {"steps", std::int64_t{5}},
                        {"speeds", std::int64_t{2}}})
        .decide();
  };
  check_near(decided({25, 25}), wheels(25, 25));
  check_near(decided({12.5, 0}), wheels(12.5, 0));  // half a turn to the right, half speed
  check_near(decided({-25, 25}), wheels(-25, 25));  // in place to the left
  check_near(decided({0.5, -0.5}), wheels(0, 0));   // the stop
  check_near(decided({-20, -20}), wheels(0, 0));    // nothing goes backwards
}

TEST_CASE("Votes may be spread: a broad agreement beats a single high vote") {
  const auto decided = [](double smoothing) {
    Team team;
    team.member("a", 1, Motion{}).rating([](const Motion& c) {
      return rates(c).left == 0 ? 0.8 : rates(c).left == 1 ? 0.0 : 0.7;
    });
    return Coordinated("arbiter_voting", team, {{"smoothing", smoothing}},
                       {candidate(0, 0), candidate(1, 0), candidate(20, 0), candidate(21, 0)})
        .decide();
  };
  CHECK(rates(decided(0.0)) == WheelRates{0, 0});
  CHECK(rates(decided(2.0)) == WheelRates{20, 0});  // 0.8 / (1 + exp(-1/8)) = 0.43 against 0.7
}

TEST_CASE("The command may lie between candidates, at the top of parabolas") {
  Team team;
  team.member("a", 1, wheels(11.3, 7.9));
  check_near(Coordinated("arbiter_voting", team, {{"interpolate", false}}).decide(),
             wheels(12.5, 7.5));
  check_near(Coordinated("arbiter_voting", team).decide(), wheels(11.3, 7.9), 0.1);
  // A turn gentler than half a step of the grid does not become standing still.
  Team gentle;
  gentle.member("a", 1, wheels(-0.4, 0.4));
  check_near(Coordinated("arbiter_voting", gentle, {{"interpolate", false}}).decide(),
             wheels(0, 0));
  check_near(Coordinated("arbiter_voting", gentle).decide(), wheels(-0.4, 0.4), 0.05);
  // Exact where the votes are parabolas; at an edge there is no interpolation.
  Team parabola;
  parabola.member("a", 1, Motion{}).rating([](const Motion& c) {
    return 1.0 - (rates(c).left - 4) * (rates(c).left - 4) / 4000 -
           (rates(c).right - 30) * (rates(c).right - 30) / 10000;
  });
  check_near(Coordinated("arbiter_voting", parabola).decide(), wheels(4, 25));
}

TEST_CASE("With a margin, the last command stays until another is clearly better") {
  Team team;
  double favour = 0.0;
  team.member("a", 1, Motion{}).rating([&](const Motion& c) {
    const auto bump = [&](double left, double right) {
      return std::exp(-0.02 * ((rates(c).left - left) * (rates(c).left - left) +
                               (rates(c).right - right) * (rates(c).right - right)));
    };
    return (0.5 - favour) * bump(-10, 10) + (0.5 + favour) * bump(10, -10 + 50 * favour);
  });
  Coordinated robot("arbiter_voting", team, {{"margin", 0.1}, {"interpolate", false}});
  CHECK(rates(robot.decide()) == WheelRates{-10, 10});
  favour = 0.04;
  CHECK(rates(robot.decide()) == WheelRates{-10, 10});  // 0.46 against 0.54
  favour = 0.06;
  CHECK(rates(robot.decide()) == WheelRates{10, -7.5});  // 0.44 against 0.56
  favour = -0.04;
  CHECK(rates(robot.decide()) == WheelRates{10, -12.5});  // the near one continues with it
}
