#include <cmath>

#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// A paraboloid with its top, 1, at a command.
auto paraboloid(WheelRates top) {
  return [=](const Motion& c) {
    const double left = rates(c).left - top.left;
    const double right = rates(c).right - top.right;
    return 1.0 - (left * left + right * right) / 10000.0;
  };
}

}  // namespace

TEST_CASE("The best command lies between the grid's points where it does") {
  Team team;
  team.member("a", 1, Motion{}).rating(paraboloid({0, 0}));
  team.member("b", 3, Motion{}).rating(paraboloid({8, -4}));
  Coordinated robot("fusion_interval", team);
  // The sum of paraboloids is a paraboloid with its top at the weighted mean.
  check_near(robot.decide(), wheels(6, -3), 0.02);
  CHECK(team.trace(0).weight == Approx(1.0 / 3));
  CHECK(team.trace(1).weight == 1.0);
  CHECK(team.reason(0) == "weighed");
  CHECK(team.trace(0).share == Approx(0.25).margin(0.01));
  CHECK(robot.rate({wheels(8, -4)})[0] == Approx((1.0 - 80.0 / 10000.0 + 3.0) / 4));
}

TEST_CASE("A finer tolerance finds it more exactly") {
  Team team;
  team.member("a", 1, Motion{}).rating(paraboloid({M_PI, -M_E}));
  check_near(Coordinated("fusion_interval", team, {{"tolerance", 1e-4}}).decide(),
             wheels(M_PI, -M_E), 1e-4);
}

TEST_CASE("It finds the highest of many summits, as good as looking everywhere") {
  Random random(7);
  for (int round = 0; round < 50; ++round) {
    Team team;
    std::vector<std::pair<WheelRates, double>> wishes;
    for (int i = 0; i < 5; ++i) {
      const WheelRates wish{random.uniform(-25, 25), random.uniform(-25, 25)};
      wishes.emplace_back(wish, random.uniform(0.5, 1.5));
      team.member("m", wishes.back().second, wheels(wish.left, wish.right));
    }
    const auto value = [&](const WheelRates& c) {
      double sum = 0.0;
      for (const auto& [wish, priority] : wishes) {
        const double left = (c.left - wish.left) / 5, right = (c.right - wish.right) / 5;
        sum += priority * std::exp(-0.5 * (left * left + right * right));
      }
      return sum;
    };
    double highest = 0.0;
    for (double left = -25; left <= 25; left += 0.25) {
      for (double right = -25; right <= 25; right += 0.25) {
        highest = std::max(highest, value({left, right}));
      }
    }
    const WheelRates best = rates(Coordinated("fusion_interval", team, {{"margin", 0.0}}).decide());
    CHECK(value(best) >= highest - 1e-9);
  }
}

TEST_CASE("Two equal pulls are not averaged: one is followed, and stays") {
  Team team;
  team.member("left", 1, wheels(5, 20)).member("right", 1, wheels(20, 5));
  Coordinated robot("fusion_interval", team);
  // exp(-4.5) of the other one moves the summit slightly towards it
  check_near(robot.decide(), wheels(5, 20), 0.2);
  CHECK(team.trace(0).share == Approx(1.0).margin(0.02));
  CHECK(team.trace(1).share == Approx(0.0).margin(0.02));
  for (int step = 0; step < 20; ++step) {
    team.answer(0).command = wheels(5 + 0.1 * step, 20);  // both change a little
    team.answer(1).activation = step % 2 == 0 ? 1.0 : 0.99;
    team.answer(0).activation = step % 2 == 0 ? 0.99 : 1.0;
    check_near(robot.decide(), team.answer(0).command, 0.4);
  }
  team.answer(0).activation = 0.9;  // now the other one is clearly better
  check_near(robot.decide(), wheels(20, 5), 0.4);
}

TEST_CASE("A summit beyond the wheels' limit counts at its scaled-down command") {
  Team team;
  team.member("a", 1, wheels(100, 50));
  check_near(Coordinated("fusion_interval", team).decide(), wheels(25, 12.5));
  CHECK(team.trace(0).share == 1.0);
  // It has its full weight next to one within reach that is near its command.
  team.member("b", 1, wheels(25, 14.5));
  const WheelRates both = rates(Coordinated("fusion_interval", team).decide());
  CHECK(both.left == 25.0);
  CHECK((both.right > 12.5 && both.right < 14.5));
  CHECK(team.trace(0).share == Approx(0.5).margin(0.1));
}

TEST_CASE("Where no command is desirable to anyone, the robot stands still") {
  Team team;
  team.member("a", 1, wheels(5, 5)).rating([](const Motion&) { return 0.0; });
  Coordinated robot("fusion_interval", team);
  CHECK(robot.decide() == Motion{});
  CHECK(team.reason(0) == "no command is desirable");
}

TEST_CASE("A robot that must not move gets a zero command") {
  Team team;
  team.member("a", 1, wheels(5, 5));
  Coordinated robot("fusion_interval", team);
  robot.now.self.max_speed_m_s = 0.0;
  CHECK(robot.decide() == Motion{});
}

TEST_CASE("To the outside a sum of desirability is the mean of the members' sets") {
  Team team;
  team.member("a", 1, wheels(0, 0)).member("b", 3, wheels(4, 0));
  Coordinated robot("fusion_interval", team);
  robot.decide();
  // triangles of half width 5: at 4, a quarter of 0.2 and three quarters of 1
  CHECK(robot.sets().left.degree(4) == Approx(0.25 * 0.2 + 0.75));
  CHECK(robot.sets().right.degree(0) == Approx(1.0));
}
