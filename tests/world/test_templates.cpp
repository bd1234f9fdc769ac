// Robots that are mostly described in another file.
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <utility>

#include <catch2/catch.hpp>

#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
namespace fs = std::filesystem;

namespace {

// A folder of files for one test, with the world in worlds/.
class Files {
 public:
  Files(std::initializer_list<std::pair<std::string, std::string>> files) {
    fs::remove_all(folder_);
    for (const auto& [name, text] : files) {
      fs::create_directories((folder_ / name).parent_path());
      std::ofstream(folder_ / name) << text;
    }
  }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  ~Files() { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  world::World read(const std::string& robots, std::vector<std::string> overrides = {}) const {
    fs::create_directories(folder_ / "worlds");
    return world::parse_world("<world format='1'><robots>" + robots + "</robots></world>",
                              path("worlds/world.xml"), host(), options(std::move(overrides)));
  }

 private:
  fs::path folder_ = ELSIE_BINARY_DIR "/template_files";
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

TEST_CASE("Sensors without ids are told apart by their default ids, also after one was removed") {
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
