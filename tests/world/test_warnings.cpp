// Settings that are allowed, but that the physics can hardly keep up with.
#include <catch2/catch.hpp>

#include "elsie/world/warnings.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;
using Catch::EndsWith;

namespace {

/// All warnings about such a world, a line each, without the folder.
std::string warned(const std::string& content, std::vector<std::string> overrides = {}) {
  std::string text;
  for (const world::Warning& warning : world::warnings(read(content, std::move(overrides)))) {
    text += warning.text() + '\n';
  }
  for (std::size_t at; (at = text.find(kFolder)) != std::string::npos;) {
    text.erase(at, kFolder.size());
  }
  return text;
}

std::string a_robot(const std::string& body, const std::string& attributes = "") {
  return "<robots>\n<robot id='r1' " + attributes + "><body " + body + "/></robot></robots>";
}

}  // namespace

TEST_CASE("A world of defaults has no warning") {
  CHECK(warned("").empty());
  CHECK(
      warned(a_robot("") +
             "<obstacles><dynamic_box x='1'/><moving_box y='2'><waypoint x='3' y='2'/></moving_box>"
             "</obstacles>")
          .empty());
}

TEST_CASE("Rigid contacts, and corrections all at once") {
  CHECK_THAT(warned("\n<physics cfm='0'/>"),
             Contains("world.xml:2: warning: cfm is 0: contacts are rigid"));
  CHECK_THAT(warned("", {"physics/@cfm=0"}), Contains("warning: cfm is 0"));
  CHECK_THAT(warned("<physics erp='1'/>"), Contains("erp is 1: ") && Contains("0.1 to 0.8"));
  CHECK_THAT(warned("<physics erp='0.001'/>"), Contains("erp is 0.001: ") && Contains("hardly"));
  CHECK(warned("<physics cfm='1e-7' erp='0.8'/>").empty());
}

TEST_CASE("Settings of soft contacts on an engine that has none") {
  CHECK_THAT(warned("\n<physics engine='planar' cfm='0.001'/>"),
             Contains("world.xml:2: warning: cfm=\"0.001\" has no effect") &&
                 Contains("'planar'") && Contains("an engine that has it: ode"));
  CHECK(warned("<physics engine='planar' kp='1000' kd='10'/>").empty());  // they make an erp
  CHECK(warned("<physics engine='planar' erp='0.5' bounce='0.3'/>").empty());
}

TEST_CASE("What is too much for steps in the plane") {
  const std::string planar = "<physics engine='planar'/>";
  CHECK_THAT(
      warned(planar + "\n<robots>\n<robot id='r1' max_speed='100'/></robots>"),
      Contains("world.xml:3: warning: the robot 'r1' moves up to 1 m in a step at 100 m/s") &&
          Contains("stays behind"));
  CHECK_THAT(warned(planar + "\n<obstacles><moving_box id='ram' length='1'>"
                             "<waypoint x='4.8' y='0'/></moving_box></obstacles>"),
             Contains("the box 'ram' reaches into a wall at (4.8, 0), and ends the run"));
  CHECK_THAT(warned(planar + a_robot("height='10'")),
             Contains("would topple") && Contains("upright"));
  CHECK_THAT(warned("<physics engine='planar' erp='0.001'/>"), Contains("hardly moved apart"));
  CHECK(warned("<physics engine='planar' step='0.01'/>").empty());
  CHECK_THAT(warned("<physics engine='planar' step='0.1'/>"),
             Contains("a step of 0.1 s in 10 equal parts"));
}

TEST_CASE("A wheel slip of 0 matters where robots pull something") {
  const std::string train =
      "<robots><robot id='r1'><segments><segment/></segments></robot></robots>";
  CHECK_THAT(warned("<physics wheel_slip='0'/>" + train), Contains("wheel_slip is 0: "));
  CHECK(warned("<physics wheel_slip='0'/>" + a_robot("")).empty());
}

TEST_CASE("Contacts that are too soft for a weight") {
  CHECK_THAT(warned("<physics cfm='0.001'/>" + a_robot("mass='1000'")),
             Contains("world.xml:2: warning: the robot 'r1' weighs 1.04e+03 kg, under which it "
                      "sinks through the floor: contacts are too soft, with a cfm of 0.001"));
  CHECK_THAT(warned("<physics cfm='0.1'/><obstacles><dynamic_box x='1' mass='10'/></obstacles>"),
             Contains("the box 'dynamic_box_1' weighs 10 kg"));
  CHECK_THAT(warned("<physics kp='1000' kd='100'/>" + a_robot("mass='1000'")),
             Contains("from kp and kd"));
}

TEST_CASE("What the warning about softness expects has no warning") {
  const std::string heavy = a_robot("mass='10' wheel_mass='1'");
  const std::string text = warned("<physics cfm='0.01'/>" + heavy);
  const std::string before = "expected at most ";
  REQUIRE_THAT(text, Contains(before));
  const double most = std::stod(text.substr(text.find(before) + before.size()));
  CHECK(warned("<physics cfm='" + std::to_string(0.9 * most) + "'/>" + heavy).empty());
}

TEST_CASE("Motors that turn the robot over, or their wheels in no time") {
  CHECK_THAT(warned(a_robot("wheel_torque='100'")),
             Contains("has motors of 100 N m, and its weight holds only 0.03"));
  CHECK_THAT(warned(a_robot("wheel_mass='1e-5'")),
             Contains("bring a wheel of 1e-05 kg to ") && Contains("in one step"));
}

TEST_CASE("Masses that are too unlike") {
  CHECK_THAT(warned("<physics cfm='1e-8'/>" + a_robot("mass='1000' wheel_mass='0.01'")),
             Contains("the chassis of the robot 'r1' weighs 1e+03 kg and each wheel 0.01 kg"));
  CHECK_THAT(warned("<obstacles><dynamic_box x='1' mass='1e-5'/></obstacles>" + a_robot("")),
             Contains("weighs 1e-05 kg and the robot 'r1' 0.204 kg"));
}

TEST_CASE("Speeds that cross a body in one step") {
  CHECK_THAT(warned(a_robot("", "max_speed='20'")),
             Contains("the robot 'r1' moves up to 0.2 m in a step at 20 m/s") &&
                 Contains("expected a step of at most 0.002 s"));
  CHECK(warned("<physics step='0.002'/>" + a_robot("", "max_speed='20'")).empty());
  CHECK_THAT(warned("<obstacles><moving_box speed='50'><waypoint x='1' y='0'/></moving_box>"
                    "</obstacles>"),
             Contains("moves up to 0.5 m in a step"));
}

TEST_CASE("Moving boxes that reach into walls, walls that wheels roll over, robots that topple") {
  CHECK_THAT(warned("<obstacles>\n<moving_box id='ram' length='1'><waypoint x='4.8' y='0'/>"
                    "</moving_box></obstacles>"),
             Contains("world.xml:2: warning: the box 'ram' reaches into a wall at (4.8, 0)"));
  CHECK_THAT(warned("\n<arena wall_height='0.01'/>" + a_robot("")),
             Contains("world.xml:2: warning: the walls are 0.01 m high"));
  CHECK_THAT(warned(a_robot("height='10'")), Contains("and topples"));
}
