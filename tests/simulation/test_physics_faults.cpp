// What the physics cannot do is said: before a run, after it, or as the fault that ends it.
#include <filesystem>
#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/simulation/simulation.h"
#include "elsie/world/error.h"
#include "elsie/world/reader.h"
#include "elsie/world/warnings.h"

#include "places.h"
#include "shipped.h"

using namespace elsie;
using Catch::Contains;
using simulation::PhysicsFault;

namespace {

std::string robot(const std::string& body, const std::string& behavior,
                  const std::string& attributes = "") {
  return "<robots>\n<robot id='r1' " + attributes + "><body " + body + "/><behaviors><" + behavior +
         "/></behaviors><coordinator><arbiter_suppression/></coordinator></robot></robots>\n";
}

/// The physics stands on line 2, the robot on line 4.
std::string world_of(const std::string& physics, const std::string& rest,
                     const std::string& arena = "length='4' width='4'") {
  return "<world format='1'><arena " + arena + "/>\n<physics " + physics + "/>\n" + rest +
         "<limits time='10'/></world>";
}

world::World read(const std::string& text) {
  return world::parse_world(text, "a.xml", test::shipped());
}

std::string fault(const std::string& text) {
  simulation::Simulation run(read(text), test::shipped());
  try {
    run.run();
  } catch (const PhysicsFault& caught) {
    CHECK(caught.step == run.steps());
    return caught.what();
  }
  return "none";
}

const std::string kWander = "wander speed='20'";

}  // namespace

TEST_CASE("A robot that sinks through a floor that is too soft ends the run") {
  const std::string text = world_of("cfm='0.001'", robot("mass='1000' wheel_torque='10'", kWander));
  CHECK_THAT(fault(text), Contains("the physics failed after 0.") &&
                              Contains("the robot 'r1' (a.xml:4) is below the floor") &&
                              Contains("cause: the robot 'r1' weighs 1.04e+03 kg") &&
                              Contains("sinks through the floor"));
  CHECK_THAT(fault(world_of("kp='1000' kd='100'", robot("mass='1000' wheel_torque='10'", kWander))),
             Contains("below the floor") && Contains("from kp and kd"));
}

TEST_CASE("A robot that is faster than its wheels can make it ends the run") {
  const std::string text = world_of(
      "", robot("wheel_torque='100'", "go_to_point x='400' y='0' speed='20'", "max_speed='20'"),
      "length='1000' width='1000'");
  CHECK_THAT(fault(text), Contains("the robot 'r1' (a.xml:4) moves at ") &&
                              Contains("where nothing can make it faster than 53.") &&
                              Contains("cause: the robot 'r1'"));
}

TEST_CASE("A robot that gets out of the arena ends the run") {
  CHECK_THAT(fault(world_of("", robot("height='10' mass='10' wheel_torque='10000'", kWander))),
             Contains("the robot 'r1' (a.xml:4) is outside of the arena's walls") &&
                 Contains("cause: the robot 'r1'"));
  const std::string ram =
      "<obstacles><moving_box id='ram' x='0' y='0' length='1' width='3' speed='100'><waypoint "
      "x='1.9' y='0'/></moving_box></obstacles>";
  CHECK_THAT(fault(world_of("", ram + robot("", "go_to_point x='1.8' y='0' speed='1'", "x='1.8'"))),
             Contains("outside of the arena's walls") && Contains("the box 'ram' ") &&
                 Contains("likely cause: "));
}

TEST_CASE("Steps in which the solver gave up are counted and reported") {
  const std::string obstacles = "<obstacles><dynamic_box x='-0.3' y='0' mass='0.01'/></obstacles>";
  const std::string two =
      "<robots><robot id='r1'><behaviors><wander speed='20'/></behaviors><coordinator>"
      "<arbiter_suppression/></coordinator></robot><robot id='r2' x='0.3'><behaviors><go_to_point "
      "x='-1' y='0' speed='1'/></behaviors><coordinator><arbiter_suppression/></coordinator>"
      "</robot></robots>";
  simulation::Simulation run(read(world_of("cfm='0' friction='1000'", obstacles + two)),
                             test::shipped());
  const simulation::RunResult result = run.run();
  CHECK(result.solver.gave_up > 100);
  CHECK(result.solver.gave_up <= result.steps);
  CHECK(result.solver.unsolved <= result.solver.gave_up);
  CHECK(result.solver.since_s > 0.0);
  REQUIRE(result.notes.size() == 2);
  CHECK(result.notes[0].plugin == simulation::kPhysicsNotes);
  CHECK_THAT(result.notes[0].text, Contains("a.xml:2: warning: cfm is 0"));
  CHECK_THAT(result.notes[1].text,
             Contains("gave up in " + std::to_string(result.solver.gave_up) + " of 1000 steps") &&
                 Contains("likely cause: cfm is 0"));
}

TEST_CASE("A run in which the solver found everything says nothing of it") {
  simulation::Simulation run(read(world_of("", robot("", kWander))), test::shipped(),
                             {.time_limit_s = 2.0});
  const simulation::RunResult result = run.run();
  CHECK(result.solver.gave_up == 0);
  CHECK(result.solver.since_s == 0.0);
  CHECK(result.notes.empty());
}

TEST_CASE("Sizes and masses that are lost in rounding are refused with a sentence") {
  const auto problem = [](const std::string& text) -> std::string {
    try {
      read(text);
    } catch (const world::WorldError& error) {
      return error.what();
    }
    return "none";
  };
  CHECK_THAT(problem(world_of("",
                              "<obstacles>\n<dynamic_box x='0.3' length='1e-300' width='1e-300' "
                              "height='1e-300' mass='1e-300'/></obstacles>")),
             Contains("a.xml:4: ") && Contains("1e-04") && Contains("1e-06"));
  CHECK_THAT(problem(world_of("", robot("mass='1e-12' wheel_mass='1e-300'", kWander))),
             Contains("a.xml:4: ") && Contains("wheel_mass"));
}

TEST_CASE("No shipped world has a warning") {
  for (const auto& file : std::filesystem::directory_iterator(test::source_path("worlds"))) {
    if (file.path().extension() != ".xml") continue;
    world::ReadOptions options;
    options.data_directories = {test::source_path("")};
    const world::World world = world::read_world(file.path().string(), test::shipped(), options);
    INFO(file.path());
    for (const world::Warning& warning : world::warnings(world)) FAIL_CHECK(warning.text());
  }
}
