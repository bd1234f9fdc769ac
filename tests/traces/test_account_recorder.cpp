#include <catch2/catch.hpp>

#include "elsie/recording/mcap_recorder.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/account_recorder.h"
#include "elsie/world/reader.h"

#include "folder.h"
#include "shipped.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;
using traces::AccountRecorder;
using traces::RobotAccount;

namespace {

void require_equal(const traces::MemberAccount& a, const traces::MemberAccount& b) {
  CHECK(a.decided_s == b.decided_s);
  CHECK(a.periods == b.periods);
  CHECK(a.longest_s == b.longest_s);
  CHECK(a.longest_at_s == b.longest_at_s);
  CHECK(a.asked_s == b.asked_s);
  CHECK(a.share == b.share);
  CHECK(a.robot_share == b.robot_share);
  CHECK(a.weight == b.weight);
  CHECK(a.least_weight == b.least_weight);
  CHECK(a.largest_weight == b.largest_weight);
  CHECK(a.activation == b.activation);
  CHECK(a.strength == b.strength);
  REQUIRE(a.inhibited.size() == b.inhibited.size());
  for (std::size_t i = 0; i < a.inhibited.size(); ++i) {
    CHECK(a.inhibited[i].by == b.inhibited[i].by);
    CHECK(a.inhibited[i].times == b.inhibited[i].times);
    CHECK(a.inhibited[i].time_s == b.inhibited[i].time_s);
  }
}

void require_equal(const traces::Episode& a, const traces::Episode& b,
                   const std::vector<std::string>& reasons_a,
                   const std::vector<std::string>& reasons_b) {
  CHECK(a.from_s == b.from_s);
  CHECK(a.to_s == b.to_s);
  CHECK(a.switches == b.switches);
  REQUIRE(a.parts.size() == b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    CHECK(a.parts[i].decider == b.parts[i].decider);
    CHECK(a.parts[i].time_s == b.parts[i].time_s);
    CHECK(a.parts[i].share == b.parts[i].share);
    CHECK(a.parts[i].weight == b.parts[i].weight);
    CHECK(reasons_a[a.parts[i].reason] == reasons_b[b.parts[i].reason]);
  }
}

/// Runs a shipped world for some seconds with both recorders.
std::size_t compare(const std::string& name, double seconds,
                    const std::vector<simulation::TimedEdit>& edits = {}) {
  CAPTURE(name);
  const Folder folder;
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  world::World world = world::read_world(source_path("worlds/" + name), shipped(), options);
  Simulation run(
      std::move(world), shipped(),
      {.seed = 3, .data_directories = options.data_directories, .time_limit_s = seconds});
  const auto file = recording::mcap_recorder(folder / "run.mcap");
  AccountRecorder recorder;
  simulation::Observer* const observers[] = {file.get(), &recorder};
  run.run(observers, edits);
  const traces::Trace trace = recording::read_trace(folder / "run.mcap");
  const traces::TimeSpan all = within({}, trace);
  REQUIRE(recorder.accounts().size() == trace.robots.size());
  std::size_t episodes = 0;
  for (std::size_t r = 0; r < trace.robots.size(); ++r) {
    const RobotAccount expected = traces::account(trace.robots[r], all);
    const RobotAccount& got = recorder.accounts()[r];
    CHECK(recorder.robots()[r].id == trace.robots[r].id);
    CHECK(recorder.robots()[r].coordinator == trace.robots[r].coordinator);
    CHECK(got.span.from_s == expected.span.from_s);
    CHECK(got.span.to_s == expected.span.to_s);
    REQUIRE(got.members.size() == expected.members.size());
    for (std::size_t i = 0; i < got.members.size(); ++i) {
      CHECK(recorder.robots()[r].members[i].path == trace.robots[r].members[i].path);
      CHECK(recorder.robots()[r].members[i].parent == trace.robots[r].members[i].parent);
      require_equal(got.members[i], expected.members[i]);
    }
    REQUIRE(got.coordinators.size() == expected.coordinators.size());
    for (std::size_t i = 0; i < got.coordinators.size(); ++i) {
      CHECK(got.coordinators[i].parent == expected.coordinators[i].parent);
      CHECK(got.coordinators[i].asked_s == expected.coordinators[i].asked_s);
      CHECK(got.coordinators[i].nobody_s == expected.coordinators[i].nobody_s);
      CHECK(got.coordinators[i].together_s == expected.coordinators[i].together_s);
      CHECK(got.coordinators[i].switches == expected.coordinators[i].switches);
      REQUIRE(got.coordinators[i].episodes.size() == expected.coordinators[i].episodes.size());
      for (std::size_t k = 0; k < got.coordinators[i].episodes.size(); ++k) {
        require_equal(got.coordinators[i].episodes[k], expected.coordinators[i].episodes[k],
                      recorder.reasons(), trace.reasons);
        ++episodes;
      }
    }
  }
  return episodes;
}

}  // namespace

TEST_CASE("What is added up while a run goes on is what its whole trace says, to the last bit") {
  // Layers that silence each other, behaviours inside others, shares that change all the time,
  // several robots.
  CHECK(compare("layers.xml", 20.0) > 5);
  CHECK(compare("nested.xml", 20.0) > 5);
  CHECK(compare("clutter.xml", 10.0) > 0);
  CHECK(compare("ten_robots.xml", 5.0) >= 10);  // each robot has one
}

TEST_CASE("Of an edited run, too: robots and behaviours count while they are there") {
  CHECK(compare("ten_robots.xml", 4.0,
                {{1.0, {"robot[2]/@remove", "true"}},
                 {1.5, {"robot[1]/behavior[+]", "<wander id=\"more\"/>"}},
                 {2.0, {"robot[1]/sensor[1]/@id", "renamed"}},
                 {2.0, {"physics/@step", "0.004"}},
                 {2.5, {"robot[1]/behavior[more]/@remove", "true"}},
                 {3.0,
                  {"robot[+]",
                   "<robot id=\"late\" x=\"0.1\" y=\"0.1\"><behaviors><wander/>"
                   "</behaviors><coordinator><arbiter_suppression/>"
                   "</coordinator></robot>"}}}) >= 13);
}

TEST_CASE("A run without robots has nothing to add up") {
  world::World world;
  world.limits.time = 0.1;
  Simulation run(std::move(world), shipped());
  AccountRecorder recorder;
  simulation::Observer* const observers[] = {&recorder};
  run.run(observers);
  CHECK(recorder.accounts().empty());
}
