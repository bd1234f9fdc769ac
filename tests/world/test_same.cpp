// What two descriptions differ in, and what that costs.
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/world/same.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using world::Cost;

TEST_CASE("The vocabulary says what a difference costs in a world that runs") {
  const char* const content = R"(
    <arena length="8"/>
    <obstacles><static_box id="brick" x="2"/></obstacles>
    <chargers><charger id="dock" x="-2"/></chargers>
    <robots>
      <robot id="r1"><sensors><beam id="left"/></sensors><behaviors><roam/></behaviors>
        <coordinator><sum/></coordinator></robot>
      <robot id="r2" x="1" y="1"/>
    </robots>
    <goals><endure time="5"/></goals>)";
  const std::vector<std::pair<std::string, Cost>> costs{
      {"@name=other", Cost::nothing},
      {"limits/@time=9", Cost::nothing},
      {"goal[1]/@remove=true", Cost::nothing},
      {"physics/@control_steps=2", Cost::nothing},
      {"obstacle[brick]/@colour=#123456", Cost::nothing},
      {"charger[dock]/@radius=0.4", Cost::nothing},
      {"robot[r1]/@battery=9", Cost::nothing},
      {"robot[r1]/@team=blue", Cost::nothing},
      {"robot[r1]/@max_speed=0.1", Cost::value},
      {"robot[r1]/@x=-1", Cost::value},
      {"robot[r1]/behavior[roam]/@priority=2", Cost::value},
      {"robot[r1]/sensor[left]/@yaw_deg=9", Cost::object},
      {"robot[r1]/behavior[roam]/@speed=9", Cost::object},  // as far as the core knows
      {"robot[r1]/coordinator/@id=other", Cost::object},
      {"robot[r1]/behavior[+]=<avoid/>", Cost::object},
      {"robot[r1]/body/@mass=2", Cost::body},
      {"robot[r1]/segment[+]=<segment/>", Cost::body},
      {"robot[r2]/@remove=true", Cost::engine},
      {"obstacle[brick]/@x=2.1", Cost::engine},
      {"obstacle[+]=<dynamic_box y=\"2\"/>", Cost::engine},
      {"charger[dock]/@seen_by_range_sensors=true", Cost::engine},
      {"arena/@length=9", Cost::engine},
      {"physics/@gravity=-9", Cost::engine}};
  const world::World before = read(content);
  for (const auto& [edit, cost] : costs) {
    CAPTURE(edit);
    const world::World after = read(content, {edit});
    for (const Cost least : {Cost::nothing, Cost::value, Cost::object, Cost::body, Cost::engine}) {
      CAPTURE(static_cast<int>(least));
      CHECK(world::same(world::vocabulary(), &before, &after, least) == (cost < least));
    }
  }
}
