// Nests, and the resources that are carried there.
#include <string>

#include <catch2/catch.hpp>

#include "elsie/world/floor.h"
#include "elsie/world/writer.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("A nest is a grey disc for any team, unless the file says more") {
  const world::World w = read(
      "<nests><nest/><nest id=\"home\" team=\"red\" x=\"2\" radius=\"0.3\" "
      "colour=\"#ff0000\"/></nests>");
  REQUIRE(w.nests.size() == 2);
  CHECK(w.nests[0].id == "nest_1");
  CHECK(w.nests[0].team.empty());
  CHECK(w.nests[0].radius == 0.5);
  CHECK(w.nests[1].id == "home");
  CHECK(w.nests[1].team == "red");
  const world::FloorMap floor(w);
  CHECK(floor.colour_at({0.49, 0.0}) == Colour{0xb0, 0xb0, 0xb0});
  CHECK(floor.colour_at({2.29, 0.0}) == Colour{255, 0, 0});
  CHECK(floor.colour_at({2.31, 0.0}) == world::kPlainFloor);
}

TEST_CASE("A patch covers a nest") {
  const world::World w =
      read("<nests><nest/></nests><patches><disc_patch radius=\"0.1\"/></patches>");
  CHECK(world::FloorMap(w).colour_at({0.0, 0.0}) == Colour{0, 0, 0});
}

TEST_CASE("A resource is collected by touch, or it can be pushed, held and carried to a nest") {
  const world::World w = read(
      "<resources><resource/><resource x=\"1\" collect=\"nest\" mass=\"0.5\" "
      "hands=\"2\"/></resources>");
  REQUIRE(w.obstacles.size() == 2);
  CHECK_FALSE(w.obstacles[0].is_dynamic());
  CHECK(w.obstacles[1].is_dynamic());
  CHECK(w.obstacles[1].mass == 0.5);
  CHECK(w.obstacles[1].hands == 2);
  const std::string text = world::write_world(w);
  CHECK_THAT(text, Catch::Contains("collect=\"nest\"") && Catch::Contains("hands=\"2\""));
}

TEST_CASE("A goal of delivery needs a nest, and something to deliver") {
  const std::string nest = "<nests><nest/></nests>";
  const std::string puck = "<resources><resource x=\"2\" collect=\"nest\"/></resources>";
  const std::string goal = "<goals><deliver count=\"2\"/></goals>";
  CHECK_NOTHROW(read(nest + puck + goal));
  CHECK_THROWS_WITH(read(puck + goal), Catch::Contains("<deliver> has nowhere to deliver to"));
  CHECK_THROWS_WITH(read(nest + goal), Catch::Contains("<deliver> has nothing to deliver"));
}

TEST_CASE("Nests of one team do not overlap; those of two teams may") {
  CHECK_NOTHROW(read("<nests><nest team=\"red\"/><nest team=\"blue\"/></nests>"));
  CHECK_THROWS_WITH(read("<nests><nest id=\"a\"/><nest id=\"b\" x=\"0.9\"/></nests>"),
                    Catch::Contains("the nest 'b' overlaps the nest 'a'") &&
                        Catch::Contains("expected nests apart, or of different teams"));
  CHECK_THROWS_WITH(read("<nests><nest id=\"a\" x=\"9\"/></nests>"),
                    Catch::Contains("the nest 'a'") && Catch::Contains("outside"));
}
