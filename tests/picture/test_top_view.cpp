#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "elsie/picture/hits.h"
#include "elsie/picture/top_view.h"
#include "elsie/shapes/obstacle_shapes.h"
#include "elsie/world/description.h"

#include "stage.h"

using namespace elsie;
using namespace elsie::picture;
using namespace elsie::picture::test;

namespace {

const auto kReddish = [](const Pixel& pixel) { return pixel.reddish(); };

}  // namespace

TEST_CASE("Lengths are to scale, x goes right and y up") {
  Stage scene;
  const PlaneMap map = top_view_map(scene.view);
  CHECK(map.scale_x == -map.scale_y);
  CHECK(map.scale_x > 80);  // 10 m fill 1000 pixels minus the margins
  const Vector2 corner = map.pixel({-5, 5});
  CHECK(corner.x > 50);
  CHECK(corner.y > 30);
  const Bitmap image = scene.image();
  CHECK(image.at(scene.place(-5.05, 0)).dark());  // walls
  CHECK(image.at(scene.place(5.05, 0)).dark());
  CHECK(image.at(scene.place(0, 5.05)).dark());
  CHECK(image.at(scene.place(0, -5.05)).dark());
  CHECK(image.at(scene.place(0.5, 0.5)).light());
}

TEST_CASE("Places keep their meaning at every size and shape of the arena") {
  for (const auto& [length, width] :
       {std::pair{10.0, 10.0}, {20.0, 2.0}, {3.0, 14.0}, {0.5, 0.5}, {300.0, 200.0}}) {
    for (const Size size : {Size{}, Size{400, 0}, Size{1920, 1080}, Size{300, 1200}}) {
      Stage scene;
      scene.world.arena.length = length;
      scene.world.arena.width = width;
      const double x = 0.3 * length, y = -0.3 * width;
      scene.add_robot("r", "red", {x, y, 0}).body.length = 0.02 * length;
      const Bitmap image = scene.image(size);
      INFO(length << " x " << width << " in " << size.width << " x " << size.height);
      CHECK(image.at(scene.place(x, y, size)).reddish());
      CHECK(image.count(scene.place(-x, -y, size), 3, kReddish) == 0);
    }
  }
}

TEST_CASE("A round robot has no corners") {
  const bool round = GENERATE(true, false);
  Stage scene;
  scene.world.arena.length = scene.world.arena.width = 2.0;
  world::RobotBody& body = scene.add_robot("", "red", {}).body;
  body.round = round;
  body.length = body.width = 0.3;
  body.axle = 0.2;
  const Bitmap image = scene.image();
  CHECK(image.at(scene.place(-0.1, 0.08)).reddish());
  CHECK(image.at(scene.place(-0.13, 0.13)).reddish() == !round);
}

TEST_CASE("A robot shows where it is and where it looks, however large the arena") {
  for (const double edge : {2.0, 10.0, 30.0, 100.0}) {
    Stage scene;
    scene.world.arena.length = scene.world.arena.width = edge;
    scene.add_robot("", "red", {0, 0, radians(180)});
    const Bitmap image = scene.image();
    const Vector2 middle = scene.place(0, 0);
    INFO(edge);
    CHECK(image.at(middle).reddish());
    CHECK(image.count(middle, 30, kReddish) > 60);
    if (edge < 10) continue;
    // Small ones have a ring with a tip that points ahead, here to the left.
    const auto tip = [&](double side) {
      return image.count({middle.x + side * 15.5, middle.y}, 2, kReddish);
    };
    CHECK(tip(-1) > 5);
    CHECK(tip(1) == 0);
  }
}

TEST_CASE(
    "A robot is where its track says, in its team's colour; one without a track at its start") {
  Stage scene;
  scene.add_robot("a", "blue", {-3, -3, 0});
  scene.add_robot("b", "red", {3, 3, 0});
  scene.view.robots = {{"a", {}, {1, -2, 1.0}, {}, {}}};
  const Bitmap image = scene.image();
  CHECK(image.at(scene.place(1, -2)).bluish());
  CHECK(image.at(scene.place(-3, -3)).light());
  CHECK(image.at(scene.place(3, 3)).reddish());
}

TEST_CASE("Robots of one team differ by their tints") {
  Stage scene;
  std::vector<Pixel> tints;
  for (int i = 0; i < 10; ++i) {
    scene.add_robot("", "red", {i - 4.5, 0, 0}).body.length = 0.5;
    scene.world.robots.back().id = std::string(1, static_cast<char>('a' + i));
    scene.world.robots.back().body.width = 0.5;
  }
  const Bitmap image = scene.image();
  for (int i = 0; i < 10; ++i) tints.push_back(image.at(scene.place(i - 4.6, 0)));
  for (std::size_t i = 0; i < tints.size(); ++i) {
    CHECK(tints[i].red > tints[i].blue);
    for (std::size_t j = 0; j < i; ++j) {
      const int apart = std::abs(tints[i].red - tints[j].red) +
                        std::abs(tints[i].green - tints[j].green) +
                        std::abs(tints[i].blue - tints[j].blue);
      INFO(i << " and " << j);
      CHECK(apart >= 20);
    }
  }
}

TEST_CASE("The path is drawn, paler where it is old") {
  Stage scene;
  scene.add_robot("r", "red", {0, 0, 0});
  RobotTrack track{"r", {}, {4, 0, 0}, {}, {}};
  for (int i = 0; i <= 800; ++i) track.path.push_back({-4 + 0.01 * i, 0, 0});
  scene.view.robots = {track};
  const Bitmap image = scene.image();
  const auto greenest = [&](double x) {
    int least = 255;
    for (int dy = -2; dy <= 2; ++dy) {
      const Vector2 at = scene.place(x, 0);
      least = std::min(least, image.at({at.x, at.y + dy}).green);
    }
    return least;
  };
  CHECK(greenest(-3.6) < 200);
  CHECK(greenest(3.6) < greenest(-3.6) - 40);
  CHECK(image.at(scene.place(0, 0.3)).light());
}

TEST_CASE("A part of the run is that part of the path of a robot that came later") {
  Stage scene;
  scene.add_robot("r", "red", {0, 0, 0});
  RobotTrack track{"r", {}, {4, 0, 0}, {}, {}};
  for (int i = 0; i <= 80; ++i) track.path.push_back({-4 + 0.1 * i, 0, 0});
  track.from_s = 20.0;
  scene.view.robots = {track};
  scene.view.path_period_s = 1.0;
  scene.view.paths = {.from_s = 60.0, .to_s = 80.0};
  const Bitmap image = scene.image();
  CHECK(image.at(scene.place(-1, 0)).light());
  CHECK_FALSE(image.at(scene.place(1.1, 0)).light());
  CHECK(image.at(scene.place(3, 0)).light());
  scene.view.paths = {.from_s = 0.0, .to_s = 19.0};  // before it was there
  CHECK(scene.image().at(scene.place(-1, 0)).light());
}

TEST_CASE("Between the poses where a robot was put elsewhere there is no line") {
  Stage scene;
  scene.add_robot("r", "red", {0, 0, 0});
  RobotTrack track{"r", {}, {4, 2, 0}, {}, {}};
  for (int i = 0; i <= 300; ++i) track.path.push_back({-4 + 0.01 * i, -2, 0});
  track.placed = {track.path.size()};
  for (int i = 0; i <= 300; ++i) track.path.push_back({1 + 0.01 * i, 2, 0});
  scene.view.robots = {track};
  const Bitmap image = scene.image();
  CHECK(image.at(scene.place(0, 0)).light());  // half-way
  CHECK_FALSE(image.at(scene.place(-1.5, -2)).light());
  CHECK_FALSE(image.at(scene.place(3, 2)).light());
  scene.view.robots[0].placed.clear();
  CHECK_FALSE(scene.image().at(scene.place(0, 0)).light());
}

namespace {

void add_beam(Sketch& sketch, const Vector3& from, const Vector3& to, bool hit) {
  sketch.line(SketchRole::range, from, to);
  if (hit) sketch.point(SketchRole::hit, to);
}

}  // namespace

TEST_CASE("A beam that hits ends in a dot; one that does not, does not") {
  Stage scene;
  scene.add_robot("r", "blue", {0, 0, 0});
  Sketch sketch(Frame{});
  add_beam(sketch, {}, {1.5, 0.5, 0}, true);
  add_beam(sketch, {}, {1.5, -1.5, 0}, false);
  const RobotTrack track{"r", {}, {}, {sketch}, {}};
  scene.view.robots = {track};
  const Bitmap image = scene.image();
  const auto ochre = [](const Pixel& p) { return p.red > p.blue + 90 && p.green > p.blue + 40; };
  CHECK(image.count(scene.place(1.5, 0.5), 2, ochre) >= 15);
  CHECK(image.count(scene.place(1.5, -1.5), 2, ochre) < 5);
  CHECK(image.count(scene.place(0.75, 0.25), 2, ochre) >= 3);
}

TEST_CASE("A field is of pale dots, a target a circle with a cross, a wish an arrow") {
  Stage scene;
  scene.add_robot("r", "blue", {0, 0, 0});
  Sketch sketch(Frame{});
  sketch.point(SketchRole::field, {-2, 2, 0});
  sketch.point(SketchRole::target, {2, 2, 0});
  sketch.arrow(SketchRole::wish, {1, -2, 0}, {3, -2, 0});
  sketch.line(SketchRole::belief, {-3, -2, 0}, {-1, -2, 0});
  sketch.text(SketchRole::target, {0, -3, 0}, "here");
  scene.view.sketches = {sketch};
  const Bitmap image = scene.image();
  const auto bluish = [](const Pixel& p) { return p.blue > p.red + 20; };
  const auto dark = [](const Pixel& p) { return !p.light(); };
  CHECK(image.count(scene.place(-2, 2), 1, bluish) == 9);
  const Vector2 target = scene.place(2, 2);
  CHECK(image.count({target.x + 7, target.y}, 1, bluish) >= 3);  // the cross
  CHECK(image.count({target.x, target.y + 5}, 1, bluish) >= 3);  // the circle
  const auto purple = [](const Pixel& p) { return p.red > p.green + 60 && p.blue > p.green + 60; };
  CHECK(image.count(scene.place(2, -2), 1, purple) >= 3);
  CHECK(image.count(scene.place(2.95, -2), 4, purple) >= 10);  // its head
  const int drawn = image.count(scene.place(-2, -2), 10, dark);
  CHECK(drawn > 5);  // the belief is dashed
  CHECK(drawn < 35);
  CHECK(image.count(scene.place(0, -3), 10, bluish) > 10);
}

TEST_CASE("Edges of a volume that coincide from above are drawn once") {
  Stage scene;
  scene.add_robot("r", "blue", {0, 0, 0});
  Sketch one(Frame{}), twice(Frame{});
  one.line(SketchRole::range, {0, 0, 0}, {2, 1, 0});
  twice.line(SketchRole::range, std::vector<Vector3>{{0, 0, 0}, {2, 1, 0}, {2, 1, 1}, {0, 0, 1}});
  scene.view.sketches = {one};
  scene.image();
  const std::string once_drawn = bytes_of(scene.folder / "view.png");
  scene.view.sketches = {twice};
  scene.image();
  CHECK(bytes_of(scene.folder / "view.png") == once_drawn);
}

TEST_CASE("Where a robot believes it is: a dotted path and a dashed outline") {
  Stage scene;
  scene.add_robot("r", "red", {0, 0, 0});
  RobotTrack track{"r", {}, {-3, 0, 0}, {}, {}};
  track.believed = Pose{3, 2, 0};
  for (int i = 0; i <= 60; ++i) track.believed_path.push_back({0.05 * i, 2, 0});
  scene.view.robots = {track};
  const Bitmap image = scene.image();
  const int dots = image.count(scene.place(1.5, 2), 10, kReddish);
  CHECK(dots > 5);
  CHECK(dots < 60);
  const Vector2 ghost = scene.place(3, 2);
  CHECK(image.count(ghost, 14, kReddish) > 15);
  CHECK(image.at({ghost.x - 3, ghost.y - 3}).light());  // it is an outline
}

TEST_CASE("A touch is a small red cross") {
  Stage scene;
  scene.add_robot("r", "blue", {0, 0, 0});
  RobotTrack track{"r", {}, {}, {}, {}};
  track.touches = {{2.5, 2.5}};
  scene.view.robots = {track};
  const Bitmap image = scene.image();
  const Vector2 at = scene.place(2.5, 2.5);
  CHECK(image.at(at).reddish());
  CHECK(image.count({at.x + 3, at.y + 3}, 1, kReddish) >= 2);
  CHECK(image.count({at.x, at.y - 7}, 1, kReddish) == 0);
}

TEST_CASE("A resource is filled in its team's colour, and hollow where it was collected") {
  Stage scene;
  scene.add_obstacle(world::ObstacleKind::resource, -2, 0, 0.4).team = "red";
  scene.add_obstacle(world::ObstacleKind::resource, 2, 0, 0.4).team = "red";
  scene.view.boxes = {Pose{-2, 0, 0}, std::nullopt};
  const Bitmap image = scene.image();
  CHECK(image.at(scene.place(-2 + 0.16, 0.16)).reddish());
  CHECK(image.at(scene.place(-2, 0)).light());  // its mark
  CHECK(image.at(scene.place(2 + 0.13, 0.13)).light());
  CHECK(image.count(scene.place(2.2, 0), 4, kReddish) > 3);  // its outline
}

TEST_CASE("A resource for all is green, as cameras see it") {
  Stage scene;
  scene.add_obstacle(world::ObstacleKind::resource, -2, 0, 0.4);
  CHECK(scene.image().at(scene.place(-2 + 0.16, 0.16)).greenish());
}

TEST_CASE("A box that was pushed is drawn where it is, with an outline where it started") {
  Stage scene;
  scene.add_obstacle(world::ObstacleKind::dynamic, -2.5, 0.5, 0.6);
  scene.view.boxes = {Pose{1.5, 0.5, 0}};
  const Bitmap image = scene.image();
  const auto ochre = [](const Pixel& p) { return p.red > p.blue + 30; };
  CHECK(image.count(scene.place(1.5, 0.5), 15, ochre) > 800);
  CHECK(image.count(scene.place(-2.5, 0.65), 8, ochre) == 0);
  CHECK(image.count(scene.place(-2.5, 0.8), 6, ochre) > 5);
}

TEST_CASE("Boxes show their kinds, and a fixed one its own colour") {
  Stage scene;
  scene.add_obstacle(world::ObstacleKind::fixed, -3.5, 0.5, 0.6);
  scene.add_obstacle(world::ObstacleKind::moving, -0.5, 0.5, 0.6);
  scene.add_obstacle(world::ObstacleKind::fixed, 2.5, 0.5, 0.6).colour = world::Colour{0, 160, 60};
  scene.view.boxes = {};
  const Bitmap image = scene.image();
  const Pixel fixed = image.at(scene.place(-3.5, 0.5)), moving = image.at(scene.place(-0.5, 0.5));
  CHECK(fixed.red > fixed.blue + 10);
  CHECK(moving.blue > moving.green + 15);
  CHECK(image.at(scene.place(2.5, 0.5)).greenish());
}

TEST_CASE("A goal relative to a robot is marked where the robot is now") {
  Stage scene;
  scene.add_robot("r", "red", {-4, -4, 0});
  scene.add_robot("s", "red", {-4, 4, 0});
  scene.view.robots = {{"r", {}, {1, 0, radians(90)}, {}, {}}};
  scene.world.goals = {world::ReachGoal{"s", -2, 1, 0.5, "r"}};
  const Bitmap image = scene.image();
  CHECK(image.count(scene.place(0, -1.5), 6, [](const Pixel& p) { return p.greenish(); }) > 8);
}

TEST_CASE("Goals and chargers are marked on the floor") {
  Stage scene;
  scene.world.goals = {world::ReachGoal{"r", 2.5, 2.5, 0.5, ""}};
  world::Charger charger;
  charger.team = "blue";
  charger.x = -2.5;
  charger.y = 2.5;
  charger.radius = 0.4;
  scene.world.chargers = {charger};
  const Bitmap image = scene.image();
  const auto greenish = [](const Pixel& p) { return p.greenish(); };
  CHECK(image.count(scene.place(2.5, 3.0), 6, greenish) > 8);
  CHECK(image.count(scene.place(-2.5, 2.5), 5, [](const Pixel& p) { return p.bluish(); }) > 8);
  CHECK(image.at(scene.place(-2.5, 3.0)).light());
}

TEST_CASE("Without walls, robots that drove out of the arena are still in the picture") {
  Stage scene;
  scene.world.arena.walls = false;
  scene.add_robot("r", "red", {0, 0, 0});
  scene.view.robots = {{"r", {{0, 0, 0}, {8, 0, 0}}, {8, 0, 0}, {}, {}}};
  CHECK(scene.image().at(scene.place(8, 0)).reddish());
  // A robot that is extremely far away does not shrink the rest.
  scene.view.robots[0].now = {1e9, 0, 0};
  CHECK(top_view_map(scene.view).scale_x > 25);
}

TEST_CASE("Positions that are not finite are left out") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  Stage scene;
  scene.add_robot("r", "red", {0, 0, 0});
  scene.add_robot("s", "red", {2, 2, 0});
  scene.add_obstacle(world::ObstacleKind::dynamic, 1, 1, 0.3);
  Sketch far(Frame{});  // a sketch refuses places that are not finite
  add_beam(far, {}, {1e200, -1e200, 0}, false);
  const RobotTrack track{"r",
                         {{0, 0, 0}, {nan, 0, 0}, {1, infinity, 0}, {1e300, 0, 0}, {1, 1, 0}},
                         {nan, nan, nan},
                         {far},
                         {{nan, nan}}};
  scene.view.robots = {track};
  scene.view.boxes = {Pose{nan, infinity, 0}};
  scene.view.path_period_s = 1.0;
  CHECK(scene.image().at(scene.place(2, 2)).reddish());
}

TEST_CASE("A world without anything in it is a picture too") {
  Stage scene;
  const Bitmap image = scene.image();
  CHECK(image.width() == 1000);
  CHECK(image.at(scene.place(0.5, -0.5)).light());
}

TEST_CASE("What a robot pulls is drawn where it is, or in line behind its robot") {
  Stage scene;
  scene.world.arena.length = scene.world.arena.width = 2.0;
  world::Robot& train = scene.add_robot("t", "red", {0.5, 0.5, radians(90)});
  train.segments.resize(2);
  // They are 0.12 m apart.
  const auto red = [&](double x, double y) {
    return scene.image().count(scene.place(x, y), 4, kReddish);
  };
  CHECK(red(0.5, 0.38) > 30);
  CHECK(red(0.5, 0.26) > 30);
  CHECK(red(0.5, 0.14) == 0);
  RobotTrack track;
  track.id = "t";
  track.now = {-0.5, -0.5, 0};
  track.segments = {{-0.6, -0.4, radians(-45)}};
  scene.view.robots = {track};
  CHECK(red(-0.6, -0.4) > 30);
  CHECK(red(-0.74, -0.5) > 30);  // nothing is known about it
  CHECK(red(-0.62, -0.5) == 0);
  CHECK(red(0.5, 0.38) == 0);
  track.segments = {{NAN, 0, 0}, {-0.8, 0.2, 0}, {0, 0, 0}};  // more than the robot has
  scene.view.robots = {track};
  CHECK(red(-0.8, 0.2) > 30);
  CHECK(red(0, 0) == 0);
}

TEST_CASE("Cylinders and prisms have their own outlines") {
  Stage scene;
  world::Obstacle& cylinder = scene.add_obstacle(world::ObstacleKind::fixed, -2.0, 0.0, 0.2);
  cylinder.shape = ObstacleShape::cylinder;
  cylinder.radius = 0.8;
  cylinder.colour = Colour{220, 30, 20};
  world::Obstacle& prism = scene.add_obstacle(world::ObstacleKind::fixed, 2.0, 0.0, 0.2);
  prism.shape = ObstacleShape::prism;
  prism.points = {{0, 0}, {1.5, 0}, {0, 1.5}};  // its middle is 0.5 m from both legs
  prism.heading_deg = 90.0;                     // the right angle is in the south-east
  prism.colour = Colour{220, 30, 20};
  const Bitmap image = scene.image();
  const auto is_red = [&](double x, double y) { return image.at(scene.place(x, y)).reddish(); };
  for (const double angle : {0.3, 1.0, 2.5, 4.0}) {
    CHECK(is_red(-2.0 + 0.75 * std::cos(angle), 0.75 * std::sin(angle)));
    CHECK_FALSE(is_red(-2.0 + 0.85 * std::cos(angle), 0.85 * std::sin(angle)));
  }
  CHECK(is_red(2.45, -0.45));
  CHECK(is_red(2.45, 0.85));
  CHECK(is_red(1.15, -0.45));
  CHECK_FALSE(is_red(2.55, 0.0));
  CHECK_FALSE(is_red(1.5, 0.5));
}

TEST_CASE("A crowd is dots on thin paths, with room between them") {
  Stage scene;
  constexpr int kSide = 21;  // 441 robots, a few more than are drawn in detail
  for (int i = 0; i < kSide * kSide; ++i) {
    const Pose pose{0.45 * (i % kSide - kSide / 2), 0.45 * (i / kSide - kSide / 2), 0.0};
    scene.add_robot("r" + std::to_string(i), "red", pose);
    RobotTrack track;
    track.id = scene.world.robots.back().id;
    track.path = {{pose.x - 0.1, pose.y, 0.0}, pose};
    track.now = pose;
    track.sketches.emplace_back(Frame{});
    add_beam(track.sketches[0], {pose.x, pose.y, 0}, {pose.x, pose.y + 0.3, 0}, true);
    scene.view.robots.push_back(track);
  }
  const Bitmap image = scene.image();
  for (const double x : {-4.5, 0.0, 3.6}) {
    CHECK(image.count(scene.place(x, 0.0), 1, [](const Pixel& pixel) { return !pixel.light(); }) ==
          9);                                                // the robot
    CHECK(image.at(scene.place(x + 0.225, 0.225)).light());  // no ring reaches so far
    CHECK(image.at(scene.place(x, 0.25)).light());           // and no beam
  }
}

TEST_CASE("A straight line of a range that ends at a hit is shown as one") {
  Sketch sketch(Frame{});
  sketch.line(SketchRole::range, {0, 0, 0}, {1, 0, 0});
  sketch.line(SketchRole::range, {0, 0, 0}, {0, 1, 0});
  sketch.line(SketchRole::range, std::vector<Vector3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}});
  sketch.line(SketchRole::target, {0, 0, 0}, {1, 0, 0});
  sketch.points(SketchRole::hit, std::vector<Vector3>{{3, 0, 0}, {1, 0, 0}});
  const Hits hits(sketch);
  std::vector<SketchRole> roles;
  for (const Sketch::Mark& mark : sketch.marks()) roles.push_back(hits.role_of(mark));
  CHECK(roles == std::vector{SketchRole::hit, SketchRole::range, SketchRole::range,
                             SketchRole::target, SketchRole::hit});
}

TEST_CASE("The arrow of a message ends at the outline of the robot that hears it") {
  Stage scene;
  scene.add_robot("r", "blue", {2, 0, 0});
  Sketch sketch(Frame{});
  sketch.arrow(SketchRole::message, {-3, 0, 0}, {2, 0, 0});
  RobotTrack track{"r", {}, {2, 0, 0}, {sketch}, {}};
  scene.view.robots = {track};
  const Bitmap image = scene.image();
  const auto teal = [](const Pixel& p) { return p.green > p.red + 60 && p.blue > p.red + 60; };
  // The widest column of the head is several pixels high, the line is not.
  const Vector2 middle = scene.place(2, 0);
  int highest = 0;
  for (int x = 8; x < 60; ++x) {
    int high = 0;
    for (int y = -6; y <= 6; ++y) high += teal(image.at({middle.x - x, middle.y + y})) ? 1 : 0;
    highest = std::max(highest, high);
  }
  CHECK(highest >= 4);
}
