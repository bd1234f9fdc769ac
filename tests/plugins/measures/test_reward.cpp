// The reward of robots that learn.
#include <cmath>
#include <limits>

#include "support.h"

using namespace elsie::test;

namespace of_reward {
namespace {

/// The number that the measure publishes.
double reward_of(Measure& measure) { return measure.declaration().published.at(0).get(*measure); }

}  // namespace

TEST_CASE("A reward is how much the formula grew since the decision") {
  Scene now;
  now.steps_of(0.01, 2).robot("r1");
  Measure reward("reward", {{"of", "collected - 0.5 * collisions"}});
  reward.observe(now);
  CHECK(reward_of(reward) == 0.0);
  now["r1"].collected = 1;
  reward.observe(now.step());  // with a decision
  CHECK(reward_of(reward) == 1.0);
  now["r1"].collisions = 1;
  reward.observe(now.step());  // the period is over
  CHECK(reward_of(reward) == 0.5);
  reward.observe(now.step());  // the next one
  CHECK(reward_of(reward) == 0.0);
  now["r1"].collisions = 3;
  reward.observe(now.step());
  CHECK(reward_of(reward) == -1.0);
  CHECK(reward.value("total") == -0.5);
  CHECK(reward.value("mean") == Approx(-0.5 / 0.04));
}

TEST_CASE("Rewards of all control periods together are the total, whatever the period") {
  for (const int control_steps : {1, 3, 10}) {
    CAPTURE(control_steps);
    Scene now;
    now.steps_of(0.01, control_steps).robot("r1");
    Measure reward("reward", {{"of", "distance^2"}});
    reward.observe(now);
    double sum = 0.0;
    for (int i = 1; i <= 60; ++i) {
      now["r1"].distance_m = 0.1 * i;
      reward.observe(now.step());
      if (i % control_steps == 0) sum += reward_of(reward);
    }
    CHECK(sum == Approx(36.0));
    CHECK(*reward.value("total") == Approx(36.0));
  }
}

TEST_CASE("The formula has totals of the chosen robots, the time, and counts of events") {
  const auto total = [](const std::string& of, const Settings& whose = {}) {
    Scene now = three_robots();
    now["b1"].energy = 100.0;
    Settings settings = whose;
    settings["of"] = of;
    Measure reward("reward", settings);
    reward.observe(now);
    for (const char* id : {"r1", "r2", "b1"}) {
      now[id].distance_m = 2.0;
      now[id].energy_used = 3.0;
      now[id].collected = 4;
      now[id].collisions = 5;
    }
    now["b1"].energy = 107.0;
    now.step().event("arrived", "r1").event("arrived", "b1").event("lost", "r1").event("arrived");
    reward.observe(now);
    now.step().event("arrived", "r2");
    reward.observe(now);
    return reward.value("total").value();
  };
  CHECK(total("distance") == 6.0);
  CHECK(total("distance", {{"robot", "r2"}}) == 2.0);
  CHECK(total("collected", {{"team", "red"}}) == 8.0);
  CHECK(total("energy_used - collisions") == -6.0);
  CHECK(total("energy") == 7.0);
  CHECK(total("time") == Approx(0.02));
  CHECK(total("event.arrived") == 3.0);
  CHECK(total("event.arrived", {{"robot", "r1"}}) == 1.0);
  CHECK(total("event.arrived + 10 * event.lost", {{"team", "red"}}) == 12.0);
  CHECK(total("event.nothing") == 0.0);
}

TEST_CASE("Published numbers count, of robots and of the world, and keep their last value") {
  Scene now;
  now.publishes("respawn.returned");
  now.robot("r1").publishes("explore/home.away").robot("r2").publishes("explore/home.away");
  Measure reward("reward", {{"of", "respawn.returned - 0.5 * explore.home.away"}});
  reward.observe(now);
  CHECK_FALSE(reward.value("total"));  // it has no value yet
  now.number("", "respawn.returned") = 2.0;
  now.number("r1", "explore/home.away") = 3.0;
  reward.observe(now.step());
  CHECK(reward.value("total") == 0.0);  // where it begins
  now.number("r1", "explore/home.away") = 1.0;
  reward.observe(now.step());
  CHECK(reward_of(reward) == 1.0);
  now.number("r1", "explore/home.away") = std::numeric_limits<double>::quiet_NaN();
  now.number("", "respawn.returned") = 3.0;
  reward.observe(now.step());
  CHECK(reward_of(reward) == 1.0);  // nothing is known of home
  CHECK(reward.value("total") == 2.0);
  reward.reset();
  CHECK_FALSE(reward.value("total"));
}

TEST_CASE("A number whose id no formula can name is refused with what to do") {
  Scene now;
  now.robot("r1").publishes("home-base.away").publishes("nest.away");
  CHECK(refusal(Measure("reward", {{"of", "home-base.away"}}), now) ==
        "of=\"home-base.away\", column 1: there is no total 'home'; there are: time, collected, "
        "collisions, distance, energy_used, energy, event.NAME, nest.away; a formula cannot name "
        "home-base.away: give ids of letters, digits and \"_\" there");
}

TEST_CASE("What is in the battery is a potential that is always known") {
  Scene now;
  now.robot("r1");
  now["r1"].energy = 50.0;
  Measure shaped("reward", {{"of", "collected + 0.1 * energy"}});
  shaped.observe(now);
  for (const double energy : {40.0, 30.0, 60.0}) {
    now["r1"].energy = energy;
    shaped.observe(now.step());
  }
  CHECK(reward_of(shaped) == Approx(3.0));
  CHECK(*shaped.value("total") == Approx(1.0));
}

TEST_CASE("A potential adds up to what it is at the end, whatever the way") {
  Scene now;
  now.robot("r1").publishes("home.away");
  now.number("r1", "home.away") = 4.0;
  Measure shaped("reward", {{"of", "collected - 0.1 * home.away"}});
  shaped.observe(now);
  for (const double away : {7.0, 2.0, 9.0, 3.0}) {
    now.number("r1", "home.away") = away;
    shaped.observe(now.step());
  }
  CHECK(*shaped.value("total") == Approx(0.1));
}

TEST_CASE("A formula without a value gives no reward until it has one") {
  Scene now;
  now.robot("r1");
  Measure reward("reward", {{"of", "1 / collected"}});
  reward.observe(now);
  for (const int collected : {0, 1, 2}) {
    now["r1"].collected = collected;
    reward.observe(now.step());
  }
  CHECK(reward.value("total") == -0.5);
}

TEST_CASE("In a run it rewards what happens") {
  elsie::testing::World world = elsie::testing::World::from_text(R"(
    <world format="1">
      <resources><resource id="food" x="0.3" y="0"/></resources>
      <robots>
        <robot id="r1">
          <behaviors><go_to_point x="1" y="0"/></behaviors>
          <coordinator><arbiter_suppression/></coordinator>
        </robot>
      </robots>
      <measures><reward id="good" robot="r1" of="10 * collected + event.arrived"/></measures>
    </world>)");
  world.run_for(20.0);
  CHECK(world.measured("good.total") == 11.0);
}

TEST_CASE("What a formula cannot have is refused with what there is") {
  Scene now;
  now.publishes("respawn.returned");
  now.robot("r1").publishes("home.away");
  const auto refused = [&](const std::string& of) {
    return refusal(Measure("reward", {{"of", of}}), now);
  };
  CHECK(refused("colected") ==
        "of=\"colected\", column 1: there is no total 'colected'; did you mean 'collected'?");
  CHECK(refused("2 * home.awy") ==
        "of=\"2 * home.awy\", column 5: there is no total 'home.awy'; did you mean 'home.away'?");
  CHECK(refused("x") ==
        "of=\"x\", column 1: there is no total 'x'; there are: time, collected, collisions, "
        "distance, energy_used, energy, event.NAME, home.away, respawn.returned");
  CHECK_THAT(refused("event."), Catch::Contains("there is no total 'event.'"));
  CHECK_THROWS_WITH(Measure("reward", {{"of", "collected +"}}),
                    Catch::Contains("of=\"collected +\", column 12: "));
  CHECK_THROWS_WITH(Measure("reward", {{"of", "collected > 1"}}),
                    Catch::Contains("unexpected '>'"));
}

}  // namespace of_reward
