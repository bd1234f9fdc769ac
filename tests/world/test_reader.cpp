// What a world file says, and what it need not say.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <catch2/catch.hpp>

#include "elsie/shapes/obstacle_shapes.h"
#include "elsie/world/colours.h"

#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

TEST_CASE("An empty world has the default of everything") {
  const world::World world = read("");
  const world::World none;
  for (const char* part : {"arena", "physics", "limits", "learning"}) {
    CHECK(world::same_part(world::vocabulary(), part, &world, &none));
  }
  CHECK(world.robots.empty());
  CHECK(world.obstacles.empty());
  REQUIRE(world.teams.size() == 2);
  CHECK(world.teams[0].id == "red");
  CHECK(world.teams[1].id == "blue");
}

TEST_CASE("A line at the top may lead editors to the schema") {
  const std::string top = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  const std::string model = "<?xml-model href=\"world.xsd\"?>\n";
  const std::string world = "<world format=\"1\" name=\"led\"/>\n";
  for (const std::string& text :
       {top + model + world, model + world, top + "<!-- first -->\n" + model + world}) {
    CAPTURE(text);
    CHECK(world::parse_world(text, kFolder + "led.xml", host(), options()).name == "led");
  }
}

TEST_CASE("A world says everything") {
  const world::World w = world::read_world(kFolder + "data/everything.xml", host(), options());
  CHECK(w.name == "Everything & more");
  CHECK(w.description == "Two lines,\nwith \"quotes\" and ünïcode");
  CHECK(w.file == kFolder + "data/everything.xml");
  CHECK(w.arena.length == 12);
  CHECK_FALSE(w.arena.walls);
  CHECK(w.physics.parameters.at("kp") == ParameterValue(20000.0));
  CHECK(w.physics.control_steps == 4);

  REQUIRE(w.teams.size() == 3);
  CHECK(w.teams[1].colour == world::Colour{0, 0, 255});
  CHECK(w.teams[2].id == "green");

  // Obstacles in file order, then resources, whatever stands first in the file.
  REQUIRE(w.obstacles.size() == 13);
  CHECK(w.obstacles[0].id == "patrol");
  CHECK(w.obstacles[0].kind == world::ObstacleKind::moving);
  CHECK_FALSE(w.obstacles[0].round_trip);
  REQUIRE(w.obstacles[0].waypoints.size() == 2);
  CHECK(w.obstacles[0].waypoints[1] == Vector2{2, 3.25});
  CHECK(w.obstacles[1].id == "static_box_1");
  CHECK(w.obstacles[1].colour == world::Colour{0x12, 0x34, 0x56});
  CHECK(w.obstacles[2].kind == world::ObstacleKind::dynamic);
  CHECK(w.obstacles[2].mass == 0.123456789012345);
  CHECK(w.obstacles[3].id == "static_box_2");
  CHECK(w.obstacles[4].id == "moving_box_2");
  CHECK(w.obstacles[5].shape == ObstacleShape::cylinder);
  CHECK(w.obstacles[5].radius == 0.15);
  CHECK(w.obstacles[6].id == "static_prism_1");
  CHECK(w.obstacles[6].shape == ObstacleShape::prism);
  CHECK(w.obstacles[6].points == std::vector<Vector2>{{0, 0}, {0.7, 0.1}, {0.2, 0.5}});
  CHECK(w.obstacles[8].kind == world::ObstacleKind::moving);
  CHECK(w.obstacles[10].points.size() == 4);
  CHECK(w.obstacles[10].waypoints.size() == 1);
  CHECK(w.obstacles[11].kind == world::ObstacleKind::resource);
  CHECK(w.obstacles[11].team == "green");
  CHECK(w.obstacles[11].energy == 12.5);
  CHECK(w.obstacles[12].id == "resource_2");
  CHECK(w.chargers.at(1).id == "charger_2");

  REQUIRE(w.robots.size() == 2);
  const world::Robot& r = w.robots[0];
  CHECK(r.location.line == 52);
  CHECK(r.leader);
  CHECK(r.energy == 50.0);
  CHECK(r.body.axle == 0.11);
  REQUIRE(r.sensors.size() == 4);
  CHECK(r.sensors[0].id == "beam");
  CHECK(r.sensors[0].pitch_deg == -3);
  CHECK(r.sensors[0].z == 0.03);
  CHECK(std::get<double>(r.sensors[0].parameters.at("max_range")) == 1.5);
  CHECK(r.sensors[1].id == "beam_2");
  CHECK_FALSE(r.sensors[1].x);
  CHECK(r.sensors[1].parameters.empty());
  CHECK(r.sensors[2].plugin == "bumper");
  REQUIRE(r.behaviors.size() == 4);
  CHECK(r.behaviors[0].priority == 2.5);
  CHECK(r.behaviors[1].id == "stroll");
  CHECK(std::get<std::int64_t>(r.behaviors[1].parameters.at("patience")) == 7);
  CHECK(std::get<bool>(r.behaviors[1].parameters.at("shy")));
  CHECK(std::get<std::string>(r.behaviors[1].parameters.at("motto")) == "slow < steady");
  CHECK(std::get<std::vector<double>>(r.behaviors[1].parameters.at("weights")) ==
        std::vector<double>{0.1, -0.002, 3});
  CHECK(r.behaviors[2].id == "roam");
  CHECK(r.coordinator->id == "head");

  REQUIRE(w.goals.size() == 13);
  CHECK(std::get<world::ReachGoal>(w.goals[2]).radius == 0.4);
  CHECK(std::get<world::ReachGoal>(w.goals[3]).of == "r1");
  CHECK(std::get<world::TravelGoal>(w.goals[7]).robot == "r2");
  CHECK(w.limits.wall_time == 10.0);
}

namespace {

/// The hue of a colour with one, in degrees.
double hue_deg(const Colour& c) {
  const double high = std::max({c.red, c.green, c.blue}), low = std::min({c.red, c.green, c.blue});
  REQUIRE(high > low);
  const double hue = c.red == high     ? 60 * (c.green - c.blue) / (high - low)
                     : c.green == high ? 120 + 60 * (c.blue - c.red) / (high - low)
                                       : 240 + 60 * (c.red - c.green) / (high - low);
  return hue < 0 ? hue + 360 : hue;
}

double apart_deg(double a, double b) { return std::abs(std::remainder(a - b, 360.0)); }

}  // namespace

TEST_CASE("A team without a colour gets one of a hue that nothing else in the world has") {
  const world::World w = read(
      "<teams><team id='crew'/><team id='rivals' colour='#20b0b0'/><team id='third'/></teams>");
  REQUIRE(w.teams.size() == 5);
  CHECK(w.teams[2].colour == world::Colour{0xb8, 0x30, 0xd0});  // the first is violet
  CHECK(w.teams[3].colour == world::Colour{0x20, 0xb0, 0xb0});  // given, so kept
  REQUIRE(w.teams[4].colour);
  // The same file, the same colours; another one where the violet is taken already.
  CHECK(read("<teams><team id='x'/></teams>").teams[2].colour == w.teams[2].colour);
  const world::World taken =
      read("<resources><resource colour='#b830d0'/></resources><teams><team id='x'/></teams>");
  CHECK(apart_deg(hue_deg(*taken.teams[2].colour), hue_deg({0xb8, 0x30, 0xd0})) > 30);
}

TEST_CASE("Ten teams without colours differ in their hues, and from all else") {
  std::string teams;
  for (int i = 0; i < 10; ++i) {
    teams += "<team id='t" + std::to_string(i) + "'/>";
  }
  const world::World w = read("<teams>" + teams + "</teams>");
  std::vector<double> hues{hue_deg(world::kResourceOfNoTeam), hue_deg(world::kChargerColour)};
  for (const world::Team& team : w.teams) {
    REQUIRE(team.colour);
    for (const double other : hues) {
      CAPTURE(team.id, hue_deg(*team.colour), other);
      CHECK(apart_deg(hue_deg(*team.colour), other) > 20);  // twice a camera's tolerance
    }
    hues.push_back(hue_deg(*team.colour));
  }
  CHECK(hues.size() == 14);
}

TEST_CASE("Red and blue stay red and blue when they are named without a colour") {
  const world::World w = read("<teams><team id='blue'/><team id='red'/></teams>");
  REQUIRE(w.teams.size() == 2);
  CHECK(w.teams[0].colour == world::kRedTeam);
  CHECK(w.teams[1].colour == world::kBlueTeam);
}

TEST_CASE("File parameters are absolute paths of files that exist") {
  const world::World w = world::read_world(kFolder + "data/everything.xml", host(), options());
  const std::string data = std::filesystem::canonical(kFolder + "data").string();
  SECTION("beside the file that names them") {
    CHECK(std::get<std::string>(w.robots[0].behaviors[1].parameters.at("song")) ==
          data + "/songs/one.txt");
  }
  SECTION("defaults in a data directory") {
    CHECK(std::get<std::string>(w.robots[0].behaviors[0].parameters.at("model")) ==
          data + "/fuzzy_models/avoid.fcl");
  }
  SECTION("else in a data directory") {
    const world::World other = read(R"(<robots><robot id="r"><behaviors>
        <roam song="songs/one.txt"/></behaviors><coordinator><pick/></coordinator></robot></robots>)");
    CHECK(std::get<std::string>(other.robots[0].behaviors[0].parameters.at("song")) ==
          data + "/songs/one.txt");
  }
}

TEST_CASE("All mistakes of a file are reported, in the order of their lines") {
  CHECK(problems("\n<limits time='-1'/>\n"
                 "<robots>\n"
                 "<robot id='r1' team='gren' x='0' paint='red'>\n"
                 "<behaviors><raom/><roam speed='x'/></behaviors></robot>\n"
                 "<robot id='r1' x='20'/>\n"
                 "</robots>\n"
                 "<arena length='nan'\n walls='maybe'/>") ==
        "world.xml:2: time=\"-1\" of <limits>: expected a number above 0 and at most 1e+09 s\n"
        "world.xml:4: <robot> has no attribute 'paint'; it may have: id, template, team, colour, "
        "x, y, z, "
        "heading_deg, max_speed, coverage, leader, battery, energy\n"
        "world.xml:4: team=\"gren\" of <robot>: there is no such team; there are: red, blue\n"
        "world.xml:5: there is no behavior 'raom'; did you mean 'roam'?\n"
        "world.xml:5: speed=\"x\" of <roam>: expected a number at least 0 and at most 50 rad/s\n"
        "world.xml:6: a second robot with the id 'r1'; the first is there already (line 4)\n"
        "world.xml:8: length=\"nan\" of <arena>: expected a number at least 1e-04 and at most "
        "10000 m\n"
        "world.xml:9: walls=\"maybe\" of <arena>: expected true or false");
}

TEST_CASE("A mistake is not reported again as what follows from it") {
  // With x at its default, the robot would stand in the box.
  CHECK(problems("<obstacles><static_box/></obstacles><robots><robot id='r' x='a'/></robots>") ==
        "world.xml:1: x=\"a\" of <robot>: expected a number at least -10000 and at most 10000 m");
  // Whether a sensor that is not known makes the readings is not known.
  CHECK(problems("<robots><robot id='r'><sensors><beem/></sensors><behaviors><avoid/></behaviors>"
                 "<coordinator><pick/></coordinator></robot></robots>") ==
        "world.xml:1: there is no sensor 'beem'; did you mean 'beam'?");
}

TEST_CASE("A robot with a bad id and unknown plugins is refused like any other") {
  const std::string bad_id =
      "world.xml:1: id=\"1 bad\" of <robot>: expected a name that starts with a letter or '_' and "
      "goes on with letters, digits, '_', '-' or '.'\n";
  const auto with = [](const std::string& parts) {
    return problems("<robots><robot id='1 bad'>" + parts + "</robot></robots>");
  };
  CHECK(with("<behaviors><raom/></behaviors><coordinator><pick/></coordinator>") ==
        bad_id + "world.xml:1: there is no behavior 'raom'; did you mean 'roam'?");
  CHECK(with("<behaviors><roam/></behaviors><coordinator><pikc/></coordinator>") ==
        bad_id + "world.xml:1: there is no coordinator 'pikc'; did you mean 'pick'?");
  CHECK(with("<sensors><beem/></sensors><behaviors><avoid/></behaviors>"
             "<coordinator><pick/></coordinator>") ==
        bad_id + "world.xml:1: there is no sensor 'beem'; did you mean 'beam'?");
  SECTION("what is known of it is judged all the same") {
    CHECK(with("<behaviors><avoid/></behaviors>") ==
          bad_id +
              "world.xml:1: this robot has behaviours but no coordinator; add a <coordinator>\n"
              "world.xml:1: 'avoid' needs readings of the kind 'range', but this robot has no "
              "sensor that makes them; add <beam>");
  }
  SECTION("an unknown plugin of another robot with the same id is no excuse") {
    CHECK(problems("<robots><robot id='r'><sensors><beem/></sensors></robot>\n"
                   "<robot id='r' x='1'><behaviors><roam/></behaviors></robot></robots>") ==
          "world.xml:1: there is no sensor 'beem'; did you mean 'beam'?\n"
          "world.xml:2: a second robot with the id 'r'; the first is there already (line 1)\n"
          "world.xml:2: the robot 'r' has behaviours but no coordinator; add a <coordinator>");
  }
}

TEST_CASE("Where nothing can be meant, no empty list is offered") {
  CHECK(problems("<goals><travel robot='r1'/></goals>") ==
        "world.xml:1: robot=\"r1\" of <travel>: there is no such robot; the world has none");
  CHECK_THAT(problems("<robots><robot id='1 bad'/></robots><goals><travel robot='r1'/></goals>"),
             Catch::EndsWith("robot=\"r1\" of <travel>: there is no such robot; the world has none "
                             "with a valid id"));
}

TEST_CASE("Mistakes in different parts of one robot are all reported") {
  CHECK(problems("<robots><robot id='r' x='4.99'><sensors><beam max_range='0'/></sensors></robot>"
                 "</robots>") ==
        "world.xml:1: max_range=\"0\" of <beam>: expected a number above 0 and at most 100 m\n"
        "world.xml:1: the robot 'r' reaches 0.03 m into the east wall");
}

TEST_CASE("An error holds each problem with its file and line") {
  try {
    read("\n<arena lenght='3'/>");
    FAIL("accepted");
  } catch (const world::WorldError& error) {
    REQUIRE(error.problems().size() == 1);
    CHECK(error.problems()[0].file == kFolder + "world.xml");
    CHECK(error.problems()[0].line == 2);
    CHECK(error.problems()[0].message ==
          "<arena> has no attribute 'lenght'; did you mean 'length'?");
  }
}

TEST_CASE("What may stand where") {
  SECTION("static boxes may overlap one another and the walls: mazes are built so") {
    CHECK(problems("<obstacles><static_box x='1'/><static_box x='1.1'/><static_box x='5'/>"
                   "</obstacles>") == "");
  }
  SECTION("what touches does not overlap") {
    CHECK(problems("<obstacles><static_box x='1'/><dynamic_box x='1.2'/></obstacles>") == "");
  }
  SECTION("turned boxes are judged by their corners") {
    const std::string robot = "<robots><robot id='r' x='0.18' y='0.18'/></robots>";
    CHECK(problems("<obstacles><static_box heading_deg='45'/></obstacles>" + robot) == "");
    CHECK_THAT(problems("<obstacles><static_box length='0.3' width='0.3'/></obstacles>" + robot),
               Contains("the robot 'r' overlaps the box 'static_box_1' (line 1)"));
  }
  SECTION("cylinders and prisms are judged by their own outlines") {
    const std::string robot = "<robots><robot id='r' x='0.15' y='0.15'/></robots>";
    // The nearest corner of the robot's outline is at (0.11, 0.1).
    CHECK(problems("<obstacles><static_cylinder radius='0.1486'/></obstacles>" + robot) == "");
    CHECK_THAT(problems("<obstacles><static_cylinder radius='0.1487'/></obstacles>" + robot),
               Contains("the robot 'r' overlaps the cylinder 'static_cylinder_1' (line 1)"));
    const std::string prism =
        "<point x='0' y='0'/><point x='0.3' y='0'/><point x='0' y='0.3'/></dynamic_prism>"
        "</obstacles>";
    CHECK(problems("<obstacles><dynamic_prism id='p'>" + prism + robot) == "");
    CHECK(problems("<obstacles><dynamic_prism id='p' x='4.8' y='4'>" + prism) == "");
    CHECK_THAT(problems("<obstacles><dynamic_prism id='p' x='4.81' y='4'>" + prism),
               Contains("the prism 'p' reaches 0.01 m into the east wall"));
    CHECK(problems("<obstacles><dynamic_prism id='p' x='-4.9' y='4'>" + prism) == "");
    CHECK_THAT(problems("<obstacles><dynamic_prism id='p' x='-4.91' y='4'>" + prism),
               Contains("the prism 'p' reaches 0.01 m into the west wall"));
  }
  SECTION("a bridge may stand over a robot") {
    CHECK(
        problems("<obstacles><static_box z='0.2'/></obstacles><robots><robot id='r'/></robots>") ==
        "");
  }
  SECTION("without walls there is none to stand in") {
    CHECK(problems("<arena walls='false'/><robots><robot id='r' x='4.99'/></robots>") == "");
  }
}

TEST_CASE("Default ids keep clear of those that are given") {
  const world::World w = read(
      "<obstacles><static_box x='1'/><static_box id='static_box_1' x='2'/><static_box x='3'/>"
      "</obstacles>");
  CHECK(w.obstacles[0].id == "static_box_2");
  CHECK(w.obstacles[1].id == "static_box_1");
  CHECK(w.obstacles[2].id == "static_box_3");
}

TEST_CASE("What plugins say of their parameters is heard only when asked for") {
  const std::string text =
      "<world format='1'><robots><robot id='r'><behaviors><roam shy='true' mood='bold'/>"
      "</behaviors><coordinator><pick/></coordinator></robot></robots></world>";
  world::ReadOptions trusting = options();
  trusting.check_plugins = false;
  CHECK_NOTHROW(world::parse_world(text, "world.xml", host(), trusting));
  CHECK_THROWS_WITH(world::parse_world(text, "world.xml", host(), options()),
                    "world.xml:1: behavior 'roam': shy and bold do not go together");
}

TEST_CASE("Markup that is unusual but right is accepted") {
  CHECK_NOTHROW(
      world::parse_world("\xEF\xBB\xBF<?xml version='1.0' encoding='utf-8'?>\r\n"
                         "<?xml-model href='world.xsd'?><!-- a --><world\r\n format = '1'"
                         " name='&#x41;&lt;&gt;'><![CDATA[ ]]></world ><!-- b -->\n",
                         "world.xml", host()));
}
