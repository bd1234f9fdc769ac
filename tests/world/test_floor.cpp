// Lamps, the floor and its patches: what a file says, and what colour the floor has where.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/world/colours.h"
#include "elsie/world/floor.h"
#include "elsie/world/world_tree.h"
#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"
#include "folder.h"

using namespace elsie;
using namespace elsie::test;

namespace {

constexpr Colour kBlack{0, 0, 0}, kWhite{255, 255, 255}, kRed{255, 0, 0}, kBlue{0, 0, 255};

Colour colour_at(const std::string& content, double x, double y) {
  return world::FloorMap(read(content)).colour_at({x, y});
}

std::string patch(const std::string& markup) { return "<patches>" + markup + "</patches>"; }

world::World edited(const world::World& world, std::vector<std::string> edits) {
  return world::edited(world::WorldTree(world), host(), options(std::move(edits)));
}

}  // namespace

TEST_CASE("A lamp is white, half a metre up and of intensity 1, unless the file says more") {
  const world::World w =
      read("<lamps><lamp/><lamp id=\"sun\" z=\"2\" colour=\"#ff0000\"/></lamps>");
  REQUIRE(w.lamps.size() == 2);
  CHECK(w.lamps[0].id == "lamp_1");
  CHECK(w.lamps[0].z == 0.5);
  CHECK(w.lamps[0].intensity == 1.0);
  CHECK(w.lamps[0].colour == kWhite);
  CHECK(w.lamps[1].id == "sun");
  CHECK(w.lamps[1].colour == kRed);
}

TEST_CASE("Patches of all shapes are in one list, in the order of the file, and numbered") {
  const world::World w =
      read(patch("<disc_patch/><rectangle_patch/><disc_patch/>"
                 "<line_patch><point x=\"0\" y=\"0\"/><point x=\"1\" y=\"0\"/></line_patch>"));
  REQUIRE(w.patches.size() == 4);
  CHECK(w.patches[0].id == "disc_patch_1");
  CHECK(w.patches[1].id == "rectangle_patch_1");
  CHECK(w.patches[2].id == "disc_patch_2");
  CHECK(w.patches[3].element() == "line_patch");
  CHECK(w.patches[3].points.size() == 2);
  CHECK(w.patches[0].colour == kBlack);
}

TEST_CASE("A plain floor is white to sensors, and another has its colour, also outside") {
  CHECK(colour_at("", 1, 1) == kWhite);
  CHECK(colour_at("<floor colour=\"#ff0000\"/>", 1, 1) == kRed);
  CHECK(colour_at("<floor colour=\"#ff0000\"/>", 7, 1) == kRed);
  CHECK(colour_at("<floor colour=\"#ff0000\"/>" + patch("<disc_patch x=\"4.9\" radius=\"1\"/>"),
                  5.1, 0) == kRed);
  CHECK(colour_at("", std::nan(""), 0) == kWhite);
}

TEST_CASE("Edges belong to a patch, at any angle") {
  const std::string square =
      patch("<rectangle_patch x=\"1\" y=\"-1\" heading_deg=\"30\" length=\"0.7\" width=\"0.3\"/>");
  const world::FloorMap map(read(square));
  const Pose pose{1, -1, radians(30)};
  for (int i = 0; i <= 20; ++i) {
    const double along = -0.35 + 0.035 * i;
    CHECK(map.colour_at(point_of(pose, {along, 0.15})) == kBlack);
    CHECK(map.colour_at(point_of(pose, {along, -0.15})) == kBlack);
    CHECK(map.colour_at(point_of(pose, {along, 0.15 + 1e-6})) == kWhite);
    CHECK(map.colour_at(point_of(pose, {along, -0.15 - 1e-6})) == kWhite);
  }
  const world::FloorMap disc(read(patch("<disc_patch x=\"0.3\" radius=\"0.1\"/>")));
  for (int i = 0; i < 36; ++i) {
    const double a = radians(10.0 * i), c = std::cos(a), s = std::sin(a);
    CHECK(disc.colour_at({0.3 + 0.1 * c, 0.1 * s}) == kBlack);
    CHECK(disc.colour_at({0.3 + 0.100001 * c, 0.100001 * s}) == kWhite);
  }
}

TEST_CASE("A polygon is placed by its center of area, as a prism is") {
  const std::string triangle = patch(
      "<polygon_patch x=\"1\" y=\"1\"><point x=\"5\" y=\"5\"/><point x=\"5.3\" y=\"5\"/>"
      "<point x=\"5\" y=\"5.3\"/></polygon_patch>");
  CHECK(colour_at(triangle, 0.9, 0.9) == kBlack);    // a corner
  CHECK(colour_at(triangle, 1.05, 1.05) == kBlack);  // the middle of the long side
  CHECK(colour_at(triangle, 1.06, 1.06) == kWhite);
  CHECK(colour_at(triangle, 0.89, 0.9) == kWhite);
}

TEST_CASE("A line has its width, with round ends and bends") {
  const std::string line = patch(
      "<line_patch x=\"1\" width=\"0.2\"><point x=\"0\" y=\"0\"/><point x=\"1\" y=\"0\"/>"
      "<point x=\"1\" y=\"1\"/></line_patch>");
  CHECK(colour_at(line, 1.5, 0.1) == kBlack);
  CHECK(colour_at(line, 1.5, 0.101) == kWhite);
  CHECK(colour_at(line, 0.9, 0) == kBlack);  // the end
  CHECK(colour_at(line, 0.92, 0.09) == kWhite);
  CHECK(colour_at(line, 2.07, -0.07) == kBlack);  // the bend
  CHECK(colour_at(line, 2.08, -0.08) == kWhite);
  CHECK(colour_at(line, 2.0, 1.1) == kBlack);
}

TEST_CASE("The image lies over the floor, patches over the image, and chargers over patches") {
  const std::string image =
      "<floor colour=\"#ff0000\" image=\"floor.png\" image_length=\"4\" image_width=\"2\"/>";
  // Its rows from the north: red, green, blue, white; black, grey, yellow, transparent.
  CHECK(colour_at(image, -1.5, 0.5) == kRed);
  CHECK(colour_at(image, -0.5, 0.5) == Colour{0, 255, 0});
  CHECK(colour_at(image, 0.5, 1.0) == kBlue);  // its edge
  CHECK(colour_at(image, 1.5, -0.5) == kWhite);
  CHECK(colour_at(image, -2.0, -1.0) == kBlack);
  CHECK(colour_at(image, -0.5, -0.5) == Colour{128, 128, 128});
  CHECK(colour_at(image, -2.01, -1.0) == kRed);  // the floor
  const std::string patches =
      image +
      patch("<disc_patch colour=\"#0000ff\"/><rectangle_patch length=\"0.2\" width=\"0.2\"/>");
  CHECK(colour_at(patches, 0.2, 0) == kBlue);
  CHECK(colour_at(patches, 0.05, 0.05) == kBlack);
  const std::string charger =
      patches +
      "<chargers><charger team=\"blue\" radius=\"0.1\"/>"
      "<charger x=\"-0.2\" radius=\"0.01\" seen_by_range_sensors=\"true\"/></chargers>";
  CHECK(colour_at(charger, 0.05, 0.05) == world::kBlueTeam);
  CHECK(colour_at(charger, -0.2, 0.0) == kBlue);  // a box is no mark
  // Without a size, it spans the arena.
  CHECK(colour_at("<floor image=\"floor.png\"/>", 4.9, 4.9) == kWhite);
  CHECK(colour_at("<floor image=\"floor.png\"/>", 2.6, -0.1) == kWhite);
  CHECK(colour_at("<floor image=\"floor.png\"/>", 2.4, -0.1) == Colour{255, 255, 0});
}

TEST_CASE("Of many patches, the last one that covers a place counts, as if all were asked") {
  std::string many;
  for (int i = 0; i < 600; ++i) {
    const std::string at = " x=\"" + std::to_string(-4.9 + 0.61 * (i % 17)) + "\" y=\"" +
                           std::to_string(-4.9 + 0.53 * (i % 19)) + "\"";
    const std::string colour = " colour=\"#" + std::to_string(100000 + i) + "\"";
    many += i % 3 == 0   ? "<disc_patch radius=\"0.4\"" + at + colour + "/>"
            : i % 3 == 1 ? "<rectangle_patch heading_deg=\"" + std::to_string(i % 90) + "\"" + at +
                               colour + "/>"
                         : "<polygon_patch" + at + colour +
                               "><point x=\"0\" y=\"0\"/><point x=\"0.9\" y=\"0\"/><point x=\"0\" "
                               "y=\"0.4\"/></polygon_patch>";
  }
  const world::World w = read(patch(many));
  const world::FloorMap all(w);
  for (int i = 0; i < 400; ++i) {
    const Vector2 place{-4.9 + 0.4901 * (i % 20), -4.9 + 0.4903 * (i / 20)};
    Colour expected = kWhite;
    for (const world::Patch& each : w.patches) {
      world::World one;
      one.patches = {each};
      const Colour found = world::FloorMap(one).colour_at(place);
      if (!(found == kWhite)) expected = found;
    }
    CHECK(all.colour_at(place) == expected);
  }
}

TEST_CASE("An edit of a running world keeps the image without reading its file again") {
  const Folder folder;
  namespace fs = std::filesystem;
  fs::copy_file(kFolder + "data/floor.png", folder / "mine.png");
  const world::World before =
      world::parse_world("<world format=\"1\"><floor image=\"mine.png\"/>" +
                             patch("<disc_patch id=\"d\"/>") + "<lamps><lamp/></lamps></world>",
                         (folder / "w.xml").string(), host(), options());
  REQUIRE(before.floor.pixels);
  CHECK(before.floor.image_file == fs::canonical(folder / "mine.png"));
  fs::remove(folder / "mine.png");
  const world::World after = edited(before, {"floor/@colour=#00ff00", "patch[d]/@x=2",
                                             "patch[+]=<line_patch><point x=\"0\" "
                                             "y=\"0\"/><point x=\"1\" y=\"0\"/></line_patch>",
                                             "lamp[1]/@colour=#ff0000", "lamp[+]=<lamp x=\"1\"/>"});
  CHECK(after.floor.pixels == before.floor.pixels);
  CHECK(after.patches.size() == 2);
  CHECK(after.patches[0].x == 2.0);
  CHECK(after.lamps.size() == 2);
  CHECK(after.lamps[0].colour == kRed);
  // No body is another one.
  CHECK(world::same(world::vocabulary(), &before, &after, world::Cost::object));
  CHECK_FALSE(world::same(world::vocabulary(), &before, &after, world::Cost::nothing));
  CHECK_FALSE(edited(before, {"floor/@image="}).floor.pixels);
}

TEST_CASE(
    "A lamp may be above a box, and in a running world in place of one that was pushed away") {
  CHECK(problems("<obstacles><static_box height=\"0.4\"/></obstacles><lamps><lamp/></lamps>") ==
        "");
  CHECK(
      problems(
          "<obstacles><static_box height=\"0.6\"/></obstacles><lamps><lamp x=\"0.11\"/></lamps>") ==
      "");
  const world::World pushed = read(
      "<obstacles><dynamic_box id=\"crate\" height=\"0.8\"/><static_box id=\"shelf\" x=\"2\" "
      "height=\"0.8\"/></obstacles>");
  CHECK(edited(pushed, {"lamp[+]=<lamp/>"}).lamps.size() == 1);
  CHECK_THROWS_WITH(edited(pushed, {"lamp[+]=<lamp x=\"2\"/>"}),
                    Catch::Contains("is inside the box 'shelf'"));
}

TEST_CASE("What the floor says is written again") {
  const std::string content =
      "<floor colour=\"#ff0000\" image=\"floor.png\" image_width=\"3\"/>"
      "<lamps><lamp id=\"sun\" z=\"2\"/></lamps>" +
      patch(
          "<disc_patch/><line_patch heading_deg=\"90\"><point x=\"0\" y=\"0\"/><point x=\"1\" "
          "y=\"0\"/>"
          "</line_patch>");
  const world::World w = read(content);
  CHECK(same(w, world::parse_world(world::write_world(w), w.file, host(), options())));
}
