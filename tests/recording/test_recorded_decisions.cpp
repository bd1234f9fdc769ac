// Decisions of real runs, from their recordings.
#include <catch2/catch.hpp>

#include "elsie/recording/csv_recorder.h"

#include "recorded.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::rates;
using elsie::test::wheels;
using recording::mcap_recorder;
using recording::read_trace;
using simulation::Simulation;
using traces::Trace;

namespace {

world::World two_deciding_robots() {
  world::World world;
  world.name = "two, \"robots\"";
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("go_to_point", 2, {{"x", 3.0}})));
  world.robots[0].behaviors.push_back(behavior("wander", 1));
  world.robots.push_back(robot("r2", 1, 1, 0, behavior("wander")));
  world.robots[1].coordinator->plugin = "fusion_vector_summation";
  world.limits.time = 1;
  return world;
}

/// Holds others, for as long as it is not later than a time.
class Holder final : public Behavior {
 public:
  Coordination* inside = nullptr;
  Response respond(const Perception& now) override {
    return now.time_s() < 0.05 ? inside->respond(now) : Response(Motion{});
  }
};

world::World nested() {
  world::World world;
  world::BehaviorUse holder = behavior("holder");
  holder.id = "outer";
  world::PluginUse inner;
  inner.plugin = inner.id = "fusion_vector_summation";
  holder.inside.push_back({{behavior("scripted", 3)}, inner});
  world.robots.push_back(robot("r1", 0, 0, 0, holder));
  world.limits.time = 0.1;
  return world;
}

}  // namespace

TEST_CASE("A trace tells of world, seed, periods, robots, coordinators and behaviours") {
  const McapFile file;
  world::World world = two_deciding_robots();
  world.file = "two.xml";
  world.physics.control_steps = 5;
  Simulation simulation(std::move(world), shipped(), {.seed = 18446744073709551615u});
  record(simulation, file.path);
  const Trace trace = read_trace(file.path);
  CHECK(trace.world == "two, \"robots\"");
  CHECK(trace.world_file == "two.xml");
  CHECK(trace.seed == 18446744073709551615u);
  CHECK(trace.step_s == 0.01);
  CHECK(trace.period_s == 0.05);
  REQUIRE(trace.robots.size() == 2);
  CHECK(trace.robots[0].id == "r1");
  CHECK(trace.robots[0].team == "red");
  CHECK(trace.robots[0].coordinator == "arbiter_suppression");
  CHECK(trace.robots[1].coordinator == "fusion_vector_summation");
  REQUIRE(trace.robots[0].members.size() == 2);
  CHECK(trace.robots[0].members[0].path == "go_to_point");
  CHECK(trace.robots[0].members[0].plugin == "go_to_point");
  CHECK(trace.robots[0].members[0].priority == 2);
  CHECK(trace.end_s == 1);
  CHECK(trace.outcome == "time_limit");
  CHECK(trace.outcome_reason == "the limit of simulated time was met");
  CHECK(trace.cut_off.empty());
}

TEST_CASE("A trace tells what each coordinator made of each behaviour, and the command") {
  const RecordedFile file(two_deciding_robots(), shipped());
  const Trace trace = read_trace(file.path);
  const auto& winner = trace.robots[0].members[0].notes.at(0);
  CHECK(winner.time_s == 0);
  CHECK(winner.asked);
  CHECK(winner.share == 1);
  CHECK(winner.weight == 1);
  CHECK(winner.inhibited_by == -1);
  CHECK(trace.reasons[winner.reason] == "highest priority");
  const auto& loser = trace.robots[0].members[1].notes.at(0);
  CHECK_FALSE(loser.asked);
  CHECK(loser.share == 0);
  CHECK(loser.inhibited_by == 0);
  CHECK(trace.reasons[loser.reason] == "suppressed");
  const auto message = recorded(file.path)["/robots/r1/trace"].at(0);
  const auto& row = message.content.at("behaviors")[0];
  for (const char* channel : {"forward_m_s", "lateral_m_s", "turn_rad_s"}) {
    CHECK(message.content.at(channel) == row.at(channel));
    CHECK(message.content.at(std::string("asked_") + channel) == row.at(channel));
  }
}

TEST_CASE("What has not changed since the last decision is not written") {
  ScriptedHost scripted([](const Perception& now) {
    return Motion{now.time_s() < 0.5 ? 0.1 : 0.2, 0.0, 0.5};
  });
  world::World world = one_robot();
  world.limits.time = 1;
  const RecordedFile file(std::move(world), scripted.host);
  const auto decisions = recorded(file.path)["/robots/r1/trace"];
  REQUIRE(decisions.size() == 2);
  CHECK(decisions[0].time_s() == 0.0);
  CHECK(decisions[0].content.at("forward_m_s") == 0.1);
  CHECK(decisions[1].time_s() == 0.5);
  CHECK(decisions[1].timestamp_s() == 0.5);
  CHECK(decisions[1].content.at("forward_m_s") == 0.2);
  const auto& row = decisions[1].content.at("behaviors").at(0);
  CHECK(row.at("path") == "scripted");
  CHECK(row.at("asked") == true);
  CHECK(row.at("forward_m_s") == 0.2);
  CHECK(row.at("reason") == "highest priority");
  CHECK(read_trace(file.path).robots[0].members[0].notes.size() == 2);
}

TEST_CASE(
    "Numbers are rounded: commands five decimals, weights four digits, others three decimals") {
  ScriptedHost scripted([](const Perception& now) {
    Response response = Motion{-0.000001, 0.0, 1.0 / 3.0};
    response.activation = 0.66666 + 1e-5 * now.time_s();
    return response;
  });
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted", 1.23456789e-7)));
  world.robots[0].coordinator->plugin = "fusion_vector_summation";
  world.robots[0].coordinator->parameters["weighted"] = true;
  world.limits.time = 1;
  const RecordedFile file(std::move(world), scripted.host);
  const auto decisions = recorded(file.path)["/robots/r1/trace"];
  REQUIRE(decisions.size() == 1);
  const auto& row = decisions[0].content.at("behaviors").at(0);
  CHECK(row.at("forward_m_s") == 0);
  CHECK(row.at("turn_rad_s") == 0.33333);
  CHECK(row.at("activation") == 0.667);
  CHECK(row.at("weight") == 1.235e-07);
  CHECK(decisions[0].content.at("turn_rad_s") == 0);
  const Trace trace = read_trace(file.path);
  CHECK(trace.robots[0].members[0].priority == 1.23456789e-7);
  REQUIRE(trace.robots[0].members[0].notes.size() == 1);
  const auto& note = trace.robots[0].members[0].notes[0];
  CHECK(note.command == Motion{0, 0, 0.33333});
  CHECK_FALSE(std::signbit(note.command.forward));
  CHECK(note.activation == 0.667);
  CHECK(note.strength == 1);
  CHECK(note.weight == 1.235e-07);
  CHECK(note.share == 1);
  CHECK(trace.reasons[note.reason] == "summed");
}

TEST_CASE("With a control period of several steps there is a decision in each period") {
  ScriptedHost scripted([](const Perception& now) { return Motion{now.time_s(), 0, 0}; });
  world::World world = one_robot();
  world.physics.control_steps = 5;
  world.limits.time = 0.52;
  const RecordedFile file(std::move(world), scripted.host);
  const Trace trace = read_trace(file.path);
  const auto& notes = trace.robots[0].members[0].notes;
  REQUIRE(notes.size() == 11);
  CHECK(notes[10].time_s == 0.5);
  CHECK(notes[10].command.forward == 0.5);
  CHECK(trace.end_s == 0.52);
}

TEST_CASE("Behaviours inside others are traced, also when they are not asked") {
  ScriptedHost scripted([](const Perception&) { return wheels(1, 2); });
  scripted.host.add(declare<Holder>(PluginKind::behavior, "holder", "holds others",
                                    holds_behaviors(&Holder::inside)));
  const RecordedFile file(nested(), scripted.host);
  const Trace trace = read_trace(file.path);
  REQUIRE(trace.robots[0].members.size() == 2);
  const auto& inner = trace.robots[0].members[1];
  CHECK(inner.path == "outer/scripted");
  CHECK(inner.coordinator == "fusion_vector_summation");
  CHECK(inner.priority == 3);
  CHECK(inner.depth == 1);
  CHECK(inner.parent == 0);
  REQUIRE(inner.notes.size() == 2);
  CHECK(inner.notes[0].asked);
  CHECK(inner.notes[0].share == 1);
  CHECK(inner.notes[1].time_s == 0.05);
  CHECK_FALSE(inner.notes[1].asked);
  CHECK(inner.notes[1].share == 0);
}

TEST_CASE("Events are in the trace, at the end of the step in which they happened") {
  ScriptedHost scripted([](const Perception& now) {
    Response response;
    if (now.time_s() == 0.0) {
      response.events.push_back({"hello"});
    }
    return response;
  });
  world::World world = one_robot();
  world.robots.push_back(robot("r2", 2, 0, 0, behavior("wander", 1, {{"speed", 20.0}})));
  world.robots[1].behaviors[0].parameters["restlessness"] = 0.0;
  world.obstacles.push_back(box("apple", world::ObstacleKind::resource, 2.5, 0));
  world.limits.time = 2;
  const RecordedFile file(std::move(world), scripted.host);
  const Trace trace = read_trace(file.path);
  REQUIRE(trace.robots[0].events.size() == 1);
  CHECK(trace.robots[0].events[0].name == "hello");
  CHECK(trace.robots[0].events[0].time_s == 0.01);
  REQUIRE(trace.robots[1].events.size() == 1);
  CHECK(trace.robots[1].events[0].name == "collected");
  CHECK(trace.robots[1].events[0].detail == "apple");
  CHECK(trace.robots[1].events[0].time_s == Approx(file.result.events.back().time_s));
}

TEST_CASE("A robot without behaviours or coordinator has a trace, too") {
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("wander")));
  world.robots[0].behaviors.clear();
  world.robots[0].coordinator.reset();
  world.limits.time = 0.1;
  const RecordedFile file(std::move(world), shipped());
  const Trace trace = read_trace(file.path);
  CHECK(trace.robots.at(0).coordinator.empty());
  CHECK(trace.robots[0].members.empty());
  CHECK(recorded(file.path)["/robots/r1/trace"].size() == 1);
}

TEST_CASE("A recording in which nothing changes still shows that the run goes on") {
  const McapFile file;
  ScriptedHost scripted([](const Perception&) { return wheels(0, 0); });
  world::World world = one_robot();
  Simulation simulation(std::move(world), scripted.host);
  const auto recorder = mcap_recorder(file.path);
  recorder->started(simulation);
  for (int i = 0; i < 3550; ++i) {
    simulation.step();
    recorder->stepped(simulation);
  }
  const Trace trace = read_trace(file.path);
  CHECK(trace.end_s > 34);
  CHECK(trace.robots[0].members[0].notes.size() == 1);
}

TEST_CASE("Times that behaviours took are added up, when they were recorded") {
  const McapFile a, b;
  Simulation measured(two_deciding_robots(), shipped(), {.seed = 1, .measure_time = true});
  record(measured, a.path, {.with_times = true});
  const Trace trace = read_trace(a.path);
  const auto& times = trace.robots[0].members[0].times;
  CHECK(times.answers == 100);
  CHECK(times.mean_s > 0);
  CHECK(times.longest_s >= times.mean_s);
  CHECK(trace.robots[0].members[1].times.answers == 0);  // suppressed
  measured.reset();
  record(measured, b.path);
  CHECK(read_trace(b.path).robots[0].members[0].times.answers == 0);
}

TEST_CASE("A recording that cannot be written to its end says so") {
  if (std::filesystem::exists("/dev/full")) {
    Simulation simulation(two_deciding_robots(), shipped());
    CHECK_THROWS_WITH(record(simulation, "/dev/full"),
                      "recording '/dev/full' could not be written: No space left on device");
  }
}
