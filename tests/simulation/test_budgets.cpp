// What a plugin may take.
#include <chrono>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "wheels.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::wheels;
using simulation::PluginFault;
using simulation::Simulation;

namespace {

simulation::Options with(const simulation::Budget& budget) {
  simulation::Options options;
  options.budget = budget;
  return options;
}

}  // namespace

TEST_CASE("Who takes longer than the time budget is named, not who asked it") {
  ScriptedHost scripted([](const Perception& now) {
    if (now.time_s() > 0.025) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    }
    return wheels(1, 1);
  });
  Simulation simulation(one_robot(), scripted.host, with({.time_s = 1.2, .memory = 0}));
  CHECK_THROWS_WITH(
      simulation.run(),
      Catch::Contains("plugin 'scripted' of robot 'r1' failed in step 3 (at 0.03 s): it took ") &&
          Catch::Contains(" ms to answer, which is beyond its time budget of 1200 ms"));
}

TEST_CASE("A leak meets the memory budget; what is freed or replaced does not") {
  std::vector<std::vector<char>> kept;
  bool leaks = false;
  ScriptedHost scripted([&](const Perception&) {
    std::vector<char> some(2000);  // malloc() keeps freed blocks up to 1032 bytes, uncounted
    Response response;
    response.events.push_back({"hello"});  // allocated here, freed by the next answer
    if (leaks) {
      kept.push_back(std::move(some));
    }
    return response;
  });
  kept.reserve(1000);
  Simulation simulation(one_robot(), scripted.host, with({.time_s = 0.0, .memory = 40'000}));
  CHECK_NOTHROW(simulation.run());
  leaks = true;
  simulation.reset();
  try {
    simulation.run();
    FAIL("nobody minds");
  } catch (const PluginFault& fault) {
    CHECK(fault.plugin == "scripted");
    CHECK(fault.step > 10);
    CHECK(fault.step < 25);
    CHECK_THAT(fault.what(), Catch::Contains("it holds 0.04") &&
                                 Catch::Contains("beyond its memory budget of 0.04 MB"));
  }
  // The next run begins with nothing held.
  kept.clear();
  leaks = false;
  simulation.reset();
  CHECK_NOTHROW(simulation.run());
}

TEST_CASE("An edit that is refused does not hide a leak") {
  std::vector<std::vector<char>> kept;
  kept.reserve(1000);
  ScriptedHost scripted([&](const Perception&) {
    kept.emplace_back(1000);
    return Response();
  });
  Simulation simulation(one_robot(), scripted.host, with({.time_s = 0.0, .memory = 20'000}));
  const auto run = [&] {
    for (int step = 0; step < 60; ++step) {
      // A wall through the robot.
      CHECK_THROWS_AS(simulation.edit("obstacle[+]", "<static_box length=\"1\"/>"),
                      simulation::EditRefused);
      simulation.step();
    }
  };
  CHECK_THROWS_AS(run(), PluginFault);
}
