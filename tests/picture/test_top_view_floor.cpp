// The floor and the lights of a picture from above.
#include <catch2/catch.hpp>

#include "elsie/picture/floor_field.h"
#include "elsie/picture/floor_tiles.h"

#include "stage.h"

using namespace elsie;
using namespace elsie::picture;
using namespace elsie::picture::test;

TEST_CASE("The floor has its colour, its image and its patches, below everything") {
  Stage scene;
  scene.world.floor.colour = Colour{40, 90, 60};
  const auto colour = [&](double x, double y) {
    const Pixel found = scene.image().at(scene.place(x, y));
    return Colour{static_cast<std::uint8_t>(found.red), static_cast<std::uint8_t>(found.green),
                  static_cast<std::uint8_t>(found.blue)};
  };
  CHECK(colour(1.3, 1.3) == Colour{40, 90, 60});
  scene.world.floor.pixels =
      std::make_shared<const Image>(Image{2, 2, 3, {200, 0, 0, 0, 200, 0, 0, 0, 200, 200, 200, 0}});
  scene.world.floor.image_length = scene.world.floor.image_width = 8.0;
  CHECK(colour(-2.3, 2.3) == Colour{200, 0, 0});
  CHECK(colour(2.3, 2.3) == Colour{0, 200, 0});
  CHECK(colour(-2.3, -2.3) == Colour{0, 0, 200});
  CHECK(colour(4.3, 4.3) == Colour{40, 90, 60});
  world::Patch& line = scene.world.patches.emplace_back();
  line.shape = world::PatchShape::line;
  line.points = {{-3.3, 0.7}, {3.3, 0.7}};
  line.line_width = 0.2;
  CHECK(colour(2.3, 0.65) == Colour{0, 0, 0});
  CHECK(colour(3.38, 0.7) == Colour{0, 0, 0});  // its round end
  scene.world.patches.push_back({.id = "spot",
                                 .shape = world::PatchShape::disc,
                                 .x = 2.3,
                                 .y = 0.7,
                                 .radius = 0.3,
                                 .points = {},
                                 .colour = {9, 9, 200}});
  CHECK(colour(2.3, 0.65) == Colour{9, 9, 200});
}

TEST_CASE("A nest is a disc of its colour on the floor, below the patches") {
  Stage scene;
  const auto colour = [&](double x, double y) {
    const Pixel found = scene.image().at(scene.place(x, y));
    return Colour{static_cast<std::uint8_t>(found.red), static_cast<std::uint8_t>(found.green),
                  static_cast<std::uint8_t>(found.blue)};
  };
  const Colour bare = colour(2.3, 0.7);
  world::Nest& nest = scene.world.nests.emplace_back();
  nest.x = 2.3;
  nest.y = 0.7;
  nest.radius = 0.6;
  nest.colour = {10, 120, 200};
  CHECK(colour(2.3, 0.7) == Colour{10, 120, 200});
  CHECK(colour(2.8, 0.7) == Colour{10, 120, 200});
  CHECK(colour(3.3, 1.3) == bare);
  scene.world.patches.push_back({.id = "spot",
                                 .shape = world::PatchShape::disc,
                                 .x = 2.3,
                                 .y = 0.7,
                                 .radius = 0.2,
                                 .points = {},
                                 .colour = {9, 9, 20}});
  CHECK(colour(2.3, 0.7) == Colour{9, 9, 20});
}

TEST_CASE("A lamp is a small sun with its name, and the legend explains it") {
  Stage scene;
  const Bitmap without = scene.image();
  scene.world.lamps.push_back({.id = "sun", .x = 2.0, .y = 1.3, .colour = {255, 160, 0}});
  const Bitmap with = scene.image();
  const Vector2 at = scene.place(2.0, 1.3);
  CHECK(with.at(at).red > with.at(at).blue + 60);
  CHECK(with.count(at, 60, [](const Pixel& pixel) { return !pixel.light(); }) >
        without.count(at, 60, [](const Pixel& pixel) { return !pixel.light(); }) + 60);
}

TEST_CASE("What an actuator of a robot shines is a small sun of its colour") {
  Stage scene;
  scene.add_robot("r1", "blue", {1.0, 0.5, 0.0});
  RobotTrack track;
  track.id = "r1";
  track.now = {1.0, 0.5, 0.0};
  scene.view.robots = {track};
  const Vector2 at = scene.place(1.04, 0.5);
  const Bitmap dark = scene.image();
  scene.view.robots[0].lights = {{{1.04, 0.5}, {255, 160, 0}}};
  const Bitmap bright = scene.image();
  CHECK(bright.at(at).red > bright.at(at).blue + 60);
  CHECK_FALSE(dark.at(at).red > dark.at(at).blue + 60);
}

TEST_CASE("The tiles of an image are as few as its colours allow, and cover it") {
  world::World world;
  CHECK(floor_tiles(world, 100).empty());
  Image image{40, 30, 3, std::vector<std::uint8_t>(40 * 30 * 3, 255)};
  world.floor.pixels = std::make_shared<const Image>(image);
  CHECK(floor_tiles(world, 100).size() == 1);
  image.bytes[(15 * 40 + 20) * 3] = 7;  // one pixel
  world.floor.pixels = std::make_shared<const Image>(image);
  const auto tiles = floor_tiles(world, 100);
  CHECK(tiles.size() == 5);
  double area = 0.0;
  for (const FloorTile& tile : tiles) area += (tile.right - tile.left) * (tile.top - tile.bottom);
  CHECK(area == Approx(100.0));
  CHECK(floor_tiles(world, 10).size() <= 5);
}

TEST_CASE("A field lies over the floor in its colour, the more opaque the larger it is") {
  Stage scene;
  scene.world.floor.colour = Colour{200, 200, 200};
  const Bitmap without = scene.image();
  FloorField& field = scene.view.fields.emplace_back();
  field.id = "pheromone";
  field.colour = {0, 0, 250};
  field.columns = field.rows = 2;
  field.values = {0.0F, 2.0F, 4.0F, 0.0F};  // from the south-west to the north-east
  const auto red = [&](const Bitmap& image, double x, double y) {
    return image.at(scene.place(x, y)).red;
  };
  const Bitmap with = scene.image();
  CHECK(red(with, -2.3, -2.3) == red(without, -2.3, -2.3));
  CHECK(red(with, 2.3, -2.3) == Approx(200 * (1 - 0.85 * 0.5)).margin(3));
  CHECK(red(with, -2.3, 2.3) == Approx(200 * (1 - 0.85)).margin(3));
  field.full = 8.0;
  CHECK(red(scene.image(), -2.3, 2.3) == Approx(200 * (1 - 0.85 * 0.5)).margin(3));
  field.values.assign(4, 0.0F);
  CHECK(red(scene.image(), -2.3, 2.3) == red(without, -2.3, 2.3));
}

TEST_CASE("The tiles of a field leave out what is empty, and join what is equal") {
  FloorField field;
  field.columns = 4, field.rows = 2;
  field.values = {1.0F, 1.0F, 0.0F, 0.5F, 1.0F, 1.0F, 0.0F, 0.0F};
  world::Arena arena;
  arena.length = 4.0, arena.width = 2.0;
  const std::vector<FloorTile> tiles = field_tiles(field, arena, 100);
  REQUIRE(tiles.size() == 3);
  CHECK(tiles[0].left == -2.0);
  CHECK(tiles[0].right == 0.0);
  CHECK(tiles[0].opacity == 217);
  CHECK(tiles[2].left == 1.0);
  CHECK(tiles[2].bottom == -1.0);
  CHECK(tiles[2].opacity == 108);
  CHECK(field_tiles(field, arena, 2).size() == 3);  // every second column
}

TEST_CASE("A nest has its team's colour at its edge") {
  Stage scene;
  scene.world.nests.push_back({.id = "home", .team = "red", .x = -2.3, .y = 0.7, .radius = 0.8});
  scene.world.nests.push_back({.id = "away", .team = "blue", .x = 2.3, .y = 0.7, .radius = 0.8});
  const Bitmap image = scene.image();
  const auto red = [](const Pixel& pixel) { return pixel.reddish(); };
  const auto blue = [](const Pixel& pixel) { return pixel.bluish(); };
  CHECK(image.count(scene.place(-2.3, 1.5), 2, red) > 0);
  CHECK(image.count(scene.place(-2.3, 1.5), 2, blue) == 0);
  CHECK(image.count(scene.place(2.3, 1.5), 2, blue) > 0);
  CHECK(image.count(scene.place(2.3, 1.2), 2, blue) == 0);
}
