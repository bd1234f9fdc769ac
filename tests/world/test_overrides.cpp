// Changing attributes by their paths: --set PATH=VALUE.
#include <catch2/catch.hpp>

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const char* const kOverridden = R"(
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

world::World with(std::vector<std::string> edits) { return read(kOverridden, std::move(edits)); }
std::string wrong(const std::string& override) { return problems(kOverridden, {override}); }

/// What is said of an override of a world with this content, without the override itself.
std::string said_of(const std::string& override, const std::string& content = kOverridden) {
  const std::string text = problems(content, {override});
  const std::string before = "--set " + override + ": ";
  CAPTURE(text);
  REQUIRE(text.starts_with(before));
  return text.substr(before.size());
}

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
  CHECK(with({"obstacle[crate]/@mass=4"}).obstacles[1].mass == 4);
  CHECK(with({"static_box[1]/@height=4"}).obstacles[0].height == 4);
  CHECK(with({"obstacle[static_box_1]/@height=4"}).obstacles[0].height == 4);
  CHECK(std::get<world::EndureGoal>(with({"goal[1]/@time=7"}).goals[0]).time == 7);
  CHECK(std::get<bool>(with({"robot[r2]/coordinator/@weighted=true"})
                           .robots[1]
                           .coordinator->parameters.at("weighted")));
  CHECK(std::get<bool>(with({"robot[r2]/coordinator/sum/@weighted=true"})
                           .robots[1]
                           .coordinator->parameters.at("weighted")));
}

TEST_CASE("A path that begins at a group finds each of its members once") {
  const char* const kOneOfEach =
      "<teams><team id=\"red\"/></teams><obstacles><static_box x=\"1\"/></obstacles>"
      "<robots><robot id=\"r1\" "
      "team=\"red\"><sensors><beam/></sensors><behaviors><avoid/></behaviors>"
      "<coordinator><sum/></coordinator></robot></robots>"
      "<goals><travel distance=\"5\"/></goals>";
  const auto one = [&](const std::string& override) { return read(kOneOfEach, {override}); };
  for (const char* path : {"goals/travel", "travel", "goals/travel[1]", "goals/goal", "goal[1]"}) {
    CAPTURE(path);
    const world::World w = one(std::string(path) + "/@distance=1");
    CHECK(std::get<world::TravelGoal>(w.goals[0]).distance == 1);
  }
  for (const char* path : {"robots/robot", "robot", "robots/robot[1]", "robots/robot[r1]"}) {
    CAPTURE(path);
    CHECK(one(std::string(path) + "/@x=0.5").robots[0].x == 0.5);
  }
  CHECK(one("obstacles/static_box/@height=4").obstacles[0].height == 4);
  CHECK(one("robots/robot/behaviors/avoid/@priority=3").robots[0].behaviors[0].priority == 3);
  CHECK(problems(kOneOfEach, {"goals/travel[2]/@distance=1"}) ==
        "--set goals/travel[2]/@distance=1: there is no travel[2]; they are numbered from 1 to 1");
  // Two are two, and the second is the second.
  CHECK(with({"robots/robot[2]/@max_speed=0.3"}).robots[1].max_speed == 0.3);
  CHECK_THAT(wrong("robots/robot/@max_speed=0.3"),
             Catch::Contains("'robot' could be any of 2; say which, as in robot[r1]"));
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
    for (const world::MountedUse& sensor : robot.sensors) {
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
  const auto message = [](const std::string& override) { return said_of(override); };
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
  CHECK(message("robot[r2]/drive=<car/>") ==
        "there is no 'drive' in <robot> of this world; to add one, write drive[+] in the path");
}

TEST_CASE("A path that is none is refused in words") {
  CHECK(wrong("max_speed") ==
        "--set max_speed: expected PATH=VALUE, as in robot[r1]/@max_speed=0.3");
  CHECK(wrong("robot[r1]=3") ==
        "--set robot[r1]=3: the path leads to an element; expected an attribute at its end, as in "
        "robot[r1]/@max_speed, or an element after the \"=\", as in "
        "robot[r1]/coordinator=<arbiter_suppression/>");
  CHECK(wrong("robot[r1/@x=3") ==
        "--set robot[r1/@x=3: expected an id, a number, * or ATTRIBUTE=VALUE in brackets after "
        "'robot', which are not closed by a ]");
  CHECK(wrong("robot[r1][2]/@x=3") ==
        "--set robot[r1][2]/@x=3: 'robot' has more than one pair of brackets; expected one");
  CHECK(wrong("robot[]/@x=3") ==
        "--set robot[]/@x=3: expected an id, a number, * or ATTRIBUTE=VALUE in brackets after "
        "'robot'");
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

namespace {

const char* const kNestedPlugins = R"(
  <robots>
    <robot id="r1">
      <sensors>
        <eye><threshold low="0.1"/><mask/><threshold low="0.2"/></eye>
      </sensors>
      <behaviors>
        <blend id="explore">
          <rule of="roam"/>
          <behaviors>
            <roam/>
            <blend>
              <behaviors><roam id="stroll"/><roam/></behaviors>
              <coordinator><sum/></coordinator>
            </blend>
          </behaviors>
          <coordinator><layers><suppress by="roam" of="blend"/></layers></coordinator>
        </blend>
      </behaviors>
      <coordinator>
        <layers><inhibit by="a" of="b"/><suppress by="c" of="d"/><suppress by="e" of="f"/></layers>
      </coordinator>
    </robot>
  </robots>)";

world::Robot nested(const std::string& override) {
  return read(kNestedPlugins, {override}).robots[0];
}
std::string text(const world::PluginUse& use, std::size_t element, const char* name) {
  return std::get<std::string>(use.elements.at(element).parameters.at(name));
}

}  // namespace

TEST_CASE("A path leads to the elements that a plugin declares") {
  CHECK(text(*nested("robot[r1]/coordinator/suppress[1]/@by=x").coordinator, 1, "by") == "x");
  CHECK(text(*nested("robot[r1]/coordinator/layers/suppress[2]/@by=x").coordinator, 2, "by") ==
        "x");
  CHECK(text(*nested("coordinator/inhibit/@of=x").coordinator, 0, "of") == "x");
  const world::Robot robot = nested("robot[r1]/sensor[eye]/threshold[2]/@low=0.5");
  CHECK(std::get<double>(robot.sensors[0].elements[2].parameters.at("low")) == 0.5);
  for (const std::size_t i : {0U, 2U}) {
    CHECK(std::get<double>(
              nested("eye/threshold[*]/@high=0.75").sensors[0].elements[i].parameters.at("high")) ==
          0.75);
  }
}

TEST_CASE("A path leads to what a behaviour holds, at any depth") {
  const auto inside = [](const std::string& override) {
    return nested(override).behaviors[0].inside.at(0);
  };
  CHECK(inside("robot[r1]/behavior[explore]/behavior[roam]/@priority=2").behaviors[0].priority ==
        2);
  CHECK(inside("robot[r1]/behavior[explore]/behaviors/roam/@priority=2").behaviors[0].priority ==
        2);
  CHECK(inside("blend/blend/behavior[stroll]/@priority=2")
            .behaviors[1]
            .inside.at(0)
            .behaviors[0]
            .priority == 2);
  CHECK(inside("blend/behavior[blend]/behavior[*]/@priority=2")
            .behaviors[1]
            .inside.at(0)
            .behaviors[1]
            .priority == 2);
  CHECK(text(*inside("behavior[explore]/coordinator/suppress/@hold_s=2").coordinator, 0, "by") ==
        "roam");
  CHECK(std::get<double>(nested("behavior[explore]/rule[1]/@weight=2")
                             .behaviors[0]
                             .elements[0]
                             .parameters.at("weight")) == 2);
}

TEST_CASE("A path that leads nowhere inside of a plugin says what is there instead") {
  const auto message = [](const std::string& override) {
    return said_of(override, kNestedPlugins);
  };
  CHECK(message("robot[r1]/coordinator/suppress/@by=x") ==
        "'suppress' could be any of 2; say which, as in suppress[1], or suppress[*] for all of "
        "them");
  CHECK(message("robot[r1]/coordinator/suppress[3]/@by=x") ==
        "there is no suppress[3]; they are numbered from 1 to 2");
  CHECK(message("robot[r1]/coordinator/supress[1]/@by=x") ==
        "there is no 'supress' in <layers>; did you mean 'suppress'?");
  CHECK(message("robot[r1]/sensor[eye]/lid/@low=x") ==
        "there is no 'lid' in <eye>; there are: mask, threshold");
  CHECK(message("robot[r1]/behavior[explore]/behavior[strol]/@speed=1") ==
        "there is no behavior[strol]; there are: roam, blend");
  CHECK(message("robot[r1]/behavior[explore]/behaviour[roam]/@speed=1") ==
        "there is no 'behaviour' in <blend>; did you mean 'behavior'?");
  CHECK(message("robot[r1]/behavior[explore]/behavior[roam]/behavior[1]/@speed=1") ==
        "there is no 'behavior' in <roam>");
  CHECK(message("robot[r1]/behavior[explore]/behavior[roam]/@sped=1") ==
        "<roam> has no attribute 'sped'; did you mean 'speed'?");
  CHECK(message("robot[r1]/coordinator/suppress[1]/@hold_s=61") ==
        "hold_s=\"61\" of <suppress>: expected a number at least 0 and at most 60 s");
}

TEST_CASE("An element that holds others may replace one") {
  const world::Robot robot = nested(
      "robot[r1]/behavior[explore]/behavior[blend]=<blend haste='2'><behaviors><roam/><roam/>"
      "</behaviors><coordinator><pick/></coordinator></blend>");
  const world::BehaviorUse& blend = robot.behaviors[0].inside.at(0).behaviors[1];
  CHECK(blend.id == "blend");
  REQUIRE(blend.inside.at(0).behaviors.size() == 2);
  CHECK(blend.inside[0].behaviors[1].id == "roam_2");
  CHECK(blend.inside[0].coordinator->id == "pick");
}

TEST_CASE("An override may take away what stands in a robot or in a behaviour") {
  CHECK(with({"robot[r1]/sensor[left]/@remove=true"}).robots[0].sensors.size() == 2);
  CHECK(with({"robot[r1]/behavior[roam]/@remove=false"}).robots[0].behaviors.size() == 2);
  CHECK(with({"robot[r1]/behavior[roam]/@remove=true"}).robots[0].behaviors.size() == 1);
  CHECK(nested("robot[r1]/behavior[explore]/behavior[blend]/behavior[roam]/@remove=true")
            .behaviors[0]
            .inside.at(0)
            .behaviors[1]
            .inside.at(0)
            .behaviors.size() == 1);
  CHECK(wrong("robot[r1]/sensor[left]/@remove=maybe") ==
        "--set robot[r1]/sensor[left]/@remove=maybe: remove=\"maybe\" of <beam>: expected true or "
        "false");
  CHECK(wrong("robot[r1]/coordinator/@remove=true") ==
        "world.xml:4: the robot 'r1' has behaviours but no coordinator; add a <coordinator>");
}

namespace {

const char* const kCrowd = R"(
  <teams><team id="crew"/></teams>
  <obstacles>
    <static_box id="wall" x="1"/><static_box x="2"/>
    <moving_box id="cart" y="2"><waypoint x="1" y="2"/><waypoint x="2" y="2"/></moving_box>
  </obstacles>
  <resources><resource x="-1"/></resources>
  <chargers><charger id="dock" x="-1" y="1"/></chargers>
  <robots>
    <robot id="r1" x="-2">
      <segments><segment/><segment id="last"/></segments>
      <sensors><eye><threshold low="0.1"/><mask/><threshold low="0.2"/></eye></sensors>
      <behaviors><roam id="stroll"/><roam/></behaviors>
      <coordinator><layers><suppress by="stroll" of="roam"/></layers></coordinator>
    </robot>
    <robot id="r2" y="1"/>
    <robot id="r3" y="-1"/>
  </robots>
  <goals><endure time="5"/><travel robot="r1" distance="1"/></goals>)";

world::World crowd(std::vector<std::string> edits) { return read(kCrowd, std::move(edits)); }

}  // namespace

TEST_CASE("An override may take away whatever may stand any number of times") {
  CHECK(crowd({"robot[r2]/@remove=true"}).robots.at(1).id == "r3");
  CHECK(crowd({"robot[*]/@remove=true", "travel/@remove=false", "goal[2]/@remove=true"})
            .robots.empty());
  CHECK(crowd({"obstacle[wall]/@remove=true"}).obstacles.at(0).id == "static_box_2");
  CHECK(crowd({"obstacles/static_box[2]/@remove=true"}).obstacles.at(1).id == "cart");
  CHECK(crowd({"moving_box[cart]/waypoint[1]/@remove=true"}).obstacles.at(2).waypoints.size() == 1);
  CHECK(crowd({"resource/@remove=true"}).obstacles.size() == 3);
  CHECK(crowd({"charger[dock]/@remove=true"}).chargers.empty());
  CHECK(crowd({"goal[1]/@remove=true"}).goals.size() == 1);
  CHECK(crowd({"robot[r1]/segment[last]/@remove=true"}).robots.at(0).segments.size() == 1);
  const world::Robot r1 =
      crowd({"eye/threshold[1]/@remove=true", "coordinator/suppress/@remove=true"}).robots.at(0);
  REQUIRE(r1.sensors.at(0).elements.size() == 2);
  CHECK(r1.sensors[0].elements[0].element == "mask");
  CHECK(std::get<double>(r1.sensors[0].elements[1].parameters.at("low")) == 0.2);
  CHECK(read("<teams><team id=\"crew\"/></teams>", {"team[crew]/@remove=true"}).teams.size() == 2);
}

TEST_CASE("What is taken away keeps its number until the end, and may be set all the same") {
  const world::World w = crowd({"robot[1]/@remove=true", "goal[2]/@remove=true",
                                "robot[2]/@max_speed=0.3", "robot[*]/@coverage=7"});
  REQUIRE(w.robots.size() == 2);
  CHECK(w.robots[0].id == "r2");
  CHECK(w.robots[0].max_speed == 0.3);
  CHECK(w.robots[1].coverage == 7);
  CHECK(crowd({"robot[r2]/@remove=true", "robot[r2]/@remove=false"}).robots.size() == 3);
}

TEST_CASE("What is left after a removal is checked like a file") {
  CHECK(problems(kCrowd, {"robot[r1]/@remove=true"}) ==
        "world.xml:19: robot=\"r1\" of <travel>: there is no such robot; did you mean 'r2'?");
  CHECK_THAT(problems(kCrowd, {"moving_box[cart]/waypoint[*]/@remove=true"}),
             Catch::Contains("<moving_box>") && Catch::Contains("waypoint"));
  CHECK_THAT(problems(kCrowd, {"robot[r1]/coordinator/@remove=true"}),
             Catch::Contains("has behaviours but no coordinator"));
}

TEST_CASE("What cannot be taken away is refused in words") {
  const auto message = [](const std::string& override) { return said_of(override, kCrowd); };
  CHECK(message("@remove=true") ==
        "the world itself cannot be removed; expected the path of something in it, as in "
        "robot[r1]/@remove");
  CHECK(message("robots/@remove=true") ==
        "<robots> is a list and cannot be removed; to empty it, remove what stands in it: "
        "robot[*]/@remove");
  CHECK(message("robot[r1]/sensors/@remove=true") ==
        "<sensors> is a list and cannot be removed; to empty it, remove what stands in it: "
        "sensor[*]/@remove");
  for (const char* once : {"arena", "physics", "limits", "robot[r1]/body"}) {
    CHECK_THAT(message(std::string(once) + "/@remove=true"),
               Catch::Contains("cannot be removed: it is always there, with its defaults where "
                               "nothing is set; set its attributes instead"));
  }
  CHECK(message("robot[r1]/@remove=yes") == "remove=\"yes\" of <robot>: expected true or false");
  CHECK(message("robot[r9]/@remove=true") == "there is no robot[r9]; there are: r1, r2, r3");
  CHECK(message("robot[r1]/behavior[roam]=<roam remove=\"true\"/>") ==
        "there is nothing that <roam remove=\"...\"> could remove; to remove an element, end its "
        "path with @remove=true");
  CHECK_THAT(
      problems(kCrowd, {"behavior[roam]/@remove=true", "robot[r1]/behavior[roam]=<roam/>"}),
      Catch::Contains("this replaces the element in which 'behavior[roam]/@remove=true' is set "
                      "before"));
}

TEST_CASE("An attribute called template is a robot's or a parameter like others") {
  CHECK(problems(kNestedPlugins, {"coordinator/inhibit/@template=x"}) ==
        "--set coordinator/inhibit/@template=x: <inhibit> has no attribute 'template'; it may "
        "have: by, of");
  CHECK(read(kNestedPlugins, {"@name=robot[r1]/@template=x"}).name == "robot[r1]/@template=x");
}

TEST_CASE("A path to an element replaces it by another") {
  const world::World world =
      with({"robot[r1]/coordinator=<pick/>", "robot[r1]/sensor[left]=<bumper x=\"0.5\"/>",
            "robot[r1]/behavior[roam]=<avoid id=\"second\"/>"});
  const world::Robot& robot = world.robots[0];
  REQUIRE(robot.coordinator);
  CHECK(robot.coordinator->plugin == "pick");
  CHECK(robot.coordinator->id == "pick");
  CHECK(robot.sensors[0].plugin == "bumper");
  CHECK(robot.sensors[0].id == "left");
  CHECK(robot.sensors[0].x == 0.5);
  CHECK(robot.behaviors[1].id == "second");
  CHECK(with({"robot[*]/coordinator=<pick/>"}).robots[1].coordinator->plugin == "pick");
}

TEST_CASE("What replaces an element is checked like the file, and blamed on the override") {
  CHECK(
      wrong("robot[r1]/coordinator=<summ/>").starts_with("--set robot[r1]/coordinator=<summ/>: "));
  CHECK(wrong("robot[r1]/sensor[left]=<beam rnge=\"1\"/>").find("has no attribute 'rnge'") !=
        std::string::npos);
  CHECK(wrong("robot[r1]/coordinator=<sum").starts_with("--set robot[r1]/coordinator=<sum: "));
  CHECK(wrong("robot[r1]/coordinator=<sum/><sum/>")
            .starts_with("--set robot[r1]/coordinator=<sum/><sum/>: "));
}

TEST_CASE("An element is not replaced when something was set in it before: that would be lost") {
  CHECK(problems(kOverridden,
                 {"robot[r1]/coordinator/@weighted=true", "robot[r1]/coordinator=<pick/>"}) ==
        "--set robot[r1]/coordinator=<pick/>: this replaces the element in which "
        "'robot[r1]/coordinator/@weighted=true' is set before; set that afterwards, or in the new "
        "element");
  CHECK(problems(kOverridden,
                 {"robot[r1]/coordinator=<layers/>", "robot[r1]/coordinator=<pick/>"}) == "");
  CHECK(problems(kOverridden,
                 {"robot[r1]/coordinator=<sum/>", "robot[r1]/coordinator/@weighted=true"}) == "");
  CHECK_THAT(
      problems(kOverridden, {"robot[r1]/coordinator=<sum/>", "robot[r1]/coordinator/@weighted=true",
                             "robot[r1]/coordinator=<pick/>"}),
      Catch::Contains("'robot[r1]/coordinator/@weighted=true' is set before"));
}

TEST_CASE("Files that overrides name are looked for beside the file in which the overrides stand") {
  const auto with_song = [](const std::string& from, const std::string& song) {
    world::ReadOptions reading = options({"robot[r1]/behavior[roam]/@song=" + song});
    reading.edits_from = from;
    return world::parse_world("<world format=\"1\">" + std::string(kOverridden) + "</world>",
                              kFolder + "world.xml", host(), reading);
  };
  const world::World w = with_song(kFolder + "data/songs/other.xml", "one.txt");
  const world::BehaviorUse& roam = w.robots[0].behaviors[1];
  CHECK(std::get<std::string>(roam.parameters.at("song")) == kFolder + "data/songs/one.txt");
  CHECK(roam.file_names.at("song").name == "songs/one.txt");  // as the world would call it
  try {
    with_song(kFolder + "wrong/other.xml", "data/songs/one.txt");
    FAIL("that lies beside the world");
  } catch (const world::WorldError& error) {
    CHECK_THAT(error.what(), Catch::Contains("there is no such file; looked in the folder " +
                                             kFolder + "wrong or in the data directory"));
  }
}

TEST_CASE("What a template would have had is not missed when the template is not there") {
  const std::string world =
      "<robots><robot id=\"r1\" template=\"nowhere.xml\"/><robot id=\"r2\" x=\"1\"/></robots>";
  for (const char* path : {"robot[r1]/behavior[roam]/@speed", "robot[r1]/sensor[2]/@yaw_deg",
                           "behavior[roam]/@speed"}) {
    CHECK_THAT(
        problems(world, {std::string(path) + "=3"}),
        Catch::StartsWith("world.xml:1: the template 'nowhere.xml': there is no such file") &&
            !Catch::Contains("\n"));
  }
  CHECK_THAT(problems(world, {"robot[r2]/behavior[roam]/@speed=3"}),
             Catch::Contains("--set robot[r2]/behavior[roam]/@speed=3: there is no 'behavior'"));
}
