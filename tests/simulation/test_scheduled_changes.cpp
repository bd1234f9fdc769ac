// Changes that are asked for before a run: when they are made, and that runs with them repeat.

#include <catch2/catch.hpp>

#include "elsie/recording/mcap_recorder.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/traces/trace.h"

#include "change_support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::wheels;
using simulation::RunResult;
using simulation::TimedChange;

namespace {

/// Noise, a wanderer, a crowd.
world::World lively() {
  world::World world;
  world.arena.length = world.arena.width = 4;
  for (int i = 0; i < 3; ++i) {
    auto r = robot("r" + std::to_string(i), -1.0 + i, 0.1 * i, 40.0 * i,
                   behavior("avoid_obstacle", 2, models("avoid_obstacle")));
    r.behaviors.push_back(behavior("wander", 1, {{"restlessness", 3.0}}));
    r.coordinator->plugin = "fusion_vector_summation";
    r.sensors = {beam("left", 20, {{"error", 0.05}}), beam("right", -20)};
    world.robots.push_back(std::move(r));
  }
  world.limits.time = 8;
  return world;
}

const std::vector<TimedChange> kChanges{
    {1.0, {"robot[*]/@max_speed", "0.2"}},
    {2.0, {"robot[r1]/@x", "1.5"}},
    {2.0, {"robot[r1]/@y", "-1.5"}},
    {2.5, {"robot[*]/sensor[*]/@error", "0.2"}},
    {3.0, {"robot[r2]/coordinator/@weighted", "true"}},
    {3.0, {"robot[r2]/behavior[wander]/@priority", "4"}},
    {4.0, {"robot[r0]/behavior[wander]/@turn", "9"}},
};

RunResult result_of(std::uint64_t seed, const std::vector<TimedChange>& changes) {
  return Simulation(lively(), shipped(), {seed}).run({}, changes);
}

}  // namespace

TEST_CASE("The same changes before the same steps give the same run, bit for bit") {
  const RunResult first = result_of(5, kChanges), again = result_of(5, kChanges);
  CHECK(first.state_hash == again.state_hash);
  CHECK(first.state_hash != result_of(5, {}).state_hash);
  CHECK(first.state_hash != result_of(6, kChanges).state_hash);
  for (std::size_t without = 0; without < kChanges.size(); ++without) {
    std::vector<TimedChange> fewer = kChanges;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(without));
    CAPTURE(kChanges[without].change.path);
    CHECK(first.state_hash != result_of(5, fewer).state_hash);
  }
}

TEST_CASE("Whether a run makes its changes or a caller between two steps is the same") {
  const RunResult scheduled = result_of(5, kChanges);
  Simulation simulation(lively(), shipped(), {5});
  while (simulation.outcome() == simulation::Outcome::running) {
    std::vector<simulation::Change> now;
    for (const TimedChange& timed : kChanges) {
      if (simulation.steps() == static_cast<std::uint64_t>(std::lround(timed.time_s * 100))) {
        now.push_back(timed.change);
      }
    }
    simulation.change(now);
    simulation.step();
  }
  CHECK(simulation.state_hash() == scheduled.state_hash);
  CHECK(simulation.events().size() == scheduled.events.size());
}

TEST_CASE("After a reset a run with changes and one without are those of a new simulation") {
  Simulation simulation(lively(), shipped(), {5});
  simulation.run({}, kChanges);
  simulation.reset();
  CHECK(simulation.run().state_hash == result_of(5, {}).state_hash);
  simulation.reset(9);
  CHECK(simulation.run({}, kChanges).state_hash == result_of(9, kChanges).state_hash);
}

TEST_CASE("A change is made before the first step at its time or after it") {
  ScriptedHost scripted([](const Perception&) { return wheels(20, 20); });
  world::World world;
  world.limits.time = 1;
  world.robots = {robot("r1", 0, 0, 0, behavior("scripted"))};
  Simulation simulation(world, scripted.host);
  // 57 steps of 0.01 s are a hair more than 0.57 s, and 58 a hair less than 0.58.
  const std::vector<TimedChange> changes{{0.58, {"robot[r1]/@max_speed", "0.1"}},
                                         {0.0, {"robot[r1]/@max_speed", "0.2"}},
                                         {0.57, {"robot[r1]/@coverage", "2"}},
                                         {0.123, {"robot[r1]/@leader", "true"}}};
  const RunResult result = simulation.run({}, changes);
  CHECK(events_of(simulation) == std::vector<std::string>{"0 changed robot[r1]/@max_speed=0.2",
                                                          "0.13 changed robot[r1]/@leader=true",
                                                          "0.57 changed robot[r1]/@coverage=2",
                                                          "0.58 changed robot[r1]/@max_speed=0.1"});
  CHECK(result.robots[0].distance_m == Approx(0.58 * 0.2 + 0.42 * 0.1).margin(0.005));
}

TEST_CASE("A schedule is checked before the run begins") {
  ScriptedHost scripted([](const Perception&) { return wheels(20, 20); });
  world::World world;
  world.limits.time = 1;
  world.robots = {robot("r1", 0, 0, 0, behavior("escape"))};
  Simulation simulation(world, scripted.host);
  const auto refused = [&](const std::vector<TimedChange>& changes, const std::string& sentence) {
    CHECK(why_not([&] { simulation.run({}, changes); }) == sentence);
    CHECK(why_not([&] { simulation.check(changes); }) == sentence);
    CHECK(simulation.steps() == 0);
  };
  const TimedChange good{0.2, {"robot[r1]/@leader", "true"}};
  refused({good, {1.0, {"robot[r1]/@x", "1"}}},
          "robot[r1]/@x=1: its time is 1 s, but the run begins at 0 and ends after 1 s at the "
          "latest; expected a time in between, before the last step begins");
  refused({good, {0.9951, {"robot[r1]/@x", "1"}}},
          "robot[r1]/@x=1: its time is 0.9951 s, but the run begins at 0 and ends after 1 s at the "
          "latest; expected a time in between, before the last step begins");
  refused({good, {-0.1, {"robot[r1]/@x", "1"}}},
          "robot[r1]/@x=1: its time is -0.1 s, but the run begins at 0 and ends after 1 s at the "
          "latest; expected a time in between, before the last step begins");
  refused({good, {0.5, {"robot[r1]/@max_speed", "fast"}}},
          "at 0.5 s, robot[r1]/@max_speed=fast: expected a number at least 0 and at most 100 m/s");
  refused({good, {0.5, {"robot[r1]/@x", "6"}}},
          "at 0.5 s, robot[r1]/@x=6: that is outside of the arena, which reaches from -5 to 5 in "
          "x");
  // Parameters are judged by what they are by then: turn_min is 60, turn_max 150.
  const std::string turn = "robot[r1]/behavior[escape]/@turn_";
  refused({{0.5, {turn + "min", "170"}}},
          "at 0.5 s, " + turn +
              "min=170: behavior 'escape': turn_min is 170 deg and turn_max 150 deg; the turn is "
              "drawn from between the two, so turn_min must not be the larger one");
  CHECK(why_not([&] {
          simulation.check(
              std::vector<TimedChange>{{0.5, {turn + "min", "170"}}, {0.4, {turn + "max", "180"}}});
        }).empty());
}

TEST_CASE("A place that is taken when its time comes ends the run, and its observers hear of it") {
  struct Listener final : simulation::Observer {
    void stepped(const Simulation&) override { ++steps; }
    void ended(const Simulation&) override { ended_at = steps; }
    int steps = 0, ended_at = -1;
  } listener;
  ScriptedHost scripted(
      [](const Perception& now) { return now.self().id == "walker" ? wheels(10, 10) : Motion{}; });
  world::World world;
  world.limits.time = 10;
  world.robots = {robot("walker", 0, 0, 0, behavior("scripted")),
                  robot("other", 0, 2, 0, behavior("scripted"))};
  Simulation simulation(world, scripted.host);
  const std::vector<TimedChange> onto{{5.0, {"robot[other]/@x", "1"}},
                                      {5.0, {"robot[other]/@y", "0"}}};
  simulation::Observer* observers[] = {&listener};
  CHECK(why_not([&] { simulation.run(observers, onto); }) ==
        "at 5 s, robot[other]/@x=1, robot[other]/@y=0: the robot 'other' overlaps the robot "
        "'walker'; expected a free place in the arena");
  CHECK(listener.ended_at == 500);
}

TEST_CASE("Recordings tell what was changed, and observers see the start as it is changed to") {
  struct Start final : simulation::Observer {
    void started(const Simulation& simulation) override { x = simulation.robot(0).state->pose.x; }
    double x = 0;
  } start;
  ScriptedHost scripted([](const Perception&) { return wheels(5, 5); });
  world::World world;
  world.limits.time = 1;
  world.robots = {robot("r1", 0, 0, 0, behavior("scripted"))};
  Simulation simulation(world, scripted.host);
  TemporaryFile file;
  recording::McapRecorder recorder(file.path);
  simulation::Observer* observers[] = {&start, &recorder};
  simulation.run(observers, std::vector<TimedChange>{{0.0, {"robot[r1]/@x", "-2"}},
                                                     {0.5, {"robot[1]/@max_speed", "0.05"}}});
  CHECK(start.x == Approx(-2));
  const traces::Trace trace = recording::read_trace(file.path);
  REQUIRE(trace.robots.at(0).events.size() == 2);
  CHECK(trace.robots[0].events[0].detail == "robot[r1]/@x=-2");
  CHECK(trace.robots[0].events[1].detail == "robot[r1]/@max_speed=0.05");
}
