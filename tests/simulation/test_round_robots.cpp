// The robots with round bodies that are shipped.
#include <catch2/catch.hpp>

#include "elsie/world/footprint.h"
#include "elsie/world/parts.h"

#include "measures_support.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

TEST_CASE("Kheperas have the sizes and weights of their data sheets") {
  const world::World world = shipped_world("khepera", 1.0);
  const struct { double diameter, mass; } sheets[] = {{0.055, 0.07}, {0.07, 0.08}};
  REQUIRE(world.robots.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CAPTURE(world.robots[i].id);
    const BodyPlan plan = world::plan_of(world.robots[i]);
    CHECK(plan.parts[0].shape.is_round());
    CHECK(2.0 * plan.parts[0].shape.radius() == Approx(sheets[i].diameter));
    CHECK(world::extents_of(plan.parts).z == Approx(0.03));
    double mass = 0.0;
    for (const Part& part : plan.parts) mass += part.mass;
    CHECK(mass == Approx(sheets[i].mass).epsilon(0.001));
  }
  // The wheels of the first one stand out by half a millimetre to either side.
  CHECK(world::extents_of(world::plan_of(world.robots[0].body, {}).parts).y == Approx(0.028));
  CHECK(world::radius_of(world::plan_of(world.robots[1].body, {}).parts) == Approx(0.035));
}

TEST_CASE("A round robot may be put as near to a wall as its radius, whatever its heading") {
  Simulation simulation(shipped_world("khepera", 1.0), shipped());  // the arena is 1 m wide
  for (const char* heading : {"0", "30", "45"}) {
    CAPTURE(heading);
    simulation.edit("robot[khepera2]/@heading_deg", heading);
    CHECK_NOTHROW(simulation.edit("robot[khepera2]/@x", "0.465"));
    CHECK_THROWS_WITH(simulation.edit("robot[khepera2]/@x", "0.466"),
                      Catch::Contains("the robot 'khepera2' reaches 0.001 m into the east wall"));
  }
}
