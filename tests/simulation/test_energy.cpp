#include <catch2/catch.hpp>

#include "wheels.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::wheels;
using simulation::Simulation;

namespace {
world::World with_charger(double start_energy) {
  world::World world = one_robot();
  world.robots[0].energy = start_energy;
  world.robots[0].sensors.push_back(beam("a", 0));
  world.chargers.emplace_back();
  world.chargers[0].team = "red";
  world.chargers[0].x = 0.05;
  world.limits.time = 5;
  return world;
}
}  // namespace

TEST_CASE("Every sensor costs its energy per second") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  world::World world = one_robot();
  world.robots[0].sensors.push_back(beam("a", 0));
  world.robots[0].sensors.push_back(beam("b", 10));
  world.robots[0].sensors[1].energy_cost = 2.5;
  world.limits.time = 10;
  for (const int control_steps : {1, 4}) {
    world.physics.control_steps = control_steps;
    CHECK(Simulation(world, scripted.host).run().robots[0].energy == Approx(5000 - 35));
  }
}

TEST_CASE("An empty robot stops, is not asked any more, and an event says so once") {
  double last_asked = 0;
  ScriptedHost scripted([&](const Perception& now) {
    last_asked = now.time_s();
    return wheels(10, 10);
  });
  world::World world = one_robot();
  world.robots[0].energy = 2.0;
  world.robots[0].sensors.push_back(beam("a", 0));
  world.limits.time = 6;
  const auto result = Simulation(world, scripted.host).run();
  CHECK(last_asked == Approx(2.0).margin(0.02));
  CHECK(result.robots[0].energy == 0.0);
  CHECK(result.robots[0].distance_m == Approx(0.4).margin(0.02));
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].name() == "battery_empty");
  CHECK(result.events[0].time_s == Approx(2.0).margin(0.02));
}

TEST_CASE("A robot at its charger that asks for it is charged until full") {
  ScriptedHost scripted([](const Perception&) {
    Response response;
    response.charge = true;
    return response;
  });
  const auto result = Simulation(with_charger(4000), scripted.host).run();
  REQUIRE(result.events.size() >= 2);
  CHECK(result.events[0].name() == "charging_started");
  CHECK(result.events[1].name() == "charging_ended");
  // 25 units in each control step, less what the sensor takes: 1000 units in 40 steps and a bit.
  CHECK(result.events[1].time_s == Approx(0.41).margin(0.015));
}

TEST_CASE("Nobody is charged away from a charger, at another team's, or without asking") {
  const auto charged = [](world::World world, bool ask) {
    ScriptedHost scripted([ask](const Perception&) {
      Response response;
      response.charge = ask;
      return response;
    });
    return Simulation(world, scripted.host).run().robots[0].energy > 4500;
  };
  CHECK(charged(with_charger(4000), true));
  CHECK_FALSE(charged(with_charger(4000), false));
  auto away = with_charger(4000);
  away.chargers[0].x = 1;
  CHECK_FALSE(charged(away, true));
  auto theirs = with_charger(4000);
  theirs.chargers[0].team = "blue";
  CHECK_FALSE(charged(theirs, true));
}

TEST_CASE("A robot that starts empty never moves, with or without sensors") {
  ScriptedHost scripted([](const Perception&) { return wheels(10, 10); });
  world::World world = one_robot();
  world.robots[0].energy = 0.0;
  world.limits.time = 1;
  const auto result = Simulation(world, scripted.host).run();
  CHECK(result.robots[0].distance_m < 1e-4);
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].name() == "battery_empty");
}

TEST_CASE("A resource fills the battery up to its capacity, and one robot only") {
  ScriptedHost scripted([](const Perception&) { return wheels(20, 20); });
  world::World world;
  world.obstacles.push_back(box("gold", world::ObstacleKind::resource, 0, 0));
  world.obstacles[0].energy = 900;
  world.robots.push_back(robot("r1", -0.5, 0, 0, behavior("scripted")));
  world.robots.push_back(robot("r2", 0.5, 0, 180, behavior("scripted")));
  world.robots[0].energy = world.robots[1].energy = 4500;
  world.limits.time = 1.1;
  const auto result = Simulation(world, scripted.host).run();
  CHECK(result.robots[0].collected + result.robots[1].collected == 1);
  CHECK(std::max(result.robots[0].energy, result.robots[1].energy) == 5000);
  CHECK(std::min(result.robots[0].energy, result.robots[1].energy) == 4500);
}
