// <drive>: what a robot stands on.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "elsie/world/footprint.h"
#include "elsie/world/parts.h"
#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

namespace {

std::string robot(const std::string& content, const std::string& id = "r1") {
  return "<robots><robot id=\"" + id + "\">" + content + "</robot></robots>";
}
const std::string kCart = robot("<drive><cart gauge=\"0.2\"/></drive>");

std::size_t wheels(const BodyPlan& plan) {
  return static_cast<std::size_t>(
      std::count_if(plan.parts.begin(), plan.parts.end(),
                    [](const Part& part) { return part.role == PartRole::wheel; }));
}

}  // namespace

TEST_CASE("A robot without a drive has two wheels and two casters") {
  const world::World world = read(robot(""));
  CHECK_FALSE(world.robots[0].drive);
  CHECK(world.robots[0].driven.parts.empty());
  const BodyPlan plan = world::plan_of(world.robots[0]);
  REQUIRE(plan.parts.size() == 5);
  CHECK(plan.parts[0].name == "chassis");
  CHECK(plan.parts[1].name == "left_wheel");
  CHECK(plan.parts[1].frame.origin == Vector3{0.0, 0.045, 0.02});
  CHECK(plan.parts[2].name == "right_wheel");
  CHECK(plan.parts[3].name == "front_caster");
  CHECK(plan.parts[4].name == "rear_caster");
}

TEST_CASE("The differential drive is in every host, and may be named") {
  const plugin::Host none;
  REQUIRE(none.find(PluginKind::drive, "differential"));
  CHECK(none.file_of(PluginKind::drive, "differential").empty());
  const world::World world = world::parse_world(
      "<world format='1'>" + robot("<drive><differential/></drive>") + "</world>", "world.xml",
      none);
  REQUIRE(world.robots[0].drive);
  CHECK(world.robots[0].drive->plugin == "differential");
  CHECK(world::plan_of(world.robots[0]).parts.size() == 5);
}

TEST_CASE("A drive says which parts the body has, and segments hang behind them") {
  const world::World world = read(
      robot("<drive><cart gauge=\"0.2\"/></drive><segments><segment id=\"tender\"/></segments>"));
  const world::Robot& r1 = world.robots[0];
  CHECK(wheels(world::driven_plan(r1)) == 4);
  const BodyPlan plan = world::plan_of(r1);
  CHECK(plan.vehicles() == 2);
  CHECK(wheels(plan) == 6);
  // The cart's wheels reach 0.12 m back, its chassis only 0.04 m.
  const auto& hitch = std::get<HitchJoint>(plan.parts[5].joint);
  CHECK(plan.parts[5].name == "tender/chassis");
  CHECK(hitch.behind == Approx(0.12 + 0.02));
  CHECK(hitch.ahead == Approx(0.02 + 0.04));
}

TEST_CASE("The area of a robot on the floor is that of its wheels, too") {
  const world::World world = read(kCart);
  const auto areas = world::footprints_of(world::plan_of(world.robots[0]), {1.0, 2.0, 0.0}, 0.0);
  REQUIRE(areas.size() == 1);
  CHECK(areas[0].half_length == Approx(0.12));
  CHECK(areas[0].half_width == Approx(0.105));
  CHECK_THAT(problems(kCart + "<obstacles><static_box x=\"0.2\" length=\"0.2\"/></obstacles>"),
             Contains("overlap"));
  CHECK(problems(robot("") + "<obstacles><static_box x=\"0.2\" length=\"0.2\"/></obstacles>")
            .empty());
}

TEST_CASE("The area of the default body is that of its chassis and its wheels") {
  const BodyPlan plan = world::plan_of(world::RobotBody{}, {});
  const auto area = world::footprints_of(plan, {1.0, 2.0, 0.5}, 0.1)[0];
  CHECK(area.half_length == Approx(0.04));
  CHECK(area.half_width == Approx(0.05));
  CHECK(area.bottom == Approx(0.1));
  CHECK(area.top == Approx(0.19));
}

TEST_CASE("A drive is written as it was read") {
  const world::World world = read(robot("<drive><cart id=\"wagon\" gauge=\"0.2\"/></drive>"));
  const std::string text = world::write_world(world);
  CHECK_THAT(text, Contains("<cart id=\"wagon\" gauge=\"0.2\"/>"));
  const world::World again = world::parse_world(text, kFolder + "world.xml", host(), options());
  CHECK(same(world, again));
  CHECK(wheels(world::plan_of(again.robots[0])) == 4);
  CHECK_THAT(world::write_world(read(robot(""))), !Contains("drive"));
}

TEST_CASE("Paths lead to a drive") {
  const auto gauge = [](const world::World& world) {
    return std::get<double>(world.robots[0].drive->parameters.at("gauge"));
  };
  CHECK(gauge(read(kCart, {"robot[r1]/drive/@gauge=0.3"})) == 0.3);
  CHECK(gauge(read(kCart, {"robot[r1]/drive/cart/@gauge=0.4"})) == 0.4);
  CHECK(read(kCart, {"robot[r1]/drive=<differential/>"}).robots[0].drive->plugin == "differential");
  CHECK_FALSE(read(kCart, {"robot[r1]/drive/@remove=true"}).robots[0].drive);
  CHECK_THAT(problems(kCart, {"robot[r1]/drive/@gauge=0"}), Contains("inside each other"));
}

TEST_CASE("A robot has its template's drive, other parameters of it, or another one") {
  const std::string file = kFolder + "on_wheels.xml";
  std::ofstream(file) << "<robot_template format=\"1\"><drive><cart gauge=\"0.2\"/></drive>"
                         "</robot_template>";
  const auto drive = [](const std::string& content) {
    return read("<robots><robot id=\"r1\" template=\"on_wheels.xml\">" + content +
                "</robot></robots>")
        .robots[0]
        .drive;
  };
  CHECK(std::get<double>(drive("")->parameters.at("gauge")) == 0.2);
  CHECK(std::get<double>(drive("<drive><cart gauge=\"0.3\"/></drive>")->parameters.at("gauge")) ==
        0.3);
  CHECK(drive("<drive><differential/></drive>")->plugin == "differential");
  std::filesystem::remove(file);
}
