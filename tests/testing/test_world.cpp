#include "elsie/simulation/fault.h"
#include "elsie/testing/catch.h"
#include "elsie/world/error.h"

#include "places.h"

using namespace elsie;
using elsie::testing::World;

namespace {

const char* const kTowardsTheWall = R"(
  <world format="1" name="wall">
    <arena length="2" width="2"/>
    <robots>
      <robot id="r1" team="red">
        <sensors><beam_range id="eye"/></sensors>
        <behaviors><go_to_point id="go" x="5" y="0"/></behaviors>
        <coordinator><arbiter_suppression/></coordinator>
      </robot>
    </robots>
    <limits time="5"/>
  </world>)";

}  // namespace

TEST_CASE("It runs until a condition holds") {
  World world = World::from_text(kTowardsTheWall);
  CHECK(world.run_until([](const World& now) { return now.count("collision", "r1") > 0; }, 5));
  CHECK(world.pose("r1").x == Approx(0.95).margin(0.02));
  CHECK(world.reading<RangeReading>("r1", "eye").distance_m < 0.05);
  CHECK(world.trace("r1", "go").share == 1.0);
  CHECK_FALSE(world.run_until([](const World&) { return false; }, 0.1));
  world.reset(1);
  CHECK(world.time_s() == 0.0);
  CHECK(world.count("collision") == 0);
}

TEST_CASE("It runs to its end, from the start") {
  World world = World::from_text(kTowardsTheWall);
  world.step(10);
  const auto result = world.run();
  CHECK(result.simulated_s == Approx(5.0));
  CHECK(result.outcome == simulation::Outcome::time_limit);
}

TEST_CASE("Attributes are changed as on the command line") {
  World world = World::from_text(kTowardsTheWall, {.set = {"robot[r1]/@x=-0.5"}});
  CHECK(world.pose("r1").x == -0.5);
}

TEST_CASE("Wrong worlds, and wrong ids, are reported") {
  CHECK_THROWS_WITH(World::from_text("<world format='1'><robts/></world>"),
                    Catch::Contains("did you mean '<robots>'?"));
  World world = World::from_text(kTowardsTheWall);
  CHECK_THROWS_WITH(world.pose("r2"), Catch::Contains("there is no robot 'r2'"));
  CHECK_THROWS_WITH(world.trace("r1", "goo"), Catch::Contains("did you mean 'go'?"));
  CHECK_THROWS_WITH(world.reading<RangeReading>("r1", "eyes"),
                    Catch::Contains("did you mean 'eye'?"));
  CHECK_THROWS_WITH(world.reading<VisionReading>("r1", "eye"), Catch::Contains("not 'vision'"));
}

TEST_CASE("A reset with another seed draws layouts that follow the run's seed again") {
  const auto obstacles = [](const World& world) {
    std::vector<double> places;
    for (const auto& box : world.simulation().world().obstacles) places.push_back(box.x);
    return places;
  };
  World world = World::from_text(
      "<world format='1'><layouts><scatter id='c' count='3'><static_box/></scatter>"
      "</layouts></world>",
      {.seed = 4});
  const auto first = obstacles(world);
  CHECK(obstacles(world.reset(5)) != first);
  CHECK(obstacles(world.reset(4)) == first);
}
