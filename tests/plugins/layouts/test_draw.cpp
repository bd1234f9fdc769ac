// <draw>: attributes that are drawn at random, and what edits change of it.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "support.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

TEST_CASE("Attributes are drawn within their bounds, for each thing separately") {
  const world::World world =
      drawn(scattered("count='30'",
                      "<robot id='r' template='robots/scout.xml'/>"
                      "<draw path='@max_speed' from='0.1' to='0.3'/>"
                      "<draw path='sensor[left]/@yaw_deg' mean='15' sd='2' from='12' to='16'/>"
                      "<draw path='@battery' from='10' to='12' whole='true'/>"),
            4);
  std::set<double> speeds, batteries;
  for (const world::Robot& robot : world.robots) {
    speeds.insert(robot.max_speed);
    batteries.insert(robot.battery);
    CHECK((robot.max_speed >= 0.1 && robot.max_speed <= 0.3));
  }
  CHECK(speeds.size() > 25);
  CHECK(batteries == std::set<double>{10, 11, 12});
}

TEST_CASE("A <draw> draws for everything at its path, what is scattered included") {
  const world::World world = drawn(
      "<robots><robot id='a' x='-4'/><robot id='b' x='4'/></robots><layouts>"
      "<scatter id='c' count='3'><robot id='r'/></scatter>"
      "<draw path='robot[*]/@coverage' from='1' to='2'/></layouts>");
  std::set<double> drawn_values;
  for (const world::Robot& robot : world.robots) {
    CHECK((robot.coverage >= 1.0 && robot.coverage <= 2.0));
    drawn_values.insert(robot.coverage);
  }
  CHECK(drawn_values.size() == 5);
}

TEST_CASE("A <draw> that says too little, or leads nowhere, is refused") {
  const auto draw = [](const std::string& attributes) {
    return refusal("<robots><robot id='r'/></robots><layouts><draw " + attributes + "/></layouts>");
  };
  CHECK_THAT(draw("path='robot[*]/@coverage' from='1'"), Contains("expected from and to, or mean"));
  CHECK_THAT(draw("path='robot[*]/@coverage' mean='1'"), Contains("expected from and to, or mean"));
  CHECK_THAT(draw("path='robot[*]/@coverage' from='3' to='1'"), Contains("the least value first"));
  CHECK_THAT(draw("path='robot[q]/@coverage' from='1' to='2'"), Contains("there is no robot[q]"));
  CHECK_THAT(draw("path='robot[r]' from='1' to='2'"), Contains("leads to no attribute"));
  CHECK_THAT(draw("path='robot[r]/@covrage' from='1' to='2'"),
             Contains("did you mean 'coverage'?"));
}

TEST_CASE("Whatever a <draw> changes of a thing's area is drawn before its place is checked") {
  const std::string obstacles =
      "<scatter id='c' count='40' gap='0.1'><static_box length='1.2' width='0.1'/>";
  const std::string in_thing = "<draw path='@heading_deg' from='0' to='180'/></scatter>";
  const std::string of_world =
      "</scatter><draw path='obstacle[*]/@heading_deg' from='0' to='180'/>";
  for (const std::string& draws : {in_thing, of_world}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto all = footprints(drawn("<layouts>" + obstacles + draws + "</layouts>", seed));
      REQUIRE(all.size() == 40);
      for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(are_nearer(all[i], all[j], 0.099));
      }
    }
  }
}

TEST_CASE("What the user sets is not drawn") {
  const std::string world =
      "<robots><robot id='a' x='-4'/><robot id='b' x='4'/></robots><layouts>"
      "<scatter id='c' count='3'><static_box/><draw path='@length' from='1' to='2'/></scatter>"
      "<draw id='d' path='robot[*]/@coverage' from='1' to='2'/></layouts>";
  const world::World as_drawn = drawn(world);
  const world::World one = drawn(world, 1, {"robot[a]/@coverage=5"});
  CHECK(one.robots[0].coverage == 5.0);
  CHECK(one.robots[1].coverage == as_drawn.robots[1].coverage);
  for (const auto& box : drawn(world, 1, {"obstacle[*]/@length=0.5"}).obstacles) {
    CHECK(box.length == 0.5);
  }
  CHECK(drawn(world, 1, {"obstacle[c2]/@length=0.5"}).obstacles[1].length == 0.5);
}

TEST_CASE("Of two edits of one attribute, the last decides, drawn or not") {
  const std::string one = "obstacle[clutter2]/@length=0.3", all = "obstacle[*]/@length=0.4";
  CHECK(drawn(kClutter, 1, {one, all}).obstacles[1].length == 0.4);
  CHECK(drawn(kClutter, 1, {all, one}).obstacles[1].length == 0.3);
  CHECK(drawn(kClutter, 1, {all, one}).obstacles[2].length == 0.4);
  CHECK(drawn(kClutter, 1, {one, "obstacle[clutter2]/@length=0.5", "scatter/@count=4"})
            .obstacles[1]
            .length == 0.5);
  const world::World more =
      drawn(kClutter, 1, {one, "obstacle[+]=<static_box id='own' x='4.8' y='4.8'/>"});
  CHECK(more.obstacles.size() == 31);
}

TEST_CASE("Whole numbers include both bounds, each as often as the others") {
  const world::World world =
      drawn(scattered("count='3000' gap='0'",
                      "<charger radius='0.001'/><draw path='@rate' from='0.5' to='3.5' "
                      "whole='true'/>"));
  std::map<double, int> count;
  for (const auto& each : world.chargers) ++count[each.rate];
  CHECK(count.size() == 3);
  for (const double value : {1.0, 2.0, 3.0}) {
    CHECK(count[value] == Approx(1000).margin(80));  // three standard deviations
  }
}

TEST_CASE("The arena may be drawn, and layouts fill the one that was drawn") {
  const std::string world =
      "<layouts><draw path='arena/@length' from='20' to='40'/><scatter id='c' count='200' gap='0'>"
      "<static_box/></scatter><maze columns='3' rows='3' border='true'/></layouts>";
  const world::World large = drawn(world, 2);
  CHECK(large.arena.length > 20.0);
  double right = 0.0;
  for (const world::Obstacle& box : large.obstacles) right = std::max(right, box.x);
  CHECK(right == Approx(0.5 * large.arena.length - 0.05).margin(0.0001));
  CHECK(refusal("<layouts><draw path='arena/@length' from='-3' to='-2'/></layouts>")
            .find("of <arena>: expected") != std::string::npos);
}

TEST_CASE("A distribution that cannot be drawn from is refused in a sentence") {
  const auto draw = [](const std::string& attributes) {
    return refusal("<layouts><draw id='d' path='arena/@length' " + attributes + "/></layouts>");
  };
  CHECK_THAT(draw("mean='9' sd='-1'"), Contains("sd=\"-1\""));
  CHECK_THAT(draw("mean='nan' sd='1'"), Contains("mean=\"nan\""));
  CHECK_THAT(draw("from='inf' to='inf'"), Contains("from=\"inf\""));
  CHECK(draw("mean='9' sd='1' to='8'") ==
        "w.xml:2: the layout 'd' draws 'arena/@length' with the mean 9 and values to 8; expected a "
        "mean among these values");
  CHECK_THAT(draw("mean='9' sd='1' from='10' to='12'"), Contains("and values from 10 to 12"));
  CHECK_THAT(draw("mean='9' sd='100' from='8.9' to='9.1'"),
             Contains("less than a hundredth of it; leave out mean and sd"));
  CHECK_THAT(draw("from='9.2' to='9.8' whole='true'"), Contains("from 9.2 to 9.8, where there is"));
}
