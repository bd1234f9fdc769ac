// Edits of running worlds read only what they lead to.
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/world/world_tree.h"
#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"
#include "folder.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const world::World& crowd() {
  static const world::World world = read(R"(
    <teams><team id="green"/></teams>
    <obstacles><static_box id="wall" x="1"/><dynamic_box x="2"/></obstacles>
    <resources><resource id="food" x="3" team="green"/></resources>
    <robots>
      <robot id="r1" team="green"><sensors><beam/></sensors><behaviors><roam/><avoid/></behaviors>
        <coordinator><sum weighted="true"/></coordinator></robot>
      <robot id="r2" x="1" y="1" energy="20" battery="100"><sensors><beam/></sensors></robot>
      <robot id="r3" x="-1" y="-1"/>
    </robots>
    <goals><reach robot="r3" x="1" y="2"/><endure time="5"/><push box="dynamic_box_1" x="2" y="2"/>
    </goals>
    <changes><change time="1" path="robot[r3]/@x" value="2"/></changes>)");
  return world;
}

world::World edited(std::vector<std::string> edits) {
  return world::edited(world::WorldTree(crowd()), host(), options(std::move(edits)));
}

/// What is wrong with the edits; "" if they can be made.
std::string why_not(std::vector<std::string> edits) {
  try {
    edited(std::move(edits));
    return "";
  } catch (const world::WorldError& error) {
    return error.problems().front().message;
  }
}

/// The same edits of the world as a text, all of which is read.
world::World read_again(std::vector<std::string> edits) {
  world::ReadOptions reading = options(std::move(edits));
  reading.is_running = true;
  return world::parse_world(world::write_world(crowd()), crowd().file, host(), reading);
}

}  // namespace

TEST_CASE("An edit makes the world that its text would be, and shares what it does not lead to") {
  using Edits = std::vector<std::string>;
  for (const auto& [edits, robots] : std::vector<std::pair<Edits, std::vector<bool>>>{
           {{"robot[r1]/behavior[roam]=<roam speed=\"3\"/>"}, {false, true, true}},
           {{"robot[r1]/behavior[+]=<roam/>", "robot[3]/@y=2"}, {false, true, false}},
           {{"robot[r2]/@remove=true"}, {true, true}},
           {{"robot[+1]=<robot id=\"r0\" x=\"4\"/>"}, {false, true, true, true}},
           {{"robot[*]/@max_speed=0.1"}, {false, false, false}},
           {{"coordinator/@weighted/@remove=true"}, {false, false, false}},
           {{"obstacle[+]=<static_box x=\"3\" y=\"3\"/>"}, {true, true, true}},
           {{"obstacle[1]/@x=4", "resource[+]=<resource x=\"-3\"/>"}, {true, true, true}},
           {{"physics/@step=0.02", "@name=other", "goal[2]/@time=7"}, {true, true, true}},
           {{"goal[1]/@remove=true", "robot[r3]/@id=r4"}, {true, true, false}},
           {{"change[1]/@time=3"}, {true, true, true}},
           {{"team[green]/@colour=#102030"}, {true, true, true}}}) {
    CAPTURE(edits);
    const world::World now = edited(edits);
    CHECK(world::write_world(now) == world::write_world(read_again(edits)));
    CHECK(same(now, read_again(edits)));
    std::vector<bool> is_shared;
    for (const world::Robot& robot : now.robots) {
      is_shared.push_back(false);
      for (const world::Robot& before : crowd().robots) {
        is_shared.back() = is_shared.back() || &robot == &before;
      }
    }
    CHECK(is_shared == robots);
    CHECK(now.edits.is(crowd().edits) == !edits[0].starts_with("change"));
  }
}

TEST_CASE("Files that a robot has stay the same when an edit leads into it") {
  const Folder worlds, data, experiments, current;
  worlds.write("near.txt", "");
  data.write("shared.txt", "");
  for (const Folder* other : {&experiments, &current}) {
    other->write("near.txt", "");
    other->write("shared.txt", "");
  }
  world::ReadOptions reading = options();
  reading.data_directories = {data.path().string()};
  const world::World before = world::parse_world(
      "<world format=\"1\"><robots>"
      "<robot id=\"r1\"><behaviors><roam song=\"near.txt\"/></behaviors>"
      "<coordinator><pick/></coordinator></robot>"
      "<robot id=\"r2\" x=\"1\"><behaviors><roam song=\"shared.txt\"/></behaviors>"
      "<coordinator><pick/></coordinator></robot></robots></world>",
      worlds.file("world.xml"), host(), reading);
  reading.edits = {"robot[*]/@max_speed=0.1"};
  const auto was_in = std::filesystem::current_path();
  std::filesystem::current_path(current.path());
  for (const std::string& edits_from : {std::string(), experiments.file("study.xml")}) {
    CAPTURE(edits_from);
    reading.edits_from = edits_from;
    const world::World now = world::edited(world::WorldTree(before), host(), reading);
    for (const std::size_t robot : {0, 1}) {
      const auto song = [&](const world::World& world) {
        return world.robots[robot].behaviors[0].parameters.at("song");
      };
      CHECK(song(now) == song(before));
      CHECK(now.robots[robot].max_speed == 0.1);
    }
  }
  std::filesystem::current_path(was_in);
}

TEST_CASE("What no edit leads to must still have what it refers to") {
  CHECK(why_not({"robot[r3]/@remove=true"}) ==
        "robot=\"r3\" of <reach>: there is no such robot; did you mean 'r1'?");
  CHECK(why_not({"team[green]/@remove=true"}).find("there is no such team") != std::string::npos);
  CHECK(why_not({"obstacle[dynamic_box_1]/@id=other"}).find("there is no such box") !=
        std::string::npos);
  CHECK(why_not({"obstacle[+]=<static_box id=\"food\" x=\"4\"/>"}).find("a second box") == 0);
  CHECK(why_not({"robot[r2]/@id=r1"}).find("a second robot") == 0);
}

TEST_CASE("Conditions on two attributes hold in every edit of a running world") {
  const auto is_refused = [](std::vector<std::string> edits, const std::string& part) {
    CAPTURE(edits);
    const std::string why = why_not(std::move(edits));
    CAPTURE(why);
    CHECK(why.find(part) != std::string::npos);
  };
  const std::string energy = "starts with energy ";
  is_refused({"robot[r2]/@energy=101"}, energy + "101, but its battery holds 100");
  is_refused({"robot[r2]/@energy=101", "robot[r2]/@x=2"}, energy);
  is_refused({"robot[r2]/@battery=50", "robot[r2]/@energy=60"}, energy + "60");
  is_refused({"robot[r2]=<robot id=\"r2\" energy=\"60\" battery=\"50\"/>"}, energy + "60");
  is_refused({"robot[+]=<robot id=\"r9\" x=\"4\" energy=\"60\" battery=\"50\"/>"}, energy + "60");
  CHECK(why_not({"robot[r2]/@energy=101", "robot[r2]/@battery=102"}).empty());
  // A smaller battery holds less than the robot began with.
  CHECK(why_not({"robot[r2]/@battery=10"}).empty());
  CHECK(why_not({"robot[r2]/@battery=10", "robot[r2]/@x=2"}).empty());
  is_refused({"physics/@kp=1"}, "'kp' without 'kd'");
  is_refused({"physics=<physics kd=\"1\"/>"}, "'kd' without 'kp'");
  is_refused({"physics/@kp=1", "physics/@kd=1", "physics/@erp=0.2"}, "'erp' beside kp and kd");
  CHECK(why_not({"physics/@kp=1", "physics/@kd=1"}).empty());
  is_refused({"robot[r3]/body/@shape=round", "robot[r3]/body/@length=0.2"}, "has a round body");
}
