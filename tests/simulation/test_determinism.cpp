#include <filesystem>

#include <catch2/catch.hpp>

#include "elsie/recording/csv_recorder.h"
#include "elsie/traces/tracks.h"

#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

namespace {

/// Noise, collisions, pushed and moving boxes: everything that could differ.
world::World lively() {
  world::World world;
  world.arena.length = world.arena.width = 3;
  for (int i = 0; i < 4; ++i) {
    auto r = robot("r" + std::to_string(i), -0.9 + 0.6 * i, 0.1 * i, 40.0 * i,
                   behavior("avoid_obstacle", 2, models("avoid_obstacle")));
    r.behaviors.push_back(behavior("wander", 1, {{"restlessness", 3.0}}));
    r.coordinator->plugin = "fusion_vector_summation";
    r.sensors.push_back(beam("left", 20, {{"error", 0.05}}));
    r.sensors.push_back(beam("right", -20, {{"error_m", 0.01}}));
    world.robots.push_back(std::move(r));
  }
  world.obstacles.push_back(box("crate", world::ObstacleKind::dynamic, 0.5, -0.8));
  world.obstacles.push_back(box("shuttle", world::ObstacleKind::moving, -1, 1));
  world.obstacles.back().waypoints = {{1, 1}, {1, -1}};
  world.obstacles.push_back(box("rock", world::ObstacleKind::fixed, -0.7, -0.7));
  world.obstacles.push_back(box("food", world::ObstacleKind::resource, 0.9, 0.5));
  world.limits.time = 20;
  return world;
}

std::uint64_t hash(std::uint64_t seed) {
  return Simulation(lively(), shipped(), {seed}).run().state_hash;
}

}  // namespace

TEST_CASE("The same world and seed give bit-identical runs; another seed another run") {
  const std::uint64_t first = hash(1);
  CHECK(hash(1) == first);
  CHECK(hash(2) != first);
}

TEST_CASE("A reset in the same process brings back the same run") {
  Simulation simulation(lively(), shipped(), {3});
  const auto first = simulation.run();
  simulation.reset();
  const auto second = simulation.run();
  CHECK(second.state_hash == first.state_hash);
  CHECK(second.steps == first.steps);
  CHECK(second.events.size() == first.events.size());
  CHECK(second.robots[0].distance_m == first.robots[0].distance_m);
  simulation.reset(4);
  CHECK(simulation.run().state_hash == hash(4));
}

TEST_CASE("Watching, recording and timing a run does not change it") {
  TemporaryFile file;
  const auto recorder = recording::csv_recorder(file.path, {.rate_hz = 100, .with_times = true});
  traces::TrackRecorder tracks;
  simulation::Observer* const observers[] = {recorder.get(), &tracks};
  Simulation simulation(lively(), shipped(), {5, true});
  CHECK(simulation.run(observers).state_hash == hash(5));
}

TEST_CASE("Two simulations side by side do not disturb each other") {
  Simulation a(lively(), shipped(), {6});
  Simulation b(lively(), shipped(), {7});
  for (int i = 0; i < 2000; ++i) {
    a.step();
    b.step();
  }
  CHECK(a.state_hash() == hash(6));
  CHECK(b.state_hash() == hash(7));
}

TEST_CASE("Another sensor does not change the noise of the first") {
  const auto reading = [](bool with_another) {
    double distance = 0;
    ScriptedHost scripted([&](const Perception& now) {
      for (const auto& beam : now.readings<RangeReading>()) {
        if (beam.sensor() == "a") {
          distance = beam->distance_m;
        }
      }
      return Motion{};
    });
    world::World world;
    world.obstacles.push_back(box("b", world::ObstacleKind::fixed, 0.6, 0));
    world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted")));
    if (with_another) {
      world.robots[0].sensors.push_back(beam("other", 5, {{"error", 0.1}}));
    }
    world.robots[0].sensors.push_back(beam("a", 0, {{"error", 0.1}}));
    Simulation simulation(world, scripted.host);
    simulation.step();
    return distance;
  };
  CHECK(reading(false) == reading(true));
}
