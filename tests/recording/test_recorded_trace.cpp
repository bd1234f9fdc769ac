// Decisions read back from recordings that are made by hand.
#include <catch2/catch.hpp>

#include "recorded.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::rates;
using recording::read_trace;
using simulation::Simulation;
using traces::Trace;

namespace {

const std::string kBehaviors = R"([
    {"path": "a", "plugin": "wander", "coordinator": "outer", "priority": 1},
    {"path": "b", "plugin": "blend", "coordinator": "outer", "priority": 2},
    {"path": "b/c", "plugin": "flee", "coordinator": "inner", "priority": 0.5}])";

std::string row(const std::string& path, const std::string& members = "") {
  return R"({"path": ")" + path + R"(", "asked": true, "forward_m_s": 0.15, "lateral_m_s": 0.5,
      "turn_rad_s": -2,
      "activation": 0.5, "strength": 1, "weight": 2, "share": 0.25, "inhibited_by": "",
      "reason": "first")" +
         members + "}";
}

struct Made {
  std::string behaviors = kBehaviors;
  std::vector<std::pair<std::uint64_t, std::string>> decisions;  // time, ns, and rows
  std::string event = R"({"name": "r1", "event": "collision", "detail": "wall"})";
  bool with_end = true;
};

/// A recording with the head that the recorder writes.
std::filesystem::path write(const McapFile& file, const Made& made) {
  mcap::Writer writer(file.path, {.library = "elsie 0.0.0"});
  writer.write(mcap::Metadata{"elsie.run",
                              {{"world", "four, \"resources\""},
                               {"file", "four.xml"},
                               {"seed", "7"},
                               {"step_s", "0.01"},
                               {"control_steps", "2"},
                               {"sample_steps", "10"}}});
  const auto events = writer.add_channel("/events", 0, "json");
  const auto trace = writer.add_channel(
      "/robots/r1/trace", 0, "json",
      {{"robot", "r1"}, {"team", "red"}, {"coordinator", "outer"}, {"behaviors", made.behaviors}});
  for (const auto& [time_ns, rows] : made.decisions) {
    writer.write(trace, time_ns, R"({"behaviors": [)" + rows + "]}");
  }
  writer.write(events, 60'000'000, made.event);
  if (made.with_end) {
    writer.write(mcap::Metadata{
        "elsie.result", {{"outcome", "success"}, {"reason", "done"}, {"simulated_s", "0.1"}}});
    writer.close();
  }
  return file.path;
}

/// What the reader says of a recording, without the file's name.
std::string error_of(const Made& made) {
  const McapFile file;
  try {
    read_trace(write(file, made));
  } catch (const mcap::McapError& error) {
    const std::string sentence = error.what();
    const std::string start = "recording '" + file.path.string() + "': ";
    return sentence.starts_with(start) ? sentence.substr(start.size()) : sentence;
  }
  return "no error";
}

}  // namespace

TEST_CASE("Decisions are read as they were written; what repeats the last note is none") {
  const McapFile file;
  const Trace trace = read_trace(
      write(file, {.decisions = {{0, row("a", R"(, "inhibited_by": "b")") + "," +
                                         row("b", R"(, "asked": false, "share": 0.0004)")},
                                 {20'000'000, row("b", R"(, "asked": false, "share": 0)")},
                                 {40'000'000, row("a", R"(, "reason": "so\nbe it")")}}}));
  CHECK(trace.world == "four, \"resources\"");
  CHECK(trace.world_file == "four.xml");
  CHECK(trace.seed == 7);
  CHECK(trace.step_s == 0.01);
  CHECK(trace.period_s == 0.02);
  REQUIRE(trace.robots.size() == 1);
  CHECK(trace.robots[0].id == "r1");
  CHECK(trace.robots[0].team == "red");
  CHECK(trace.robots[0].coordinator == "outer");
  const auto& members = trace.robots[0].members;
  REQUIRE(members.size() == 3);
  CHECK(members[2].path == "b/c");
  CHECK(members[2].plugin == "flee");
  CHECK(members[2].priority == 0.5);
  CHECK(members[2].parent == 1);
  CHECK(members[2].depth == 1);
  CHECK(members[2].coordinator == "inner");
  REQUIRE(members[0].notes.size() == 2);
  const auto& note = members[0].notes[0];
  CHECK(note.command == Motion{0.15, 0.5, -2});
  CHECK(note.activation == 0.5);
  CHECK(note.weight == 2);
  CHECK(note.share == 0.25);
  CHECK(trace.reasons[note.reason] == "first");
  CHECK(note.inhibited_by == 1);
  CHECK(members[0].notes[1].time_s == 0.04);
  CHECK(trace.reasons[members[0].notes[1].reason] == "so be it");
  REQUIRE(members[1].notes.size() == 1);
  CHECK_FALSE(members[1].notes[0].asked);
  CHECK(members[1].notes[0].command == Motion{});
  REQUIRE(trace.robots[0].events.size() == 1);
  CHECK(trace.robots[0].events[0].time_s == 0.06);
  CHECK(trace.robots[0].events[0].detail == "wall");
  CHECK(trace.end_s == 0.1);
  CHECK(trace.outcome == "success");
  CHECK(trace.outcome_reason == "done");
  CHECK(trace.cut_off.empty());
}

TEST_CASE("Decisions without an end go to the last message, or to the end of the last period") {
  const McapFile file;
  const Trace event = read_trace(write(file, {.decisions = {{0, row("a")}}, .with_end = false}));
  CHECK(event.outcome.empty());
  CHECK_THAT(event.cut_off, Catch::StartsWith("the end is missing: the file breaks off at byte "));
  CHECK(event.end_s == 0.06);
  const Trace decision =
      read_trace(write(file, {.decisions = {{50'000'000, row("a")}}, .with_end = false}));
  CHECK(decision.end_s == 0.07);
}

TEST_CASE("A recording that breaks off anywhere is read as far as it goes") {
  const RecordedFile file(shipped_world("nested.xml", 4), shipped());
  const std::string bytes = file.bytes();
  const McapFile cut;
  double end_s = 0.0;
  for (std::size_t length = 400; length < bytes.size(); length += 197) {
    cut.set(bytes.substr(0, length));
    try {
      const Trace trace = read_trace(cut.path);
      CHECK(trace.end_s >= end_s);
      CHECK(trace.robots.size() == 1);
      CHECK((trace.outcome.empty() == !trace.cut_off.empty()));
      end_s = trace.end_s;
    } catch (const mcap::McapError& error) {
      CHECK(end_s == 0.0);
      CHECK_THAT(error.what(), Catch::EndsWith("breaks off before its first second was written"));
    }
  }
  CHECK(end_s == 4.0);
}

TEST_CASE("A file without Elsie's decisions is refused in a sentence") {
  const McapFile file;
  write_small(file.path, 2);
  CHECK_THROWS_WITH(read_trace(file.path),
                    "recording '" + file.path.string() + "' was not made by Elsie but by ''");
  file.set("time_s,robot,x_m\n0,r1,0\n");
  CHECK_THROWS_WITH(read_trace(file.path), Catch::Contains("is not an MCAP file"));
  CHECK_THROWS_WITH(read_trace("/nowhere.mcap"), Catch::Contains("No such file or directory"));
}

TEST_CASE("A decision that cannot be is named by channel and time, with what is wrong") {
  const auto says = [](const std::string& rows, const std::string& problem) {
    CAPTURE(rows);
    CHECK_THAT(error_of({.decisions = {{20'000'000, rows}}}),
               Catch::StartsWith("a message on /robots/r1/trace at 0.020000 s is not as Elsie "
                                 "writes it: ") &&
                   Catch::Contains(problem));
  };
  says("{", "parse error");
  says("{}", "key 'path' not found");
  says(R"({"path": 7})", "type must be string");
  says(row("z"), "robot 'r1' has no behaviour 'z'");
  says(row("a", R"(, "asked": 2)"), "type must be boolean");
  says(row("a", R"(, "forward_m_s": null)"), "type must be number");
  says(row("a", R"(, "turn_rad_s": 1e999)"), "number overflow");
  says(row("a", R"(, "activation": 1.5)"), "activation is 1.5; expected a number from 0 to 1");
  says(row("a", R"(, "strength": -1)"), "strength is -1; expected a number from 0 to 1");
  says(row("a", R"(, "share": "all")"), "type must be number");
  says(row("a", R"(, "inhibited_by": "x")"), "robot 'r1' has no behaviour 'x'");
  says(row("a", R"(, "inhibited_by": "b/c")"),
       "'a' is inhibited by 'b/c', which is not under the same coordinator");
}

TEST_CASE("Decisions, events and behaviours that contradict each other are refused") {
  CHECK_THAT(error_of({.decisions = {{20'000'000, row("a")}, {0, row("a")}}}),
             Catch::Contains("at 0.000000 s is not as Elsie writes it: its time is before that of "
                             "the decision before it"));
  CHECK_THAT(error_of({.decisions = {}, .event = R"({"name": "r9", "event": "x", "detail": ""})"}),
             Catch::StartsWith("a message on /events at 0.060000 s is not as Elsie writes it: the "
                               "recording has no robot 'r9'"));
  const auto says = [](const std::string& behaviors, const std::string& problem) {
    CAPTURE(behaviors);
    CHECK_THAT(error_of({.behaviors = behaviors, .decisions = {}}),
               Catch::StartsWith("the channel /robots/r1/trace is not as Elsie writes it: ") &&
                   Catch::Contains(problem));
  };
  says("", "parse error");
  says(R"([{"path": "a", "plugin": "a", "coordinator": "c", "priority": "high"}])",
       "type must be number");
  says(R"([{"path": "x/c", "plugin": "a", "coordinator": "c", "priority": 1}])",
       "robot 'r1' has no behaviour 'x'");
  says(R"([{"path": "a", "plugin": "a", "coordinator": "c", "priority": 1},
           {"path": "a", "plugin": "b", "coordinator": "c", "priority": 1}])",
       "the behaviour 'a' is there twice");
}
