// Changing attributes by their paths: --set PATH=VALUE.
#include <catch2/catch.hpp>

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const char* const kWorld = R"(
  <obstacles><static_box x="1"/><dynamic_box id="crate" x="2"/></obstacles>
  <robots>
    <robot id="r1">
      <sensors><beam id="left"/><beam id="right"/><bumper/></sensors>
      <behaviors><avoid/><roam/></behaviors>
      <coordinator><sum/></coordinator>
    </robot>
    <robot id="r2" x="1" y="1">
      <sensors><beam/></sensors>
      <coordinator><sum/></coordinator>
    </robot>
  </robots>
  <goals><endure time="5"/></goals>)";

world::World with(std::vector<std::string> overrides) { return read(kWorld, std::move(overrides)); }
std::string wrong(const std::string& override) { return problems(kWorld, {override}); }

}  // namespace

TEST_CASE("A path leads to any attribute") {
  CHECK(with({"@name=other"}).name == "other");
  CHECK(with({"physics/@step=0.005"}).physics.step == 0.005);
  CHECK(with({"robot[r1]/@max_speed=0.3"}).robots[0].max_speed == 0.3);
  CHECK(with({"robots/robot[r2]/@max_speed=0.3"}).robots[1].max_speed == 0.3);
  CHECK(with({"robot[r1]/body/@mass=2"}).robots[0].body.mass == 2);
  CHECK(with({"robot[r1]/behavior[avoid]/@priority=3"}).robots[0].behaviors[0].priority == 3);
  CHECK(with({"robot[r1]/behaviors/avoid/@priority=3"}).robots[0].behaviors[0].priority == 3);
  CHECK(with({"robot[r1]/avoid/@priority=3"}).robots[0].behaviors[0].priority == 3);
  CHECK(with({"robot[r1]/sensor[2]/@yaw_deg=9"}).robots[0].sensors[1].yaw_deg == 9);
  CHECK(with({"robot[r1]/sensor[bumper]/@yaw_deg=9"}).robots[0].sensors[2].yaw_deg == 9);
  CHECK(with({"robot[r1]/beam[right]/@yaw_deg=9"}).robots[0].sensors[1].yaw_deg == 9);
  CHECK(with({"obstacle[crate]/@mass=4"}).boxes[1].mass == 4);
  CHECK(with({"static_box[1]/@height=4"}).boxes[0].height == 4);
  CHECK(with({"obstacle[static_box_1]/@height=4"}).boxes[0].height == 4);
  CHECK(std::get<world::EndureGoal>(with({"goal[1]/@time=7"}).goals[0]).time == 7);
  CHECK(std::get<bool>(with({"robot[r2]/coordinator/@weighted=true"})
                           .robots[1]
                           .coordinator->parameters.at("weighted")));
  CHECK(std::get<bool>(with({"robot[r2]/coordinator/sum/@weighted=true"})
                           .robots[1]
                           .coordinator->parameters.at("weighted")));
}

TEST_CASE("A star leads to all, and so does what belongs to a robot when none is named") {
  for (const char* override : {"robot[*]/@max_speed=0.3", "robots/robot[*]/@max_speed=0.3"}) {
    const world::World w = with({override});
    CHECK(w.robots[0].max_speed == 0.3);
    CHECK(w.robots[1].max_speed == 0.3);
  }
  const world::World w =
      with({"coordinator/@weighted=true", "sensor[*]/@energy_cost=0", "body/@mass=0.2"});
  for (const world::Robot& robot : w.robots) {
    CHECK(std::get<bool>(robot.coordinator->parameters.at("weighted")));
    CHECK(robot.body.mass == 0.2);
    for (const world::SensorUse& sensor : robot.sensors) {
      CHECK(sensor.energy_cost == 0);
    }
  }
}

TEST_CASE("Overrides are applied in order, and checked like the file") {
  CHECK(with({"robot[r1]/@x=1", "robot[r1]/@x=3"}).robots[0].x == 3);
  CHECK(wrong("physics/@step=0") ==
        "--set physics/@step=0: step=\"0\" of <physics>: expected a number at least 1e-06 and at "
        "most 0.1 "
        "s");
  CHECK(wrong("robot[r1]/@max_sped=1") ==
        "--set robot[r1]/@max_sped=1: <robot> has no attribute 'max_sped'; did you mean "
        "'max_speed'?");
  CHECK(wrong("robot[r1]/behavior[roam]/@mood=bald") ==
        "--set robot[r1]/behavior[roam]/@mood=bald: mood=\"bald\" of <roam>: expected one of "
        "'calm', 'bold'; did you mean 'bold'?");
  CHECK(wrong("robot[r2]/@id=r1") ==
        "--set robot[r2]/@id=r1: a second robot with the id 'r1'; the first is there already "
        "(world.xml:4)");
  // A file of its own is looked for beside the world.
  CHECK(std::get<std::string>(
            with({"roam/@song=data/songs/one.txt"}).robots[0].behaviors[1].parameters.at("song"))
            .ends_with("data/songs/one.txt"));
}

TEST_CASE("A path that leads nowhere says what is there instead") {
  const std::string set = "--set ";
  const auto message = [&](const std::string& override) {
    const std::string text = wrong(override);
    REQUIRE(text.starts_with(set + override + ": "));
    return text.substr(set.size() + override.size() + 2);
  };
  CHECK(message("robot[r3]/@x=1") == "there is no robot[r3]; there are: r1, r2");
  CHECK(message("robot[r1]/sensor[lfet]/@x=1") ==
        "there is no sensor[lfet]; there are: left, right, bumper");
  CHECK(message("robot[r1]/sensor[4]/@x=1") ==
        "there is no sensor[4]; they are numbered from 1 to 3");
  CHECK(message("robot[r1]/sensor[0]/@x=1") ==
        "there is no sensor[0]; they are numbered from 1 to 3");
  CHECK(message("goal[first]/@time=1") == "there is no goal[first]; they are numbered from 1 to 1");
  CHECK(message("robot/@x=1") ==
        "'robot' could be any of 2; say which, as in robot[r1], or robot[*] for all of them");
  CHECK(message("robt[r1]/@x=1") == "there is no 'robt' in <world>; did you mean 'robot'?");
  CHECK(message("robot[r1]/sensro[1]/@x=1") ==
        "there is no 'sensro' in <robot>; did you mean 'sensor'?");
  CHECK(message("charger[1]/@x=1") == "there is no 'charger' in <world> of this world");
  CHECK(message("robot[r2]/behavior[1]/@x=1") == "there is no 'behavior' in <robot> of this world");
}

TEST_CASE("A path that is none is refused in words") {
  CHECK(wrong("max_speed") ==
        "--set max_speed: expected PATH=VALUE, as in robot[r1]/@max_speed=0.3");
  CHECK(wrong("robot[r1]=3") ==
        "--set robot[r1]=3: the path leads to an element; expected an attribute at its end, as in "
        "robot[r1]/@max_speed");
  CHECK(wrong("robot[r1/@x=3") ==
        "--set robot[r1/@x=3: expected an id, a number or * in the brackets after 'robot'");
  CHECK(wrong("robot[]/@x=3") ==
        "--set robot[]/@x=3: expected an id, a number or * in the brackets after 'robot'");
  CHECK(wrong("robot[r1]@x=3") == "--set robot[r1]@x=3: expected \"/\" before '@x'");
  CHECK(wrong("/robot[r1]/@x=3") ==
        "--set /robot[r1]/@x=3: a step of the path is empty; a path looks like "
        "robot[r1]/@max_speed");
  CHECK(wrong("robot[r1]/@=3") ==
        "--set robot[r1]/@=3: expected the name of an attribute after \"@\", at the end of the "
        "path");
  CHECK(wrong("=3") ==
        "--set =3: a step of the path is empty; a path looks like robot[r1]/@max_speed");
  CHECK(wrong("") == "--set : expected PATH=VALUE, as in robot[r1]/@max_speed=0.3");
}
