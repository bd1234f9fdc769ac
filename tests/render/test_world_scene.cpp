// Worlds as cameras see them.
#include <numbers>

#include <catch2/catch.hpp>

#include "elsie/render/world_scene.h"
#include "elsie/shapes/obstacle_shapes.h"
#include "elsie/world/colours.h"
#include "elsie/world/parts.h"

#include "darkroom.h"

using namespace elsie;
using namespace elsie::render;
using namespace elsie::render::test;

namespace {

world::Obstacle box_at(double x, double y, world::ObstacleKind kind = world::ObstacleKind::fixed) {
  world::Obstacle box;
  box.kind = kind;
  box.x = x;
  box.y = y;
  return box;
}

world::World empty_world() {
  world::World world;
  world.arena.length = world.arena.width = 6.0;
  world.teams = {{"red", world::kRedTeam}, {"green", Colour{20, 180, 40}}};
  return world;
}

Image picture_of(const world::World& world, const View& view, Viewer viewer = Viewer::camera) {
  return take(WorldScene(world, viewer).scene(), view);
}

bool is_grey(const Colour& colour) {
  return colour.red == colour.green && colour.green == colour.blue;
}

int coloured_pixels(const Image& picture) {
  int count = 0;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      count += !is_grey(colour_at(picture, column, row));
    }
  }
  return count;
}

}  // namespace

TEST_CASE("Floor, sky, walls, obstacles and robots of any team have no hue") {
  world::World world = empty_world();
  for (const auto kind :
       {world::ObstacleKind::fixed, world::ObstacleKind::dynamic, world::ObstacleKind::moving}) {
    world.obstacles.push_back(
        box_at(1.0, -0.4 + 0.4 * static_cast<double>(world.obstacles.size()), kind));
  }
  for (const char* team : {"red", "green"}) {
    world::Robot& robot = world.robots.emplace_back();
    robot.team = team;
    robot.x = 0.5;
    robot.y = robot.team == "red" ? 0.1 : -0.1;
  }
  const View view = view_from({-0.5, 0, 0.4}, 0, -15, {200, 200, radians(80)});
  const Image picture = picture_of(world, view);
  CHECK(coloured_pixels(picture) == 0);
  // All are darker than white in the shade.
  CHECK(*std::max_element(picture.bytes.begin(), picture.bytes.end()) < 255 * kDarkestShade);
  // Robots stand out from the floor, and to people they have their team's colour.
  CHECK(differing_pixels(picture, picture_of(empty_world(), view)) > 500);
  const Image for_people = picture_of(world, view, Viewer::person);
  CHECK(find(for_people, world::kRedTeam).area > 50);
  CHECK(find(for_people, {20, 180, 40}).area > 50);
}

TEST_CASE("A resource has its own colour, its team's, or the one of resources for all") {
  const auto area = [](const world::Obstacle& box, const Colour& colour) {
    world::World world = empty_world();
    world.obstacles = {box};
    return find(picture_of(world, view_from({0, 0, 0.1})), colour).area;
  };
  world::Obstacle resource = box_at(1.0, 0.0, world::ObstacleKind::resource);
  CHECK(area(resource, world::kResourceOfNoTeam) > 100);
  resource.team = "green";
  CHECK(area(resource, {20, 180, 40}) > 100);
  resource.team = "blue";  // not listed in the world
  CHECK(area(resource, world::kBlueTeam) > 100);
  resource.colour = Colour{200, 0, 200};
  CHECK(area(resource, {200, 0, 200}) > 100);
  world::Obstacle obstacle = box_at(1.0, 0.0);
  obstacle.colour = Colour{250, 120, 0};
  CHECK(area(obstacle, {250, 120, 0}) > 100);
}

TEST_CASE("A charger is a yellow disc of its radius, or a box where range sensors are to see it") {
  world::World world = empty_world();
  world::Charger& charger = world.chargers.emplace_back();
  charger.x = 0.5;
  charger.radius = 0.25;
  const View above = view_from({0.5, 0, 2}, 0, -90);
  const Colour yellow = colour_at(picture_of(world, above), 50, 50);
  CHECK(yellow.red > 200);
  CHECK(yellow.green > 150);
  CHECK(yellow.blue < 50);
  const Patch seen = find(picture_of(world, above), yellow);
  const double radius = 50.0 / std::tan(radians(15)) * 0.25 / 2.0;
  CHECK(seen.right - seen.left + 1 == Approx(2 * radius).margin(2));
  CHECK(seen.column == Approx(50).margin(1));

  const View level = view_from({-0.5, 0, 0.05});
  CHECK(find(picture_of(world, level), yellow).area > 0);
  world.chargers[0].seen_by_range_sensors = true;
  const Patch box = find(picture_of(world, level), yellow);
  CHECK(box.bottom - box.top + 1 == Approx(50.0 / std::tan(radians(15)) * 0.1 / 0.95).margin(2));
}

TEST_CASE("Walls stand around the arena, or do not") {
  world::World world = empty_world();
  const auto wall_row = [&world](double yaw) {
    const Image picture = picture_of(world, view_from({0, 0, 0.1}, yaw));
    return colour_at(picture, 50, 48);  // slightly above the horizon
  };
  const Scene scene = WorldScene(world).scene();
  for (const double yaw : {0.0, 45.0, 90.0, 180.0, 270.0}) {
    CHECK_FALSE(wall_row(yaw) == scene.sky);
  }
  world.arena.walls = false;
  CHECK(wall_row(0.0) == scene.sky);
}

TEST_CASE("Robots and boxes are where they are put; a removed box is not seen") {
  world::World world = empty_world();
  world.obstacles = {box_at(1.0, 0.0, world::ObstacleKind::resource)};
  world.obstacles[0].team = "red";
  world.robots.resize(1);
  WorldScene scene(world);
  const View view = view_from({0, 0, 0.1});
  CHECK(find(take(scene.scene(), view), world::kRedTeam).column == Approx(50).margin(1));
  scene.place_box(0, Frame::turned({1.0, 0.2, 0.3}, 0.4, 0.0));
  const Patch moved = find(take(scene.scene(), view), world::kRedTeam);
  CHECK(moved.area > 0);
  CHECK(moved.column < 30);
  CHECK(moved.row < 20);
  scene.place_box(0, std::nullopt);
  CHECK(find(take(scene.scene(), view), world::kRedTeam).area == 0);
  scene.place_box(0, Frame{});
  CHECK(scene.scene().boxes.back().carrier == 0);
  scene.place_box(0, Frame::turned({1.0, 0.0, 0.0}, 0.0, 0.0));
  CHECK(find(take(scene.scene(), view), world::kRedTeam).area > 0);
  CHECK_THROWS_AS(scene.place_robot(1, {}), std::out_of_range);
  CHECK_THROWS_AS(scene.place_box(7, std::nullopt), std::out_of_range);
}

TEST_CASE("A robot is a chassis on two dark wheels, tilted as its frame is") {
  world::World world = empty_world();
  world.robots.resize(1);
  world.robots[0].body.wheel_radius = 0.05;
  world.robots[0].body.clearance = 0.03;
  WorldScene scene(world);
  const auto side_view = [&] {
    return take(scene.scene(), view_from({0, 0.5, 0.05}, -90, 0, {200, 200, radians(40)}));
  };
  const auto dark = [](const Image& picture) { return find(picture, {25, 25, 25}); };
  const auto is_dark = [](const Image& picture, int column, int row) {
    return colour_at(picture, column, row).red < 30;
  };
  scene.place_robot(0, {});
  const Image level = side_view();
  CHECK(is_dark(level, 100, 100));       // the left wheel, seen from the left
  CHECK_FALSE(is_dark(level, 100, 60));  // the chassis above it
  CHECK(dark(level).area > 0);
  // Seen from the left, forward is to the left: a robot on its nose shows its top there.
  const Frame on_its_nose{{0, 0, 0.05}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
  scene.place_robot(0, on_its_nose);
  const Image tilted = side_view();
  const Scene& drawn = scene.scene();
  CHECK(drawn.boxes.back().frame.up == on_its_nose.up);
  CHECK(drawn.cylinders[0].frame.origin.x == Approx(0.05));
  CHECK(differing_pixels(level, tilted) > 300);
}

TEST_CASE("A round robot is as wide from every side, and round from above") {
  world::World world = empty_world();
  world.robots.resize(1);
  world::RobotBody& body = world.robots[0].body;
  body.round = true;
  body.length = body.width = 0.1;
  body.axle = 0.08;
  WorldScene scene(world, Viewer::person);
  const auto width_from = [&](double degrees_) {
    const Vector3 at{-std::cos(radians(degrees_)), -std::sin(radians(degrees_)), 0.06};
    const Patch seen = find(take(scene.scene(), view_from(at, degrees_)), world::kRedTeam);
    return seen.right - seen.left + 1;
  };
  const double scale = 50.0 / std::tan(radians(15));  // px for a unit of slope
  const double expected = scale * 0.1;                // at a distance of 1 m
  for (const double degrees_ : {0.0, 20.0, 45.0, 90.0, 200.0}) {
    CAPTURE(degrees_);
    CHECK(width_from(degrees_) == Approx(expected).margin(2));
  }
  const Patch top = find(take(scene.scene(), view_from({0, 0, 1.09}, 0, -90)), world::kRedTeam);
  CHECK(top.area == Approx(0.25 * std::numbers::pi * expected * expected).epsilon(0.08));
}

TEST_CASE("A robot's segments are drawn behind it, and are not in its own pictures") {
  world::World world = empty_world();
  world.robots.resize(1);
  world.robots[0].heading_deg = 90;
  world.robots[0].segments.resize(2);
  const auto couplings =
      world::couplings(world::plan_of(world.robots[0].body, {}), world.robots[0].segments);
  WorldScene scene(world, Viewer::person);
  const auto& boxes = scene.scene().boxes;
  REQUIRE(boxes.size() == 4 + 3);
  CHECK(scene.scene().cylinders.size() == 6);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(boxes[5 + i].frame.origin.x == Approx(0).margin(1e-12));
    CHECK(boxes[5 + i].frame.origin.y == Approx(-couplings[i].place));
    CHECK(boxes[5 + i].frame.origin.z == Approx(world.robots[0].segments[i].clearance));
    CHECK(boxes[5 + i].carrier == 0);
  }
  View back = view_from({0, -0.04, 0.09}, -90);
  CHECK(find(take(scene.scene(), back), world::kRedTeam).area > 500);
  back.carrier = 0;
  CHECK(find(take(scene.scene(), back), world::kRedTeam).area == 0);
  scene.place_segment(0, 1, Frame::turned({1.0, 1.0, 0.0}, 0.3, 0.0));
  CHECK(boxes[6].frame.origin.x == Approx(1.0));
  CHECK_THROWS_AS(scene.place_segment(0, 2, {}), std::out_of_range);
}

namespace {

/// A cylinder, or a triangle with its slope towards the west, 2 m ahead of the camera.
world::World with_form(ObstacleShape shape) {
  world::World world = empty_world();
  world::Obstacle& box =
      world.obstacles.emplace_back(box_at(2.0, 0.0, world::ObstacleKind::dynamic));
  box.shape = shape;
  box.radius = 0.2;
  box.points = {{0, 0.3}, {-0.6, 0}, {0, -0.3}};  // its middle is 0.2 m west of the east side
  box.height = 0.3;
  box.colour = kRed;
  return world;
}

constexpr Camera kWide{400, 300, radians(30.0)};

}  // namespace

TEST_CASE("A camera sees a cylinder as wide as its tangents") {
  const Patch seen = find(
      picture_of(with_form(ObstacleShape::cylinder), view_from({0, 0, 0.15}, 0, 0, kWide)), kRed);
  const double half = std::tan(std::asin(0.2 / 2.0));  // for one unit along the axis
  const double pixels = 200.0 / std::tan(radians(15.0));
  CHECK(seen.right - seen.left + 1 == Approx(2.0 * half * pixels).epsilon(0.015));  // 20 sides
  CHECK(seen.column == Approx(200.0).margin(0.6));
  // Its nearest line is 1.8 m away.
  CHECK(seen.bottom - seen.top + 1 == Approx(0.3 / 1.8 * pixels).epsilon(0.015));
}

TEST_CASE("A camera sees a prism between its outermost corners, and each side in its own light") {
  const world::World world = with_form(ObstacleShape::prism);
  const Image picture = picture_of(world, view_from({0, 0, 0.15}, 0, 0, kWide));
  const Patch seen = find(picture, kRed);
  const double pixels = 200.0 / std::tan(radians(15.0));
  CHECK(seen.right - seen.left + 1 == Approx(0.6 / 2.2 * pixels).margin(1.5));
  CHECK(seen.column == Approx(200.0).margin(1.0));
  CHECK(seen.bottom - seen.top + 1 == Approx(0.3 / 1.6 * pixels).margin(1.5));
  const Colour left = colour_at(picture, 190, 150), right = colour_at(picture, 210, 150);
  CHECK(left.red > right.red);  // the light comes from the north
  // The pixels of two trapezia, from 1.6 to 2.2 m, within a row at each end of a column.
  const double area = 0.6 / 2.2 * pixels * 0.5 * (0.3 / 1.6 + 0.3 / 2.2) * pixels;
  CHECK(seen.area == Approx(area).epsilon(0.02));
}

TEST_CASE("Cylinders and prisms move, and leave, as boxes do") {
  for (const auto shape : {ObstacleShape::cylinder, ObstacleShape::prism}) {
    WorldScene scene(with_form(shape));
    const View view = view_from({0, 0, 0.15}, 0, 0, kWide);
    const Patch before = find(take(scene.scene(), view), kRed);
    scene.place_box(0, Frame{.origin = {2.0, 0.3, 0.0}});
    const Patch after = find(take(scene.scene(), view), kRed);
    CHECK(after.column < before.column - 50.0);
    CHECK(after.bottom == Approx(before.bottom).margin(3));
    // From above, it is where it was put.
    const Patch above = find(take(scene.scene(), view_from({2.0, 0.3, 3.0}, 0, -90)), kRed);
    CHECK(above.column == Approx(50.0).margin(2.0));
    scene.place_box(0, std::nullopt);
    CHECK(find(take(scene.scene(), view), kRed).area == 0);
  }
}

TEST_CASE("A camera sees the floor's colour, its patches and lamps") {
  world::World world = empty_world();
  world.floor.colour = Colour{200, 160, 90};
  world::Patch& patch = world.patches.emplace_back();
  patch.shape = world::PatchShape::line;
  patch.points = {{0.5, -0.2}, {0.5, 0.2}};
  patch.line_width = 0.1;
  patch.colour = {200, 30, 160};
  const View view = view_from({-0.2, 0, 0.4}, 0, -30, {200, 200, radians(80)});
  const Image picture = picture_of(world, view);
  CHECK(find(picture, *world.floor.colour).area > 5000);
  CHECK(find(picture, patch.colour).area > 200);
  world.lamps.push_back({.id = "sun", .x = 1.0, .z = 0.4, .colour = {30, 60, 220}});
  CHECK(find(picture_of(world, view), {30, 60, 220}).area > 5);
}

TEST_CASE("A robot with a colour has it, and lights are seen where they shine") {
  world::World world = empty_world();
  world::Robot robot;
  robot.id = "r1";
  robot.x = 1.0;
  world.robots.push_back(robot);
  const View view{Frame::turned({-1.0, 0.0, 0.1}, 0.0, 0.0), {200, 200, radians(60.0)}};
  CHECK(coloured_pixels(picture_of(world, view)) == 0);
  WorldScene scene(world);
  scene.show_lights({{{0, {1.0, 0.0, 0.15}, Colour{255, 0, 0}}}});
  CHECK(coloured_pixels(take(scene.scene(), view)) > 0);
  scene.show_lights({});
  CHECK(coloured_pixels(take(scene.scene(), view)) == 0);
  world.robots[0].colour = Colour{20, 180, 40};
  CHECK(coloured_pixels(picture_of(world, view)) > 20);
}
