#include <cstdlib>

#include <catch2/catch.hpp>

#include "elsie/picture/image_file.h"
#include "elsie/picture/plot.h"
#include "elsie/picture/top_view.h"
#include "elsie/world/description.h"

#include "support.h"

using namespace elsie;
using namespace elsie::picture;
using namespace elsie::picture::test;

namespace {

world::World world_of_everything() {
  world::World world;
  world.name = "Everything <&> \"quoted\"";
  world.teams = {{"red", Colour{208, 49, 30}}, {"blue", Colour{31, 95, 191}}};
  using world::ObstacleKind;
  for (const ObstacleKind kind :
       {ObstacleKind::fixed, ObstacleKind::dynamic, ObstacleKind::moving, ObstacleKind::resource}) {
    world::Obstacle box;
    box.kind = kind;
    box.x = static_cast<double>(static_cast<int>(kind)) - 2;
    box.waypoints = {{1, 1}, {2, 3}};
    world.obstacles.push_back(box);
  }
  world::Robot robot;
  robot.id = "r1";
  robot.team = "red";
  world.robots = {robot};
  world.chargers.emplace_back();
  world.goals = {world::ReachGoal{"r1", 3, 3, 0.3, ""}, world::PushGoal{"", -3, 3, 0.3}};
  return world;
}

TopView busy_view(const world::World& world) {
  TopView view{world};
  RobotTrack track;
  track.id = "r1";
  for (int i = 0; i < 500; ++i) track.path.push_back({0.005 * i, std::sin(0.02 * i), 0});
  track.now = track.path.back();
  Sketch sketch(Frame{});
  sketch.line(SketchRole::range, {0, 0, 0}, {1, 1, 0});
  sketch.point(SketchRole::hit, {1, 1, 0});
  sketch.line(SketchRole::range, {0, 0, 0}, {1, -1, 0});
  track.sketches = {sketch};
  track.touches = {{2, 2}};
  view.robots = {track};
  view.boxes = {Pose{-2, 1, 0}, Pose{-1, 1, 1}, Pose{0, 1, 0}, std::nullopt};
  view.path_period_s = 0.1;
  view.subtitles = {"success after 50 s"};
  return view;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("A picture is as wide as asked for, and by default as high as its content needs") {
  const Folder folder;
  const world::World world = world_of_everything();
  const TopView view = busy_view(world);
  save_top_view(view, folder / "a.png");
  CHECK(Bitmap(folder / "a.png").width() == 1000);
  const int height = Bitmap(folder / "a.png").height();
  CHECK(height > 950);
  CHECK(height < 1300);

  save_top_view(view, folder / "b.PNG", {2000, 0});
  CHECK(Bitmap(folder / "b.PNG").width() == 2000);
  CHECK(Bitmap(folder / "b.PNG").height() == Approx(2 * height).margin(2));

  save_top_view(view, folder / "c.png", {800, 600});
  CHECK(Bitmap(folder / "c.png").width() == 800);
  CHECK(Bitmap(folder / "c.png").height() == 600);
}

TEST_CASE("The same picture without a file: as text and pixel by pixel") {
  const Folder folder;
  const world::World world = world_of_everything();
  const TopView view = busy_view(world);
  save_top_view(view, folder / "a.svg", {800, 600});
  CHECK(top_view_svg(view, {800, 600}) == bytes_of(folder / "a.svg"));

  save_top_view(view, folder / "a.png", {800, 600});
  const Image image = top_view_image(view, {800, 600});
  CHECK((image.width == 800 && image.height == 600 && image.channels == 3));
  write_png(image, folder / "b.png");
  const Bitmap drawn(folder / "a.png"), written(folder / "b.png");
  int others = 0;
  for (int y = 0; y < 600; ++y) {
    for (int x = 0; x < 800; ++x) {
      const Vector2 at{x + 0.5, y + 0.5};
      const Pixel a = drawn.at(at), b = written.at(at);
      others += a.red != b.red || a.green != b.green || a.blue != b.blue;
    }
  }
  CHECK(others == 0);
}

TEST_CASE("A bare picture is the arena alone, at the picture's edges") {
  const Folder folder;
  const world::World world = world_of_everything();
  TopView view = busy_view(world);
  view.bare = true;
  save_top_view(view, folder / "bare.svg", {400, 0});
  CHECK(bytes_of(folder / "bare.svg").find("<text") == std::string::npos);
  save_top_view(view, folder / "bare.png", {400, 0});
  CHECK(Bitmap(folder / "bare.png").height() ==
        Approx(400 * world.arena.width / world.arena.length).margin(4));
  const PlaneMap map = top_view_map(view, {400, 0});
  CHECK(map.pixel({-world.arena.length / 2, 0}).x == Approx(0).margin(12));
  CHECK(map.pixel({world.arena.length / 2, 0}).x == Approx(400).margin(12));
}

TEST_CASE("The same view gives the same bytes, whatever was drawn in between") {
  const Folder folder;
  const world::World world = world_of_everything();
  for (const std::string suffix : {".png", ".svg"}) {
    save_top_view(busy_view(world), folder / ("a" + suffix));
    save_top_view({world}, folder / ("other" + suffix));
    save_top_view(busy_view(world), folder / ("b" + suffix));
    const bool same = bytes_of(folder / ("a" + suffix)) == bytes_of(folder / ("b" + suffix));
    CHECK(same);
    const bool other = bytes_of(folder / ("a" + suffix)) == bytes_of(folder / ("other" + suffix));
    CHECK_FALSE(other);
  }
}

TEST_CASE("An SVG picture is well-formed, and its text is text, to be searched and edited") {
  const Folder folder;
  const world::World world = world_of_everything();
  save_top_view(busy_view(world), folder / "a.svg");
  CHECK(std::system(("xmllint --noout --nonet '" + (folder / "a.svg").string() + "'").c_str()) ==
        0);
  const std::string svg = bytes_of(folder / "a.svg");
  for (const std::string text : {">x (m)</text>", ">y (m)</text>", ">r1</text>"}) {
    CAPTURE(text);
    CHECK((svg.find(text) != std::string::npos));
  }
  CHECK((svg.find("font-family=\"DejaVu Sans, ") != std::string::npos));
  CHECK((svg.find("<symbol") == std::string::npos));   // no outlines of letters
  CHECK((svg.find("0.012345") == std::string::npos));  // no marker of a text is left
  CHECK((svg.find("width=\"1000px\"") != std::string::npos));
}

TEST_CASE("Names of any content are drawn: empty, very long, not UTF-8, control characters") {
  const Folder folder;
  for (const std::string& name :
       {std::string(), std::string(100000, 'w'), std::string("\xff\xfe\xc0\x80 \xed\xa0\x80"),
        std::string("a\0b\n\t\x1b[31m", 10), std::string("\xe2\x82"),
        std::string("R\u00f6bi \u2192 \U0001F916")}) {
    world::World world = world_of_everything();
    world.name = name;
    world.robots[0].id = name;
    world.robots[0].team = name;
    world.teams[0].id = name;
    world.goals = {world::ReachGoal{name, 0, 0, 1, ""}};
    TopView view = busy_view(world);
    view.robots[0].id = name;
    view.title = name;
    view.subtitles = {name, name};
    for (const std::string file : {"a.png", "a.svg"}) {
      CHECK_NOTHROW(save_top_view(view, folder / file));
    }
    CHECK(Bitmap(folder / "a.png").width() == 1000);
    CHECK(std::system(("xmllint --noout '" + (folder / "a.svg").string() + "'").c_str()) == 0);
  }
}

TEST_CASE("A file type other than PNG and SVG is refused in a sentence, and nothing is written") {
  const Folder folder;
  const world::World world = world_of_everything();
  for (const std::string name : {"a.jpg", "a", "png", "a.png.txt"}) {
    CHECK_THROWS_AS(save_top_view({world}, folder / name), std::invalid_argument);
    CHECK_THROWS_AS(save_page({}, folder / name), std::invalid_argument);
  }
  CHECK(folder.files() == 0);
  CHECK(message_of([&] { save_top_view({world}, "map.jpg"); }) ==
        "The picture 'map.jpg' has the suffix '.jpg', but pictures are written as .png, .svg or "
        ".pdf: "
        "end its name with one.");
}

TEST_CASE("A size out of range is refused in a sentence") {
  const Folder folder;
  const world::World world = world_of_everything();
  for (const Size size : {Size{0, 0}, Size{-5, 0}, Size{100000, 0}, Size{1000, 10}}) {
    CHECK_THROWS_AS(save_top_view({world}, folder / "a.png", size), std::invalid_argument);
    CHECK_THROWS_AS(save_page({}, folder / "a.png", size), std::invalid_argument);
  }
  CHECK_THAT(message_of([&] {
               save_top_view({world}, folder / "a.png", {10, 0});
             }),
             Catch::Contains("10 x 0 pixels") && Catch::Contains("from 200 to 16000"));
}

TEST_CASE("A file that cannot be written is named with the reason, and nothing is left over") {
  const Folder folder;
  const world::World world = world_of_everything();
  CHECK_THROWS_AS(save_top_view({world}, folder / "no/such/folder.png"), std::runtime_error);
  CHECK_THAT(message_of([&] { save_top_view({world}, folder / "no/such/folder.png"); }),
             Catch::Contains("no/such/folder.png") && Catch::Contains("No such file or directory"));

  std::filesystem::create_directory(folder / "folder.png");
  CHECK_THROWS_AS(save_top_view({world}, folder / "folder.png"), std::runtime_error);
  CHECK(folder.files() == 1);
}

TEST_CASE("A picture replaces the one that was there") {
  const Folder folder;
  const world::World world = world_of_everything();
  std::ofstream(folder / "a.png") << "something else";
  save_top_view({world}, folder / "a.png");
  CHECK(Bitmap(folder / "a.png").width() == 1000);
  CHECK(folder.files() == 1);
}
