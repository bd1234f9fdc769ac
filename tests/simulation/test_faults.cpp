#include <limits>

#include <catch2/catch.hpp>

#include "elsie/world/error.h"

#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using simulation::PluginFault;
using simulation::Simulation;

namespace {
/// Runs a behaviour that misbehaves in step 3.
void run(std::function<Response()> misbehave) {
  ScriptedHost scripted([&](const Perception& now) {
    return now.time_s() > 0.025 ? misbehave() : Response(MotorCommand{1, 1});
  });
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted")));
  Simulation(world, scripted.host).run();
}
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

TEST_CASE("A behaviour that throws is named, with its robot and the step") {
  CHECK_THROWS_WITH(run([]() -> Response { throw std::runtime_error("out of ideas"); }),
                    "plugin 'scripted' of robot 'r1' failed in step 3: out of ideas");
  CHECK_THROWS_AS(run([]() -> Response { throw 42; }), PluginFault);
}

TEST_CASE("So is one that answers with something that is not a finite number") {
  CHECK_THROWS_WITH(run([] {
                      return Response(MotorCommand{kNan, 0});
                    }),
                    Catch::Contains("its command is not a finite number"));
  CHECK_THROWS_AS(run([] {
                    return Response(MotorCommand{0, std::numeric_limits<double>::infinity()});
                  }),
                  PluginFault);
  CHECK_THROWS_WITH(run([] {
                      Response response;
                      response.activation = 1.5;
                      return response;
                    }),
                    Catch::Contains("its activation is 1.5"));
  CHECK_THROWS_AS(run([] {
                    Response response;
                    response.strength = kNan;
                    return response;
                  }),
                  PluginFault);
}

TEST_CASE("Observers hear the end of a run that a plugin ended") {
  struct Listener : simulation::Observer {
    int started_count = 0, steps = 0, ended_count = 0;
    void started(const Simulation&) override { ++started_count; }
    void stepped(const Simulation&) override { ++steps; }
    void ended(const Simulation&) override { ++ended_count; }
  } listener;
  ScriptedHost scripted([](const Perception& now) -> Response {
    if (now.time_s() > 0.045) {
      throw std::runtime_error("enough");
    }
    return MotorCommand{};
  });
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted")));
  Simulation simulation(world, scripted.host);
  simulation::Observer* const observers[] = {&listener};
  CHECK_THROWS_AS(simulation.run(observers), PluginFault);
  CHECK(listener.started_count == 1);
  CHECK(listener.steps == 5);
  CHECK(listener.ended_count == 1);
}

TEST_CASE("A plugin that refuses its parameters is a fault of the world file, with its line") {
  world::World world;
  auto use = behavior("avoid_obstacle", 1, models("avoid_obstacle"));
  use.parameters["left_model"] = source_path("tests/plugins/one_input.fcl");
  use.location = {"my.xml", 17};
  world.robots.push_back(robot("r1", 0, 0, 0, use));
  try {
    Simulation simulation(world, shipped());
    FAIL("was accepted");
  } catch (const world::WorldError& error) {
    REQUIRE(error.problems().size() == 1);
    CHECK(error.problems()[0].file == "my.xml");
    CHECK(error.problems()[0].line == 17);
    CHECK_THAT(error.problems()[0].message, Catch::Contains("must have the two inputs"));
  }
}
