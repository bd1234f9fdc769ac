// What a picture needs of a world.
#include <algorithm>

#include <catch2/catch.hpp>

#include "elsie/picture/bodies.h"
#include "elsie/world/parts.h"
#include "elsie/world/reader.h"

using namespace elsie;
using Catch::Contains;

TEST_CASE("A world whose bodies alone are wanted needs no plugin, and keeps its places to reach") {
  const plugin::Host none;
  const std::string text = R"(<world format="1">
    <robots><robot id="r1" x="1"><sensors><sonar/></sensors><behaviors><nowhere_to_be_found/></behaviors>
      <coordinator><neither/></coordinator></robot></robots>
    <goals><endure time="600"/><reach robot="r1" x="2" y="0"/></goals><limits time="5"/></world>)";
  CHECK_THROWS_AS(world::parse_world(text, "w.xml", none), world::WorldError);
  const world::World world = picture::bodies_of(text, "w.xml", none);
  REQUIRE(world.robots.size() == 1);
  CHECK(world.robots[0].x == 1.0);
  CHECK(world.robots[0].sensors.empty());
  CHECK(world.robots[0].behaviors.empty());
  REQUIRE(world.goals.size() == 1);
  CHECK(std::get<world::ReachGoal>(world.goals[0]).x == 2.0);
}

TEST_CASE("A picture of bodies keeps places to reach in groups, and no goal about events") {
  const plugin::Host none;
  const world::World world = picture::bodies_of(
      R"(<world format="1"><robots><robot id="r1"><behaviors><nowhere_to_be_found/></behaviors></robot></robots>
         <goals><event name="sung"/><all><event name="sung"/></all>
         <any><event name="sung"/><all><reach any="true" x="2" y="0"/><endure time="600"/></all></any>
         </goals></world>)",
      "w.xml", none);
  REQUIRE(world.goals.size() == 1);
  const auto& any = std::get<world::AnyGoal>(world.goals[0]);
  REQUIRE(any.goals.size() == 1);
  CHECK(std::get<world::AllGoal>(any.goals[0]).goals.size() == 1);
}

TEST_CASE("A picture of bodies needs no drive") {
  const plugin::Host none;
  const std::string text =
      "<world format=\"1\"><robots><robot id=\"r1\"><drive><cart gauge=\"0.2\"/></drive></robot>"
      "</robots></world>";
  CHECK_THROWS_WITH(world::parse_world(text, "world.xml", none),
                    Contains("there is no drive 'cart'"));
  const world::World drawn = picture::bodies_of(text, "world.xml", none);
  CHECK_FALSE(drawn.robots[0].drive);
  const BodyPlan plan = world::plan_of(drawn.robots[0]);
  CHECK(std::count_if(plan.parts.begin(), plan.parts.end(),
                      [](const Part& part) { return part.role == PartRole::wheel; }) == 2);
}

TEST_CASE("The image of a floor whose file is gone is left out of a picture, and nothing else") {
  const plugin::Host none;
  const std::string text =
      "<world format=\"1\"><floor colour=\"#112233\" image=\"gone.png\" image_length=\"3\"/>"
      "<patches><disc_patch/></patches></world>";
  CHECK_THROWS_AS(world::parse_world(text, "w.xml", none), world::WorldError);
  const world::World drawn = picture::bodies_of(text, "w.xml", none);
  CHECK_FALSE(drawn.floor.pixels);
  CHECK(drawn.floor.colour == Colour{0x11, 0x22, 0x33});
  CHECK(drawn.patches.size() == 1);
}
