#include <catch2/catch.hpp>

#include "elsie/recording/csv_recorder.h"
#include "elsie/traces/tracks.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;

namespace {

std::uint64_t hash(std::uint64_t seed) {
  return Simulation(lively(), shipped(), {seed}).run().state_hash;
}

}  // namespace

TEST_CASE("The same world and seed give the same run, new or reset; another seed another run") {
  Simulation simulation(lively(), shipped(), {3});
  const auto first = simulation.run();
  simulation.reset();
  const auto second = simulation.run();
  CHECK(second.state_hash == first.state_hash);
  CHECK(second.steps == first.steps);
  CHECK(second.events.size() == first.events.size());
  CHECK(second.robots[0].distance_m == first.robots[0].distance_m);
  CHECK(first.state_hash == hash(3));
  simulation.reset(4);
  CHECK(simulation.run().state_hash == hash(4));
  CHECK(hash(3) != hash(4));
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
  for (int i = 0; i < 600; ++i) {
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
