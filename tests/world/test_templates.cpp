// Robots that are mostly described in another file.
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <utility>

#include <catch2/catch.hpp>

#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"
#include "folder.h"

using namespace elsie;
using namespace elsie::test;
namespace fs = std::filesystem;

namespace {

// A folder of files for one test, with the world in worlds/.
class Files {
 public:
  Files(std::initializer_list<std::pair<std::string, std::string>> files) {
    for (const auto& [name, text] : files) {
      folder_.write(name, text);
    }
  }

  std::string path(const std::string& name) const { return folder_.file(name); }

  world::World read(const std::string& robots, std::vector<std::string> edits = {}) const {
    fs::create_directories(folder_ / "worlds");
    return world::parse_world("<world format='1'><robots>" + robots + "</robots></world>",
                              path("worlds/world.xml"), host(), options(std::move(edits)));
  }

 private:
  test::Folder folder_;
};

const char* const kTwoBeams = R"(<robot_template format="1" max_speed="0.4" leader="true">
  <body length="0.1" width="0.09"/>
  <sensors>
    <beam id="left" yaw_deg="15" max_range="2"/>
    <beam id="right" yaw_deg="-15" max_range="2"/>
    <bumper/>
  </sensors>
  <behaviors>
    <avoid priority="2"/>
    <roam speed="5" patience="4"/>
  </behaviors>
  <coordinator><sum weighted="true"/></coordinator>
</robot_template>)";

}  // namespace

TEST_CASE("A robot is what its template says") {
  const Files files{{"robots/two.xml", kTwoBeams}};
  const world::World w = files.read("<robot id='r1' template='../robots/two.xml'/>");
  const world::Robot& r = w.robots[0];
  CHECK(r.id == "r1");
  CHECK(r.max_speed == 0.4);
  CHECK(r.leader);
  CHECK(r.body.length == 0.1);
  CHECK(r.sensors.size() == 3);
  CHECK(r.behaviors.size() == 2);
  CHECK(r.coordinator->plugin == "sum");
  CHECK(r.sensors[1].location.file == files.path("robots/two.xml"));
  CHECK(r.sensors[1].location.line == 5);
}

TEST_CASE("A robot overrides what differs from its template") {
  const Files files{{"robots/two.xml", kTwoBeams}};
  const world::World w = files.read(R"(
      <robot id="r1" template="../robots/two.xml" x="1" max_speed="0.3">
        <body width="0.12"/>
        <sensors>
          <beam id="right" yaw_deg="-30"/>
          <beam/>
          <bumper remove="true"/>
        </sensors>
        <behaviors>
          <roam speed="6"/>
          <roam id="stroll"/>
        </behaviors>
        <coordinator><sum weighted="false"/></coordinator>
      </robot>)");
  const world::Robot& r = w.robots[0];
  CHECK(r.x == 1);
  CHECK(r.max_speed == 0.3);
  CHECK(r.leader);
  CHECK(r.body.length == 0.1);
  CHECK(r.body.width == 0.12);
  REQUIRE(r.sensors.size() == 3);
  CHECK(r.sensors[0].yaw_deg == 15);
  CHECK(r.sensors[1].id == "right");
  CHECK(r.sensors[1].yaw_deg == -30);
  CHECK(std::get<double>(r.sensors[1].parameters.at("max_range")) == 2);
  CHECK(r.sensors[2].id == "beam");
  REQUIRE(r.behaviors.size() == 3);
  CHECK(std::get<double>(r.behaviors[1].parameters.at("speed")) == 6);
  CHECK(std::get<std::int64_t>(r.behaviors[1].parameters.at("patience")) == 4);
  CHECK(r.behaviors[2].id == "stroll");
  CHECK_FALSE(std::get<bool>(r.coordinator->parameters.at("weighted")));
}

TEST_CASE("Another coordinator replaces the template's") {
  const Files files{{"robots/two.xml", kTwoBeams}};
  const world::World w = files.read(
      "<robot id='r1' template='../robots/two.xml'><coordinator><pick/></coordinator></robot>");
  CHECK(w.robots[0].coordinator->plugin == "pick");
  CHECK(w.robots[0].coordinator->parameters.empty());
}

TEST_CASE("Sensors without ids differ by their default ids, also after one was removed") {
  const Files files{{"robots/ring.xml",
                     "<robot_template format='1'><sensors><beam yaw_deg='1'/><beam yaw_deg='2'/>"
                     "<beam yaw_deg='3'/></sensors></robot_template>"}};
  const world::World w = files.read(R"(
      <robot id="r1" template="../robots/ring.xml">
        <sensors><beam remove="true"/><beam id="beam_3" yaw_deg="30"/></sensors>
      </robot>)");
  REQUIRE(w.robots[0].sensors.size() == 2);
  CHECK(w.robots[0].sensors[0].id == "beam_2");
  CHECK(w.robots[0].sensors[0].yaw_deg == 2);
  CHECK(w.robots[0].sensors[1].id == "beam_3");
  CHECK(w.robots[0].sensors[1].yaw_deg == 30);
}

namespace {

const char* const kNested = R"(<robot_template format="1">
  <sensors>
    <eye sharp="true"><threshold low="0.1"/><threshold low="0.2"/><mask margin="1"/></eye>
  </sensors>
  <behaviors>
    <blend id="explore" haste="0.5">
      <rule of="roam"/>
      <behaviors>
        <roam speed="5" patience="4"/>
        <blend>
          <behaviors><roam id="deep" speed="1" patience="9"/><roam id="gone"/></behaviors>
          <coordinator><sum weighted="true"/></coordinator>
        </blend>
      </behaviors>
      <coordinator><layers id="head"><suppress by="roam" of="blend"/></layers></coordinator>
    </blend>
  </behaviors>
  <coordinator><layers><suppress by="a" of="b"/><inhibit by="c" of="d"/></layers></coordinator>
</robot_template>)";

}  // namespace

TEST_CASE("A list of nested elements replaces the template's; other lists stay") {
  const Files files{{"robots/nested.xml", kNested}};
  const world::World w = files.read(R"(
      <robot id="r1" template="../robots/nested.xml">
        <sensors><eye><threshold low="0.3"/></eye></sensors>
        <coordinator><layers><inhibit by="x" of="y"/></layers></coordinator>
      </robot>
      <robot id="r2" x="1" template="../robots/nested.xml">
        <sensors><eye sharp="false"/></sensors>
      </robot>)");
  const auto& eye = w.robots[0].sensors[0];
  CHECK(std::get<bool>(eye.parameters.at("sharp")));
  REQUIRE(eye.elements.size() == 2);
  CHECK(std::get<double>(eye.elements[0].parameters.at("low")) == 0.3);
  CHECK(eye.elements[1].element == "mask");
  CHECK(eye.elements[1].location.file == files.path("robots/nested.xml"));
  // Both kinds of link are of one list.
  REQUIRE(w.robots[0].coordinator->elements.size() == 1);
  CHECK(w.robots[0].coordinator->elements[0].element == "inhibit");
  CHECK(w.robots[1].sensors[0].elements.size() == 3);
  CHECK_FALSE(std::get<bool>(w.robots[1].sensors[0].parameters.at("sharp")));
}

TEST_CASE("What a behaviour holds is merged by ids, at any depth") {
  const Files files{{"robots/nested.xml", kNested}};
  const world::World w = files.read(R"(
      <robot id="r1" template="../robots/nested.xml">
        <behaviors>
          <blend id="explore">
            <behaviors>
              <blend>
                <behaviors>
                  <roam id="deep" speed="2"/>
                  <roam id="gone" remove="true"/>
                  <roam id="more"/>
                </behaviors>
              </blend>
            </behaviors>
            <coordinator><sum/></coordinator>
          </blend>
        </behaviors>
      </robot>)");
  const world::BehaviorUse& explore = w.robots[0].behaviors.at(0);
  CHECK(std::get<double>(explore.parameters.at("haste")) == 0.5);
  CHECK(explore.elements.size() == 1);
  const world::Coordination& inside = explore.inside.at(0);
  CHECK(inside.coordinator->plugin == "sum");  // another one replaces the template's
  CHECK(inside.coordinator->elements.empty());
  REQUIRE(inside.behaviors.size() == 2);
  CHECK(std::get<double>(inside.behaviors[0].parameters.at("speed")) == 5);
  const world::Coordination& deep = inside.behaviors[1].inside.at(0);
  CHECK(std::get<bool>(deep.coordinator->parameters.at("weighted")));
  REQUIRE(deep.behaviors.size() == 2);
  CHECK(std::get<double>(deep.behaviors[0].parameters.at("speed")) == 2);
  CHECK(std::get<std::int64_t>(deep.behaviors[0].parameters.at("patience")) == 9);
  CHECK(deep.behaviors[1].id == "more");
}

TEST_CASE("A coordinator of the same plugin overrides the template's, whatever it is called") {
  const Files files{{"robots/named.xml",
                     "<robot_template format='1'><coordinator><layers id='head'>"
                     "<inhibit by='a' of='b'/></layers></coordinator></robot_template>"}};
  const auto coordinator = [&](const std::string& content) {
    return files
        .read("<robot id='r1' template='../robots/named.xml'><coordinator>" + content +
              "</coordinator></robot>")
        .robots[0]
        .coordinator;
  };
  CHECK(coordinator("<layers/>")->id == "head");
  CHECK(coordinator("<layers/>")->elements.size() == 1);
  CHECK(coordinator("<layers id='other'/>")->id == "other");
  CHECK(coordinator("<layers id='other'/>")->elements.size() == 1);
  CHECK_FALSE(coordinator("<layers remove='true'/>"));
}

TEST_CASE("An override may replace a robot by one that has a template") {
  const Files files{{"robots/two.xml", kTwoBeams}};
  const world::World w = files.read(
      "<robot id='r1'/>", {"robot[r1]/sensor[left]/@yaw_deg=3",
                           "robot[r1]=<robot id='r1' template='../robots/two.xml' coverage='2'/>"});
  CHECK(w.robots[0].coverage == 2);
  CHECK(w.robots[0].sensors.at(0).yaw_deg == 3);
}

TEST_CASE("Files of a template's nested elements are found beside the template") {
  const Files files{{"robots/eyed.xml",
                     "<robot_template format='1'><sensors><eye><mask picture='m.txt'/></eye>"
                     "</sensors></robot_template>"},
                    {"robots/m.txt", "."}};
  const world::World w = files.read("<robot id='r1' template='../robots/eyed.xml'/>");
  const world::ElementUse& mask = w.robots[0].sensors[0].elements.at(0);
  CHECK(std::get<std::string>(mask.parameters.at("picture")) ==
        fs::canonical(files.path("robots/m.txt")).string());
  CHECK_THAT(world::write_world(w), Catch::Contains("<mask picture=\"../robots/m.txt\"/>"));
  CHECK(same(w, world::parse_world(world::write_world(w), files.path("worlds/world.xml"), host(),
                                   options())));
}

TEST_CASE("A template may give what a plugin requires") {
  const Files files{{"robots/seeker.xml",
                     "<robot_template format='1'><behaviors><seek x='1' map='map.txt'/></behaviors>"
                     "<coordinator><sum/></coordinator></robot_template>"},
                    {"robots/map.txt", "."}};
  const world::World w = files.read(
      "<robot id='r1' template='../robots/seeker.xml'><behaviors><seek priority='2'/></behaviors>"
      "</robot>");
  CHECK(std::get<double>(w.robots[0].behaviors[0].parameters.at("x")) == 1);
}

TEST_CASE("What is wrong inside of a template's behaviours is reported where it stands") {
  const Files files{{"robots/nested.xml", kNested}};
  const auto message = [&](const std::string& behaviors) -> std::string {
    try {
      files.read("<robot id='r1' template='../robots/nested.xml'><behaviors>" + behaviors +
                 "</behaviors></robot>");
      return "accepted";
    } catch (const world::WorldError& error) {
      REQUIRE(error.problems().size() == 1);
      return error.problems()[0].message;
    }
  };
  CHECK(message("<blend id='explore'><behaviors><avoid id='roam'/></behaviors></blend>") ==
        "'roam' is a <roam> in the template and a <avoid> here; use another id, and "
        "remove=\"true\" to take away the template's");
  CHECK(message("<blend id='explore'><behaviors><avoid remove='true'/></behaviors></blend>") ==
        "there is nothing to remove: the template has no 'avoid' in its <behaviors>");
  CHECK(message("<blend><behaviors><roam/><roam id='b' remove='true'/></behaviors>"
                "<coordinator><sum/></coordinator></blend>") ==
        "there is nothing to remove: the template has no 'b' in its <behaviors>");
  CHECK(message("<blend id='explore'><behaviors><roam remove='true'/><blend remove='true'/>"
                "</behaviors></blend>") ==
        "the behavior 'explore' of the robot 'r1' holds no behaviours; add <behaviors> with some");
}

TEST_CASE("A template may be based on another one, each in its own folder") {
  const Files files{{"robots/two.xml", kTwoBeams},
                    {"robots/special/fast.xml",
                     "<robot_template format='1' template='../two.xml' max_speed='2'><behaviors>"
                     "<roam song='song.txt'/></behaviors></robot_template>"},
                    {"robots/special/song.txt", "la"}};
  const world::World w = files.read("<robot id='r1' template='../robots/special/fast.xml'/>");
  CHECK(w.robots[0].max_speed == 2);
  CHECK(w.robots[0].sensors.size() == 3);
  CHECK(std::get<std::string>(w.robots[0].behaviors[1].parameters.at("song")) ==
        fs::canonical(files.path("robots/special/song.txt")).string());
}

TEST_CASE("A template may lie in a data directory") {
  const Files files{{"share/robots/two.xml", kTwoBeams}};
  world::ReadOptions reading = options();
  reading.data_directories.push_back(files.path("share"));
  const world::World w = world::parse_world(
      "<world format='1'><robots><robot id='r' template='robots/two.xml'/></robots></world>",
      "world.xml", host(), reading);
  CHECK(w.robots[0].sensors.size() == 3);
}

TEST_CASE("An override may change the template, and what came from it") {
  const Files files{{"robots/two.xml", kTwoBeams},
                    {"robots/bare.xml", "<robot_template format='1' coverage='9'/>"}};
  const std::string robot = "<robot id='r1' template='../robots/bare.xml'/>";
  const world::World w = files.read(
      robot, {"robot[r1]/sensor[left]/@yaw_deg=20", "robot[r1]/@template=../robots/two.xml"});
  CHECK(w.robots[0].sensors.at(0).yaw_deg == 20);
  CHECK(w.robots[0].coverage == 0.5);
}

TEST_CASE("A mistake in a template is reported once, where it stands") {
  const Files files{{"robots/two.xml",
                     "<robot_template format='1'>\n<body lenght='1'/>\n"
                     "<sensors><beam max_rnge='1'/></sensors></robot_template>"}};
  try {
    files.read(
        "<robot id='r1' template='../robots/two.xml'/>"
        "<robot id='r2' x='2' speed='1' template='../robots/two.xml'/>");
    FAIL("accepted");
  } catch (const world::WorldError& error) {
    const auto& found = error.problems();
    REQUIRE(found.size() == 3);
    CHECK(found[0].file == files.path("worlds/world.xml"));
    CHECK(found[1].file == files.path("robots/two.xml"));
    CHECK(found[1].line == 2);
    CHECK(found[1].message == "<body> has no attribute 'lenght'; did you mean 'length'?");
    CHECK(found[2].line == 3);
  }
}

TEST_CASE("A written world finds the files that its templates name") {
  const Files files{{"robots/singer.xml",
                     "<robot_template format='1'><behaviors><roam song='song.txt'/></behaviors>"
                     "<coordinator><pick/></coordinator></robot_template>"},
                    {"robots/song.txt", "la"},
                    {"worlds/song.txt", "another one"}};
  const auto song_in = [](const world::World& w) {
    const std::string text = world::write_world(w);
    const std::size_t at = text.find(" song=\"") + 7;
    return text.substr(at, text.find('"', at) - at);
  };
  const std::string robots = "<robots><robot id='r1' template='../robots/singer.xml'/></robots>";
  const auto parse = [&](const std::string& text, const world::ReadOptions& reading) {
    return world::parse_world(text, files.path("worlds/world.xml"), host(), reading);
  };
  const std::string world = "<world format='1'>" + robots + "</world>";
  SECTION("from the world's folder") {
    const world::World w = parse(world, options());
    CHECK(song_in(w) == "../robots/song.txt");
    CHECK(same(w, parse(world::write_world(w), options())));
  }
  SECTION("from a data directory that they lie in") {
    world::ReadOptions reading = options();
    reading.data_directories.push_back(files.path("robots/.."));
    reading.data_directories.push_back(files.path(""));
    const world::World w = parse(world, reading);
    CHECK(song_in(w) == "robots/song.txt");
    CHECK(same(w, parse(world::write_world(w), reading)));
  }
  SECTION("when the world's folder is a link to another place") {
    fs::create_directories(files.path("far/away"));
    fs::create_directory_symlink(files.path("worlds"), files.path("far/away/worlds"));
    const std::string file = files.path("far/away/worlds/world.xml");
    const std::string text = "<world format='1'><robots><robot id='r1' template='" +
                             files.path("robots/singer.xml") + "'/></robots></world>";
    const world::World w = world::parse_world(text, file, host(), options());
    CHECK(same(w, world::parse_world(world::write_world(w), file, host(), options())));
  }
  SECTION("when the world is named from the current folder") {
    const std::string file = fs::relative(files.path("worlds/world.xml")).string();
    const world::World w = world::parse_world(world, file, host(), options());
    CHECK(song_in(w) == "../robots/song.txt");
    CHECK(same(w, world::parse_world(world::write_world(w), file, host(), options())));
  }
}

TEST_CASE("Segments come from the template, and are changed, added and taken away by their ids") {
  Files files{{"robots/train.xml",
               "<robot_template format='1'><segments><segment/><segment mass='0.3'/>"
               "<segment id='tail'/></segments></robot_template>"}};
  const world::World w = files.read(R"(
      <robot id="r1" template="../robots/train.xml"/>
      <robot id="r2" y="1" template="../robots/train.xml">
        <segments>
          <segment id="segment_2" gap="0.07"/>
          <segment id="tail" remove="true"/>
          <segment id="tender" mass="0.4"/>
        </segments>
      </robot>)");
  CHECK(w.robots[0].segments.size() == 3);
  const auto& changed = w.robots[1].segments;
  REQUIRE(changed.size() == 3);
  CHECK(changed[0].id == "segment_1");
  CHECK(changed[1].mass == 0.3);
  CHECK(changed[1].gap == 0.07);
  CHECK(changed[2].id == "tender");
  CHECK(changed[2].mass == 0.4);
}
