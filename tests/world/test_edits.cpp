// Edits that add elements, or set attributes back to their defaults: --set 'robot[+]=<robot/>'.
#include <catch2/catch.hpp>

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const char* const kEdited = R"(
  <obstacles><static_box id="wall" x="1"/><dynamic_box x="2"/></obstacles>
  <robots>
    <robot id="r1" max_speed="0.3">
      <body mass="2"/>
      <sensors><beam id="left" yaw_deg="20"/><eye><threshold low="0.1"/><mask/></eye></sensors>
      <behaviors><avoid/><blend id="both"><behaviors><roam/></behaviors>
        <coordinator><sum/></coordinator></blend></behaviors>
      <coordinator><sum weighted="true"/></coordinator>
    </robot>
    <robot id="r2" x="1" y="1"/>
  </robots>
  <goals><endure time="5"/></goals>)";

world::World edited(std::vector<std::string> edits) { return read(kEdited, std::move(edits)); }

std::string refused(const std::string& edit) {
  const std::string text = problems(kEdited, {edit});
  const std::string before = "--set " + edit + ": ";
  CAPTURE(text);
  REQUIRE(text.starts_with(before));
  return text.substr(before.size());
}

template <class List>
std::string ids(const List& list) {
  std::string text;
  for (const auto& each : list) {
    text += (text.empty() ? "" : " ") + each.id;
  }
  return text;
}

double low(const world::ElementUse& use) { return std::get<double>(use.parameters.at("low")); }

}  // namespace

TEST_CASE("An element is added at the end of a list or before a member") {
  const std::string robot = "=<robot id=\"r9\" x=\"-1\"/>";
  CHECK(ids(edited({"robot[+]" + robot}).robots) == "r1 r2 r9");
  CHECK(ids(edited({"robots/robot[+]" + robot}).robots) == "r1 r2 r9");
  CHECK(ids(edited({"robot[+1]" + robot}).robots) == "r9 r1 r2");
  CHECK(ids(edited({"robot[+2]" + robot}).robots) == "r1 r9 r2");
  CHECK(ids(edited({"robot[+3]" + robot}).robots) == "r1 r2 r9");
  CHECK(edited({"robot[+]" + robot, "robot[r9]/@y=3"}).robots.at(2).y == 3);
  CHECK(ids(edited({"robot[r1]/sensor[+2]=<bumper/>"}).robots[0].sensors) == "left bumper eye");
  CHECK(ids(edited({"robot[r1]/sensors/beam[+1]=<beam id=\"b\"/>"}).robots[0].sensors) ==
        "b left eye");
  CHECK(ids(edited({"robot[r1]/behavior[both]/behavior[+1]=<avoid/>"})
                .robots[0]
                .behaviors[1]
                .inside.at(0)
                .behaviors) == "avoid roam");
  CHECK(ids(edited({"dynamic_box[+1]=<dynamic_box id=\"crate\" x=\"3\"/>"}).obstacles) ==
        "wall crate dynamic_box_1");
  CHECK(std::get<world::EndureGoal>(edited({"goal[+1]=<endure time=\"1\"/>"}).goals[0]).time == 1);
}

TEST_CASE("A step selects by an attribute's value or by a plugin: none, one or several") {
  const char* const content = R"(<robots>
    <robot id="r1" team="blue" x="1"><sensors><beam/><eye/></sensors></robot>
    <robot id="r2"><sensors><beam id="left"/><beam id="right" yaw_deg="5"/></sensors></robot>
    <robot id="r3" team="red" x="-1"/></robots>)";
  const auto robots = [&](const std::string& edit) { return read(content, {edit}).robots; };
  const auto speeds = [&](const std::string& edit) {
    std::vector<double> all;
    for (const world::Robot& robot : robots(edit)) all.push_back(robot.max_speed);
    return all;
  };
  const double usual = world::Robot().max_speed;
  // The team of r2 is the default.
  CHECK(speeds("robot[team=red]/@max_speed=0.7") == std::vector{usual, 0.7, 0.7});
  CHECK(speeds("robot[team=blue]/@max_speed=0.7") == std::vector{0.7, usual, usual});
  CHECK(speeds("robot[team=green]/@max_speed=0.7") == std::vector{usual, usual, usual});
  CHECK(speeds("robot[max_speed=0.5]/@max_speed=0.7") == std::vector{0.7, 0.7, 0.7});

  const auto yaws = [&](const std::string& edit) {
    std::vector<double> all;
    for (const world::Robot& robot : robots(edit)) {
      for (const auto& sensor : robot.sensors) all.push_back(sensor.yaw_deg);
    }
    return all;
  };
  CHECK(yaws("sensor[plugin=beam]/@yaw_deg=9") == std::vector<double>{9, 0, 9, 9});
  CHECK(yaws("robot[*]/sensor[plugin=eye]/@yaw_deg=9") == std::vector<double>{0, 9, 0, 5});
  CHECK(yaws("robot[team=red]/sensor[yaw_deg=5]/@yaw_deg=9") == std::vector<double>{0, 0, 0, 9});
  CHECK(yaws("sensor[plugin=sonar]/@yaw_deg=9") == std::vector<double>{0, 0, 0, 5});

  CHECK(robots("robot[team=red]/@remove=true").size() == 1);
  CHECK(robots("robot[team=green]/@remove=true").size() == 3);
  CHECK(robots("robot[team=red]/sensor[+]=<eye/>")[2].sensors.size() == 1);
  CHECK(read(content, {"robot[team=red]/@max_speed=0.7"}).remarks.empty());
  for (const std::string edit :
       {"robot[team=green]/@x=1", "sensor[plugin=sonar]/@yaw_deg=9",
        "robot[team=green]/@remove=true", "robot[team=green]/sensor[+]=<eye/>",
        "robot[team=green]=<robot/>"}) {
    CAPTURE(edit);
    const auto remarks = read(content, {edit}).remarks;
    REQUIRE(remarks.size() == 1);
    CHECK(remarks[0].text() == "--set " + edit +
                                   ": the path leads to nothing in this world, and the edit has no "
                                   "effect");
  }
  CHECK(problems(content, {"robot[tame=red]/@x=1"}) ==
        "--set robot[tame=red]/@x=1: robot[tame=red]: no robot has an attribute 'tame'");
  CHECK_THAT(problems(content, {"robto[team=red]/@x=1"}), Catch::Contains("there is no 'robto'"));
}

TEST_CASE("A list or an element that is missing is made") {
  CHECK(edited({"charger[+]=<charger x=\"1\"/>"}).chargers.at(0).x == 1);
  CHECK(edited({"team[+]=<team id=\"crew\"/>"}).teams.size() == 3);
  CHECK(edited({"limits[+]=<limits time=\"9\"/>"}).limits.time == 9);
  const world::World w = edited({"robot[r2]/sensor[+]=<beam/>", "robot[r2]/behavior[+]=<roam/>",
                                 "robot[r2]/coordinator[+]=<pick/>", "robot[r2]/body[+]=<body/>"});
  CHECK(ids(w.robots[1].sensors) == "beam");
  CHECK(ids(w.robots[1].behaviors) == "roam");
  CHECK(w.robots[1].coordinator->plugin == "pick");
}

TEST_CASE("An element may be added in several places at once, and inside of a plugin's") {
  for (const char* path : {"robot[*]/sensor[+]", "sensor[+]"}) {
    const world::World w = edited({std::string(path) + "=<beam id=\"new\"/>"});
    CHECK(ids(w.robots[0].sensors) == "left eye new");
    CHECK(ids(w.robots[1].sensors) == "new");
  }
  const auto eye = edited({"eye/threshold[+1]=<threshold low=\"0.05\"/>",
                           "robot[r1]/sensor[eye]/threshold[+]=<threshold low=\"0.9\"/>"})
                       .robots[0]
                       .sensors[1];
  REQUIRE(eye.elements.size() == 4);
  CHECK(low(eye.elements[0]) == 0.05);
  CHECK(low(eye.elements[1]) == 0.1);
  CHECK(low(eye.elements[3]) == 0.9);
}

TEST_CASE("An added element without an id gets one as in a file, and others keep theirs") {
  CHECK(ids(edited({"robot[r1]/sensor[+1]=<beam/>", "robot[r1]/sensor[+]=<beam/>",
                    "robot[r1]/sensor[+1]=<eye/>"})
                .robots[0]
                .sensors) == "eye_2 beam left eye beam_2");
  CHECK(ids(edited({"obstacle[+1]=<dynamic_box x=\"3\"/>"}).obstacles) ==
        "dynamic_box_2 wall dynamic_box_1");
}

TEST_CASE("An element that replaces another never takes an id that is in use") {
  CHECK(ids(edited({"robot[r1]/sensor[eye]=<beam/>", "robot[r1]/sensor[+]=<eye/>",
                    "robot[r1]/sensor[beam]=<eye/>"})
                .robots[0]
                .sensors) == "left eye_2 eye");
}

TEST_CASE("An element that cannot be added is refused in a sentence") {
  CHECK(refused("robot[+]=<robot id=\"r1\" x=\"3\"/>") ==
        "a second robot with the id 'r1'; the first is there already (world.xml:4)");
  CHECK(refused("robot[+4]=<robot id=\"r9\"/>") ==
        "an element cannot be added as robot[+4]; expected robot[+] for the end, or a number from "
        "1 to 3");
  CHECK(refused("robot[+0]=<robot id=\"r9\"/>").starts_with("an element cannot be added as"));
  CHECK(refused("robot[+x]=<robot id=\"r9\"/>").starts_with("an element cannot be added as"));
  CHECK(refused("robt[+]=<robot id=\"r9\"/>") ==
        "nothing called 'robt' can be added to <world>; did you mean 'robot'?");
  CHECK(refused("robot[r1]/beam[+]=<beam/>") ==
        "nothing called 'beam' can be added to <robot>; there may be: body, drive, "
        "localisation, segment, sensor, actuator, behavior, coordinator");
  CHECK(refused("robot[r9]/sensor[+]=<beam/>") == "there is no robot[r9]; there are: r1, r2");
  CHECK(refused("static_box[+]=<dynamic_box/>") ==
        "the path adds a <static_box>, but the element is a <dynamic_box>");
  CHECK(refused("robot[r1]/coordinator[+]=<pick/>") ==
        "<coordinator> holds one element, which is there already, written or by default; to "
        "replace it, leave out the "
        "brackets: coordinator=<...>");
  CHECK(refused("robot[r1]/body[+]=<body/>") ==
        "<robot> holds one <body>, which is there already, written or by default; to replace it, "
        "leave out the brackets: "
        "body=<...>");
  CHECK(
      refused("robot[+]/@x=3").starts_with("an element that is added stands at the end of a path"));
  CHECK(refused("robot[+]/sensor[1]=<beam/>")
            .starts_with("an element that is added stands at the end of a path"));
  CHECK(refused("robot[+]=3").starts_with("the path leads to an element"));
  CHECK_THAT(refused("obstacle[+]=<beam/>"), Catch::Contains("<obstacles> may not hold <beam>"));
  CHECK_THAT(refused("robot[+]=<robot/>"), Catch::Contains("lacks the attribute 'id'"));
  CHECK_THAT(refused("robot[r1]/sensor[+]=<lidar/>"), Catch::Contains("lidar"));
  CHECK_THAT(refused("robot[r1]/sensor[+]=<beam remove=\"true\"/>"),
             Catch::Contains("could remove; to remove an element"));
}

TEST_CASE("An attribute that is removed has its default again") {
  CHECK(edited({"robot[r1]/@max_speed/@remove=true"}).robots[0].max_speed ==
        world::Robot().max_speed);
  CHECK(edited({"robot[r1]/@max_speed/@remove=false"}).robots[0].max_speed == 0.3);
  CHECK(edited({"robot[r1]/body/@mass/@remove=true"}).robots[0].body.mass ==
        world::RobotBody().mass);
  CHECK_FALSE(edited({"coordinator/@weighted/@remove=true"})
                  .robots[0]
                  .coordinator->parameters.contains("weighted"));
  CHECK(ids(edited({"robot[r1]/sensor[left]/@id/@remove=true"}).robots[0].sensors) == "beam eye");
  CHECK(edited({"robot[*]/@max_speed/@remove=true"}).robots[0].max_speed ==
        world::Robot().max_speed);
}

TEST_CASE("An attribute that cannot be removed is refused in a sentence") {
  CHECK(refused("robot[r2]/@max_speed/@remove=true") ==
        "<robot> does not set 'max_speed'; it sets: id, x, y");
  CHECK(refused("robot[r1]/@max_sped/@remove=true") ==
        "<robot> does not set 'max_sped'; did you mean 'max_speed'?");
  CHECK(refused("robot[r1]/@max_speed/@remove=yes") ==
        "remove=\"yes\" of <robot>: expected true or false");
  CHECK(problems(kEdited, {"robot[r1]/@id/@remove=true"})
            .starts_with("world.xml:4: <robot> lacks the attribute 'id'"));
  CHECK(refused("robot[r1]/@x/@y=3").starts_with("expected the name of an attribute after \"@\""));
}
