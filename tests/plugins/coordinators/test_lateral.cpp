// Coordinators of a robot whose drive can move sideways.
#include <string>

#include "support.h"

using namespace elsie;
using namespace elsie::test;

namespace {

Motion decided(const char* coordinator, Team& team, bool lateral = true,
               test::Parameters parameters = {}) {
  Coordinated robot(coordinator, team, std::move(parameters));
  robot.now.self.channels.lateral = lateral;
  return robot.decide();
}

void check(const Motion& command, const Motion& expected, double within = 1e-9) {
  CHECK(command.forward == Approx(expected.forward).margin(within));
  CHECK(command.lateral == Approx(expected.lateral).margin(within));
  CHECK(command.turn == Approx(expected.turn).margin(within));
}

}  // namespace

TEST_CASE("Sums have a lateral part like the others") {
  Team team;
  team.member("a", 1, Motion{0.2, 0.3, 1}).member("b", 1, Motion{0, -0.1, 0});
  check(decided("fusion_vector_summation", team), {0.1, 0.1, 0.5});
}

TEST_CASE("Votes are cast on lateral speeds, if the drive has them") {
  Team team;
  team.member("a", 1, Motion{0.2, 0.25, 0});  // on the grid: 10 and 12.5 rad/s
  check(decided("arbiter_voting", team), {0.2, 0.25, 0});
  check(decided("arbiter_voting", team, false), {0.2, 0, 0});
  check(decided("arbiter_voting", team, true, {{"laterals", std::int64_t{1}}}), {0.2, 0, 0});
}

TEST_CASE("A lateral wish that the drive cannot make takes nothing from the others in it") {
  for (const char* coordinator : {"arbiter_voting", "fusion_interval"}) {
    CAPTURE(coordinator);
    Team team;
    team.member("aside", 1.1, Motion{0.2, 0.3, 0}).member("back", 1, Motion{-0.2, 0, 0});
    check(decided(coordinator, team, false), {0.2, 0, 0}, 1e-3);
  }
}

TEST_CASE("A wish beyond the robot's speed is followed along its ray, sideways too") {
  Team team;
  team.member("a", 1, Motion{0, 2, 0});
  check(decided("arbiter_voting", team), {0, 0.5, 0});
  check(decided("fusion_interval", team), {0, 0.5, 0}, 1e-3);
}

TEST_CASE("Two lateral wishes that are near each other meet in the middle") {
  Team team;
  team.member("a", 1, Motion{0.1, 0.1, 0}).member("b", 1, Motion{0.1, 0.16, 0});
  check(decided("fusion_interval", team), {0.1, 0.13, 0}, 1e-3);
  check(decided("fusion_interval", team, false), {0.1, 0, 0}, 1e-3);
}

TEST_CASE("A behaviour whose sets are about wheels leaves the lateral speed to others") {
  for (const char* defuzzification : {"centre_of_gravity", "centre_of_largest_area"}) {
    CAPTURE(defuzzification);
    Team team;
    team.member("aside", 1, Motion{0.1, 0.05, 0});
    team.member("wheels", 1, Motion{}).sets({FuzzySet::triangle(5, 5), FuzzySet::triangle(5, 5)});
    check(decided("fusion_fuzzy", team, true, {{"defuzzification", std::string(defuzzification)}}),
          {0.1, 0.05, 0});
  }
}

TEST_CASE("The lateral speed has a strength of its own") {
  const auto fill = [](Team& team) {
    Response aside = Motion{0, 0.1, 0};
    aside.speed_strength = aside.turn_strength = 0.0;
    team.member("aside", 2, aside).member("drive", 1, Motion{0.2, -0.3, 1});
  };
  Team team;
  fill(team);
  check(decided("arbiter_strength", team), {0.2, 0.1, 1});
  CHECK(team.reason(0) == "full strength: lateral");
  CHECK(team.reason(1) == "fills what is left");
  CHECK(team.trace(0).share == Approx(1.0 / 3));
  Team without;  // the channel
  fill(without);
  check(decided("arbiter_strength", without, false), {0.2, 0, 1});
  CHECK(without.reason(0) == "no strength");
  CHECK(without.reason(1) == "full strength");
}
