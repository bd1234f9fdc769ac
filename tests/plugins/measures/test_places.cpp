// Places reached, groups gathered, formations kept, floors covered.
#include <cmath>

#include "support.h"

namespace testing = elsie::testing;
using namespace elsie::test;

TEST_CASE(
    "A place is reached at the first instant within its radius; nearest is over the whole run") {
  Scene now;
  now.robot("r1", -3, 0);
  Measure reached("place_reached", {{"robot", "r1"}, {"x", 0.0}, {"y", 0.3}, {"radius", 0.5}});
  reached.equip(now);
  reached.reset();
  CHECK_FALSE(reached.value("time_s"));
  CHECK_FALSE(reached.value("nearest_m"));  // nothing was observed yet
  reached.observe(now);
  CHECK(reached.value("nearest_m") == Approx(std::hypot(3.0, 0.3)));
  CHECK_FALSE(reached.value("time_s"));
  // Straight on along y = 0, 0.01 m a step: within 0.5 m of (0, 0.3) from x = -0.4 on.
  for (int i = 1; i <= 600; ++i) {
    now["r1"].pose.x = -3.0 + 0.01 * i;
    reached.observe(now.step());
  }
  CHECK(reached.value("time_s") == Approx(2.60).margin(0.0101));
  CHECK(reached.value("nearest_m") == Approx(0.3));
}

TEST_CASE("A place may go with another robot, and may be where the robot starts") {
  Scene now;
  now.robot("r1", 0, 1).robot("guide", 0, 0, "red", 90);
  Measure beside("place_reached",
                 {{"robot", "r1"}, {"of", "guide"}, {"x", 1.0}, {"y", 0.0}, {"radius", 0.01}});
  beside.observe(now);
  CHECK(beside.value("time_s") == 0.0);  // ahead of a guide that looks north
  CHECK(beside.value("nearest_m") == Approx(0.0).margin(1e-12));
}

TEST_CASE("Places that cannot be are refused") {
  const Scene now = three_robots();
  const auto place = [](const Settings& settings) { return Measure("place_reached", settings); };
  CHECK(refusal(place({{"robot", "r7"}}), now) ==
        "there is no robot 'r7' in the world; there are 'r1', 'r2', 'b1'");
  CHECK(refusal(place({{"robot", "r1"}, {"of", "r7"}}), now) ==
        "there is no robot 'r7' in the world; there are 'r1', 'r2', 'b1'");
  CHECK(refusal(place({{"robot", "r1"}, {"of", "r1"}}), now) ==
        "it gives the robot 'r1' a place relative to itself; name another one in 'of'");
  CHECK_THAT(refusal(place({{"robot", "r1"}, {"x", 6.0}}), now),
             Catch::StartsWith("its place (6, 0) is outside of the arena"));
  CHECK(refusal(place({{"robot", "r1"}, {"of", "r2"}, {"x", 6.0}}), now).empty());
  CHECK_THROWS_WITH(place({}), Catch::Contains("its parameter 'robot' has no default"));
}

TEST_CASE("A group with a leader is gathered when all are near it") {
  Scene now;
  now.robot("lead").leads().robot("a", 1, 0).robot("b", 0, 2).robot("far", 4, 4, "blue");
  Measure gathered("group_gathered", {{"team", "red"}, {"distance", 0.5}});
  gathered.observe(now);
  CHECK(gathered.value("farthest_m") == Approx(2.0));
  CHECK(gathered.value("near") == 0.0);
  now["a"].pose.x = 0.4;
  gathered.observe(now.at_step(100));
  CHECK(gathered.value("near") == 1.0);
  CHECK_FALSE(gathered.value("time_s"));
  now["b"].pose.y = 0.5;
  gathered.observe(now.at_step(200));
  now["b"].pose.y = 0.8;  // and away again
  gathered.observe(now.at_step(300));
  CHECK(gathered.value("time_s") == Approx(2.0));
  CHECK(gathered.value("farthest_m") == Approx(0.8));
  CHECK(gathered.value("near") == 1.0);
}

TEST_CASE("Leaders that nobody follows go by their nearest mate, as a group without one") {
  Scene now;
  now.robot("a", 0, 0).leads().robot("b", 2, 0).leads();
  Measure gathered("group_gathered", {{"distance", 0.5}});
  gathered.observe(now);
  CHECK_FALSE(gathered.value("time_s"));
  CHECK(gathered.value("farthest_m") == Approx(2.0));
  CHECK(gathered.value("near") == 0.0);
  now["b"].pose.x = 0.4;
  gathered.observe(now.at_step(100));
  CHECK(gathered.value("time_s") == Approx(1.0));
  CHECK(gathered.value("near") == 2.0);
}

TEST_CASE("In a group without a leader each robot goes by its nearest mate") {
  Scene now;
  now.robot("a", 0, 0).robot("b", 1, 0).robot("c", 3, 0);
  Measure gathered("group_gathered", {{"distance", 1.0}});
  gathered.observe(now);
  CHECK(gathered.value("farthest_m") == Approx(2.0));
  CHECK(gathered.value("near") == 2.0);
  now["c"].pose.x = 2.0;
  gathered.observe(now.step());
  CHECK(gathered.value("time_s") == Approx(0.01));
  CHECK(refusal(Measure("group_gathered", {{"team", "blue"}}), three_robots()) ==
        "a group is at least two robots, but the team 'blue' has 1");
}

namespace {

const testing::Elements kPair{{"member", {{"robot", "a"}, {"x", -0.5}, {"y", 0.5}}},
                              {"member", {{"robot", "b"}, {"x", -0.5}, {"y", -0.5}}}};

}  // namespace

TEST_CASE("The error of a formation is the mean distance from places that turn with the leader") {
  Scene now;
  now.robot("lead", 1, 1, "red", 90).leads().robot("a").robot("b");
  Measure error("formation_error", {{"leader", "lead"}}, kPair);
  // The leader looks north: behind it is south, and its left is west.
  const auto off = [&](double a, double b) {
    now["a"].pose = {1.0 - 0.5 + a, 1.0 - 0.5, 0.0};
    now["b"].pose = {1.0 + 0.5, 1.0 - 0.5 + b, 0.0};
  };
  off(9.0, 9.0);
  error.observe(now);  // has no duration
  CHECK_FALSE(error.value("mean_m"));
  off(0.0, 0.0);
  error.observe(now.step());
  CHECK(error.value("mean_m") == Approx(0.0).margin(1e-12));
  off(0.3, 0.1);
  error.observe(now.step());
  off(0.0, -0.4);
  error.observe(now.step());
  CHECK(error.value("mean_m") == Approx((0.0 + 0.2 + 0.2) / 3.0));
  CHECK(error.value("largest_m") == Approx(0.4));
  CHECK(error.value("end_m") == Approx(0.2));
}

TEST_CASE("The time to fall in can be left out of a formation's error") {
  Scene now;
  now.robot("lead").leads().robot("a", -0.5, 2.5).robot("b", -0.5, -0.5);
  Measure error("formation_error", {{"leader", "lead"}, {"from_s", 1.0}}, kPair);
  error.observe(now);
  error.observe(now.at_step(100));  // the step that ends at 1 s
  CHECK_FALSE(error.value("mean_m"));
  now["a"].pose.y = 0.7;
  error.observe(now.at_step(101));
  CHECK(error.value("mean_m") == Approx(0.1));
  CHECK(error.value("largest_m") == Approx(0.2));
}

TEST_CASE("A formation has a leader and members, each once") {
  Scene now;
  now.robot("lead").robot("a").robot("b");
  const auto formation = [](const testing::Elements& members) {
    return Measure("formation_error", {{"leader", "lead"}}, members);
  };
  CHECK_THAT(refusal(formation({}), now), Catch::StartsWith("it has no members"));
  CHECK(refusal(formation({{"member", {{"robot", "lead"}}}}), now) ==
        "the robot 'lead' is the leader; expected another one");
  CHECK(refusal(formation({{"member", {{"robot", "a"}}}, {"member", {{"robot", "a"}}}}), now) ==
        "the robot 'a' is a <member> already; expected another one");
  CHECK(refusal(formation({{"member", {{"robot", "c"}}}}), now) ==
        "there is no robot 'c' in the world; there are 'lead', 'a', 'b'");
}

TEST_CASE("Coverage counts the cells that robots have been in") {
  Scene now;
  now.arena(4, 2).robot("r1", -1.9, -0.9);
  Measure coverage("coverage", {{"cell", 0.5}});
  coverage.observe(now);
  CHECK(coverage.value("area_m2") == Approx(0.25));
  CHECK(coverage.value("share") == Approx(1.0 / 32.0));
  // Along the lower wall to the other corner: the eight cells of the lowest row.
  for (int i = 0; i <= 38; ++i) {
    now["r1"].pose.x = -1.9 + 0.1 * i;
    coverage.observe(now.step());
  }
  CHECK(coverage.value("area_m2") == Approx(2.0));
  coverage.observe(now.step());
  CHECK(coverage.value("area_m2") == Approx(2.0));
  CHECK(coverage.value("share") == Approx(0.25));
  now["r1"].pose = {7.0, 0.0, 0.0};  // arenas may have no walls
  coverage.observe(now.step());
  CHECK(coverage.value("area_m2") == Approx(2.0));
}

TEST_CASE("The cells at the far walls are cut off where the cell does not divide the arena") {
  Scene now;
  now.arena(1.0, 1.0).robot("r1", 0.49, 0.49);
  Measure coverage("coverage", {{"cell", 0.4}});
  coverage.observe(now);
  CHECK(coverage.value("area_m2") == Approx(0.04));  // 0.2 m x 0.2 m
  for (const double x : {-0.49, -0.05, 0.49}) {
    for (const double y : {-0.49, -0.05, 0.49}) {
      now["r1"].pose = {x, y, 0.0};
      coverage.observe(now.step());
    }
  }
  CHECK(coverage.value("share") == Approx(1.0));
  CHECK(coverage.value("area_m2") == Approx(1.0));
  CHECK_THAT(refusal(Measure("coverage", {{"cell", 1e-4}}), now),
             Catch::Contains("make 'cell' larger"));
}
