// Labels of the top view, read from the text of the SVG.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/picture/top_view.h"
#include "elsie/world/description.h"

#include "support.h"

using namespace elsie;
using namespace elsie::picture;
using namespace elsie::picture::test;

namespace {

struct Label {
  double x = 0.0, y = 0.0, size = 0.0;
  std::string text;
};

std::vector<Label> labels_of(const TopView& view) {
  const Folder folder;
  save_top_view(view, folder / "view.svg");
  const std::string svg = bytes_of(folder / "view.svg");
  static const std::regex kText(
      "<text x=\"([^\"]*)\" y=\"([^\"]*)\"[^>]*font-size=\"([^\"]*)\"[^>]*>([^<]*)</text>");
  std::vector<Label> labels;
  for (std::sregex_iterator it(svg.begin(), svg.end(), kText), end; it != end; ++it) {
    labels.push_back({std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), (*it)[4]});
  }
  return labels;
}

bool has(const std::vector<Label>& labels, const std::string& text) {
  return std::any_of(labels.begin(), labels.end(),
                     [&](const Label& label) { return label.text == text; });
}

// Letters of this font are at least half as wide as high.
bool overlap(const Label& a, const Label& b) {
  const auto width = [](const Label& label) {
    return 0.5 * label.size * static_cast<double>(label.text.size());
  };
  return a.x < b.x + width(b) && b.x < a.x + width(a) && std::abs(a.y - b.y) < 0.8 * a.size;
}

world::World world_of(std::size_t robots, double radius_m) {
  world::World world;
  world.teams = {{"red", Colour{208, 49, 30}}};
  for (std::size_t i = 0; i < robots; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(robots);
    world::Robot robot;
    robot.id = "robot" + std::to_string(i + 1);
    robot.team = "red";
    robot.x = radius_m * std::cos(angle);
    robot.y = radius_m * std::sin(angle);
    world.robots.push_back(robot);
  }
  return world;
}

TopView with_ways(const world::World& world) {
  TopView view{world};
  view.path_period_s = 0.1;
  for (const world::Robot& robot : world.robots) {
    RobotTrack track;
    track.id = robot.id;
    for (int i = 0; i <= 600; ++i) {
      track.path.push_back({robot.x + 0.005 * i, robot.y + 0.5 * std::sin(0.05 * i), 0.0});
    }
    track.now = track.path.back();
    track.touches = {{track.path[100].x, track.path[100].y}};
    view.robots.push_back(track);
  }
  return view;
}

bool tells(const std::vector<Label>& labels, const std::string& start) {
  return std::any_of(labels.begin(), labels.end(),
                     [&](const Label& label) { return label.text.starts_with(start); });
}

}  // namespace

TEST_CASE("Names of robots that stand close together do not lie on each other") {
  for (const double radius_m : {0.3, 0.6, 1.2}) {
    CAPTURE(radius_m);
    const world::World world = world_of(10, radius_m);
    const std::vector<Label> all = labels_of({world});
    std::vector<Label> names;
    for (const Label& label : all) {
      if (label.text.starts_with("robot") && !label.text.starts_with("robot,")) {
        names.push_back(label);
      }
    }
    CHECK(names.size() == 10);
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        CAPTURE(names[i].text, names[k].text);
        CHECK_FALSE(overlap(names[i], names[k]));
      }
    }
  }
}

TEST_CASE("Where there is no room for all names, the picture says how many are left out") {
  const world::World world = world_of(100, 0.1);
  const std::vector<Label> labels = labels_of({world});
  std::size_t names = 0;
  for (const Label& label : labels) {
    names += label.text.starts_with("robot") && !label.text.starts_with("robot,") ? 1 : 0;
  }
  CHECK(names > 10);
  CHECK(names < 100);
  CHECK(has(labels, std::to_string(100 - names) + " labels are left out for want of room"));
}

TEST_CASE("Goals in one place have one label") {
  world::World world = world_of(4, 2.0);
  for (const world::Robot& robot : world.robots) {
    world.goals.emplace_back(world::ReachGoal{robot.id, 3, 3, 0.3, ""});
  }
  world.goals.emplace_back(world::ReachGoal{"robot1", -3, 3, 0.3, ""});
  const std::vector<Label> labels = labels_of({world});
  CHECK(has(labels, "goal of robot1, robot2 and 2 more"));
  CHECK(has(labels, "goal of robot1"));
  CHECK_FALSE(has(labels, "goal of robot3"));
}

TEST_CASE("The legend has keys of what is in the picture only") {
  world::World world = world_of(1, 0.0);
  world::Obstacle box;
  box.kind = world::ObstacleKind::dynamic;
  box.x = 2.0;
  world.obstacles = {box};
  TopView view{world};
  CHECK(has(labels_of(view), "dynamic box"));
  CHECK_FALSE(tells(labels_of(view), "path"));
  CHECK_FALSE(tells(labels_of(view), "static box"));
  view.boxes = {Pose{3.0, 0.0, 0.0}};
  CHECK(has(labels_of(view), "dynamic box, dashed where it started"));
  world.obstacles[0].kind = world::ObstacleKind::moving;
  CHECK(has(labels_of(view), "moving box"));
  world.obstacles[0].waypoints = {{2, 2}};
  CHECK(has(labels_of(view), "moving box and its way"));
}

TEST_CASE("Ways can be those of some robots, of a part of the time, and fade") {
  const world::World world = world_of(3, 2.0);
  TopView view = with_ways(world);
  const Folder folder;
  const auto size = [&] {
    save_top_view(view, folder / "view.svg");
    return bytes_of(folder / "view.svg").size();
  };
  const std::size_t whole = size();
  CHECK(tells(labels_of(view), "path, from its start"));
  CHECK(tells(labels_of(view), "touch"));
  SECTION("of one robot: the others stand where they are") {
    view.paths.robots = {"robot2"};
    CHECK(10 * size() < 7 * whole);
    CHECK(has(labels_of(view), "robot3"));
    view.paths.robots = {"nobody"};
    CHECK_FALSE(tells(labels_of(view), "path"));
    CHECK_FALSE(tells(labels_of(view), "touch"));
  }
  SECTION("of a window of time") {
    view.paths.from_s = 30.0;
    view.paths.to_s = 40.0;
    CHECK(tells(labels_of(view), "path from 30 s to 40 s"));
    CHECK_FALSE(tells(labels_of(view), "touch"));  // the touches were at 10 s
    CHECK(10 * size() < 7 * whole);
    view.paths.from_s = 5.0;
    CHECK(tells(labels_of(view), "touch"));
    view.paths.from_s = 1000.0;  // after the end of the run
    view.paths.to_s = 2000.0;
    CHECK_NOTHROW(size());
  }
  SECTION("fading") {
    view.paths.fade_s = 10.0;
    CHECK(tells(labels_of(view), "path of the last 10 s"));
    CHECK(10 * size() < 7 * whole);
  }
}

TEST_CASE("Nests have their names, and the legend says whose they are, and what was delivered") {
  world::World world = world_of(1, 1.0);
  world.nests.push_back({.id = "home", .team = "red", .x = 2.0});
  world.nests.push_back({.id = "away", .team = "", .x = -2.0});
  world.obstacles.emplace_back();
  world.obstacles[0].kind = world::ObstacleKind::resource;
  TopView view{world};
  CHECK_FALSE(has(labels_of(view), "delivered"));
  view.boxes = {std::nullopt};
  CHECK(has(labels_of(view), "collected"));
  world.obstacles[0].to_nest = true;
  const std::vector<Label> labels = labels_of(view);
  for (const char* text : {"home", "away", "nest, team red", "nest", "delivered"}) {
    INFO(text);
    CHECK(has(labels, text));
  }
}

TEST_CASE("The legend tells messages from hits, and a lit lamp from a lamp") {
  world::World world = world_of(2, 1.0);
  TopView view{world};
  Sketch heard(Frame{});
  heard.arrow(SketchRole::message, {-1, 0, 0}, {1, 0, 0});
  for (const world::Robot& robot : world.robots) {
    RobotTrack track;
    track.id = robot.id;
    track.now = {robot.x, robot.y, 0.0};
    view.robots.push_back(track);
  }
  CHECK_FALSE(has(labels_of(view), "message heard"));
  CHECK_FALSE(has(labels_of(view), "lit lamp of a robot"));
  view.robots[0].sketches = {heard};
  view.robots[0].lights = {{{1.0, 0.0}, {255, 160, 0}}};
  CHECK(has(labels_of(view), "message heard"));
  CHECK(has(labels_of(view), "lit lamp of a robot"));
  CHECK_FALSE(has(labels_of(view), "hit of a sensor"));
  CHECK_FALSE(has(labels_of(view), "lamp"));
}
