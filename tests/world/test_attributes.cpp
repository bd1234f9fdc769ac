// The attributes of a world in memory, by their paths.
#include <functional>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/world/attributes.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using world::Attributes;
using world::AttributeTarget;

namespace {

const char* const kWorld = R"(
  <arena length="8"/>
  <obstacles><static_box x="1"/><moving_box id="cart" x="2"><waypoint x="3" y="0"/></moving_box>
  </obstacles>
  <robots>
    <robot id="r1">
      <sensors><beam id="left"/><beam id="right"/></sensors>
      <behaviors><avoid/><roam mood="bold"/></behaviors>
      <coordinator><sum/></coordinator>
    </robot>
    <robot id="r2" x="1" y="1">
      <sensors><beam/></sensors>
      <coordinator><sum/></coordinator>
    </robot>
  </robots>
  <goals><endure time="5"/></goals>)";

struct Found {
  Found() : world(read(kWorld)), attributes(world, host(), {kFolder + "data"}) {}

  std::vector<std::string> paths(const std::string& path) const {
    std::vector<std::string> paths;
    for (const AttributeTarget& place : attributes.find(path)) {
      paths.push_back(place.path);
    }
    return paths;
  }
  AttributeTarget one(const std::string& path) const { return attributes.find(path).at(0); }
  std::string why_not(const std::string& path, const std::string& value) const {
    try {
      attributes.read(one(path), value);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  }

  world::World world;
  Attributes attributes;
};

}  // namespace

TEST_CASE("A path leads to the attributes that an override of the file would change") {
  const Found found;
  using Paths = std::vector<std::string>;
  CHECK(found.paths("@name") == Paths{"@name"});
  CHECK(found.paths("arena/@length") == Paths{"arena/@length"});
  CHECK(found.paths("physics/@step") == Paths{"physics/@step"});  // though the file has none
  CHECK(found.paths("robot[2]/@x") == Paths{"robot[r2]/@x"});
  CHECK(found.paths("robot[*]/@x") == Paths{"robot[r1]/@x", "robot[r2]/@x"});
  CHECK(found.paths("robots/robot[r1]/body/@mass") == Paths{"robot[r1]/body/@mass"});
  CHECK(found.paths("robot[r1]/beam[2]/@yaw_deg") == Paths{"robot[r1]/sensor[right]/@yaw_deg"});
  CHECK(found.paths("robot[r1]/behaviors/roam/@speed") == Paths{"robot[r1]/behavior[roam]/@speed"});
  CHECK(found.paths("coordinator/@weighted") ==
        Paths{"robot[r1]/coordinator/@weighted", "robot[r2]/coordinator/@weighted"});
  CHECK(found.paths("goal[1]/@time") == Paths{"goal[1]/@time"});
  CHECK(found.paths("obstacle[cart]/waypoint/@x") == Paths{"obstacle[cart]/waypoint[1]/@x"});
  CHECK(found.paths("goals/endure/@time") == Paths{"goal[1]/@time"});
  CHECK(found.paths("robots/robot[*]/@x") == Paths{"robot[r1]/@x", "robot[r2]/@x"});
  CHECK(found.paths("obstacles/moving_box/@x") == Paths{"obstacle[cart]/@x"});
  // What it says in full leads there again.
  for (const char* path : {"obstacle[2]/waypoint/@x", "robot[*]/sensor[*]/@max_range"}) {
    for (const std::string& full : found.paths(path)) {
      CHECK(found.paths(full) == Paths{full});
    }
  }
}

TEST_CASE("An attribute says whose it is, what it takes, and whether it may change in a run") {
  const Found found;
  const AttributeTarget speed = found.one("robot[r1]/roam/@speed");
  CHECK(speed.element == "roam");
  CHECK(speed.robot == &found.world.robots[0]);
  CHECK(speed.use == &found.world.robots[0].behaviors[1]);
  CHECK(speed.field.type == ParameterType::real);
  CHECK(speed.field.is_live());
  const AttributeTarget priority = found.one("robot[r1]/roam/@priority");
  CHECK(priority.use == speed.use);
  CHECK(priority.field.is_live());
  const AttributeTarget battery = found.one("robot[r2]/@battery");
  CHECK(battery.robot == &found.world.robots[1]);
  CHECK(battery.use == nullptr);
  CHECK_FALSE(battery.field.is_live());
  CHECK(battery.live == std::vector<std::string>{"x", "y", "z", "heading_deg", "max_speed",
                                                 "coverage", "leader", "energy"});
  CHECK(found.one("arena/@length").robot == nullptr);
}

TEST_CASE("An attribute is set in the world like in its file") {
  world::World world = Found().world;
  const world::Attributes attributes(world, host());
  for (const auto& [path, value] : std::vector<std::pair<std::string, std::string>>{
           {"robot[r2]/@x", "1.5"},
           {"robot[r1]/sensor[right]/@energy_cost", "2"},
           {"robot[r1]/behavior[roam]/@priority", "3"},
           {"robot[r1]/behavior[roam]/@speed", "4"}}) {
    for (world::AttributeTarget& place : attributes.find(path)) {
      // No other world shares it.
      REQUIRE_FALSE(world.robots.is_shared(place.robot_index));
      attributes.set(place, value);
    }
  }
  const world::Robot& r1 = world.robots[0];
  CHECK(world.robots[1].x == 1.5);
  CHECK(r1.sensors[1].energy_cost == 2);
  CHECK(r1.behaviors[1].priority == 3);
  CHECK(r1.behaviors[1].parameters.at("speed") == ParameterValue(4.0));
}

TEST_CASE("Only attributes of robots and what is on them are live, and places of loose boxes") {
  int live = 0;
  const std::function<void(const world::ElementSpec&, bool)> look = [&](const auto& spec,
                                                                        bool on_robot) {
    on_robot = on_robot || spec.name == "robot";
    for (const world::AttributeSpec& attribute : spec.attributes) {
      CAPTURE(spec.name, attribute.name);
      const bool is_loose = spec.name == "resource" || spec.name.starts_with("dynamic_");
      const bool is_place =
          attribute.name == "x" || attribute.name == "y" || attribute.name == "heading_deg";
      CHECK((on_robot || (is_loose && is_place) || !attribute.is_live()));
      live += attribute.is_live();
    }
    for (const world::ElementSpec& child : spec.children) {
      if (child.name != "layouts") look(child, on_robot);  // what runs has none
    }
  };
  look(world::vocabulary(), false);
  CHECK(live == 23);
}

TEST_CASE("A path that leads nowhere is reported as in an override") {
  const Found found;
  const auto wrong = [&](const std::string& path) -> std::string {
    try {
      found.attributes.find(path);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  for (const char* path : {"robot[r3]/@x", "robot/@x", "robbot[r1]/@x", "robot[r1]/behavior[3]/@x",
                           "robot[r1]/@", "robot[r1]x", "robot[]/@x", "segment[1]/@length"}) {
    CAPTURE(path);
    CHECK(problems(kWorld, {std::string(path) + "=1"}) ==
          "--set " + std::string(path) + "=1: " + wrong(path));
  }
  CHECK(wrong("robot[r1]/@remove") ==
        "an element can be removed before a run only: by --set, or by <set> in an experiment");
  CHECK(wrong("robot[r1]/@leeder") == "<robot> has no attribute 'leeder'; did you mean 'leader'?");
  CHECK_THAT(wrong("robot[r1]/segments/@x"), Catch::Contains("<segments> has no attribute 'x'"));
  CHECK_THAT(wrong("robot[r1]/roam/behaviors/@x"), Catch::Contains("no such element"));
  CHECK_FALSE(wrong("robot[r1]/roam/behavior[1]/@x").empty());
  CHECK(found.paths("robot[r1]/roam/@speed").size() == 1);  // all is as before
}

TEST_CASE("A text is read as from the file, and files are found as from there") {
  const Found found;
  const auto read = [&](const std::string& path, const std::string& value) {
    return found.attributes.read(found.one(path), value);
  };
  CHECK(read("robot[r1]/@max_speed", "0.25") == ParameterValue(0.25));
  CHECK(read("robot[r1]/roam/@shy", "true") == ParameterValue(true));
  CHECK(read("robot[r1]/roam/@weights", "1 2 3") == ParameterValue(std::vector<double>{1, 2, 3}));
  CHECK(read("robot[r1]/roam/@song", "songs/one.txt") ==
        ParameterValue(kFolder + "data/songs/one.txt"));
  CHECK(read("robot[r1]/roam/@song", "") == ParameterValue(std::string()));
  CHECK(found.why_not("robot[r1]/@max_speed", "3abc") ==
        "expected a number at least 0 and at most 100 m/s; write the number only; the unit is m/s");
  CHECK(found.why_not("robot[r1]/roam/@song", "none.txt").starts_with("there is no such file"));
}
