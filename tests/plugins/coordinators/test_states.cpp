// A finite-state automaton over behaviours.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;
using Catch::StartsWith;

namespace of_states {
namespace {

using Texts = std::vector<std::pair<const char*, ParameterValue>>;

ElementValue element(const char* name, const Texts& texts, std::vector<ElementValue> inside = {}) {
  ElementValue made{name, {}, std::move(inside)};
  for (const auto& [attribute, value] : texts) made.parameters[attribute] = value;
  return made;
}
ElementValue state(const std::string& name, const std::string& behavior,
                   std::vector<ElementValue> inside = {}) {
  return element("state", {{"name", name}, {"behavior", behavior}}, std::move(inside));
}
ElementValue on(const std::string& event, const std::string& to) {
  return element("transition", {{"to", to}, {"event", event}});
}
ElementValue when(const std::string& condition, const std::string& to) {
  return element("transition", {{"to", to}, {"when", condition}});
}
ElementValue after(double seconds, const std::string& to) {
  return element("transition", {{"to", to}, {"after", seconds}});
}

struct Note {
  static constexpr const char* kind = "note";
  double number = 0.0;
};

struct Robot {
  explicit Robot(const std::vector<ElementValue>& states) {
    for (const char* name : {"a", "b", "c"}) team.member(name, 1, Motion{speed_of(name), 0, 0});
    team.publishes("x", [this] { return published; });
    robot.emplace("arbiter_states", team, Parameters{}, states);
  }
  static double speed_of(const std::string& name) {
    return name.empty() ? 0.0 : 0.1 * (name[0] - 'a' + 1);
  }

  /// Who decides at this time, with these events.
  std::string at(double time_s, const std::vector<std::string>& events = {}) {
    Situation now = situation;
    now.time(time_s);
    for (const std::string& event : events) now.event(event);
    const Motion command = robot->decide(now);
    for (const Member& member : team.members()) {
      if (member.trace.share == 1.0) {
        CHECK(command.forward == Approx(speed_of(std::string(member.name()))));
        return std::string(member.name());
      }
    }
    CHECK(command == Motion{});
    return "";
  }

  Situation situation;
  Team team;
  double published = 0.0;
  std::optional<testing::Coordinator> robot;
};

std::string refusal(const std::vector<ElementValue>& states) {
  try {
    Robot robot(states);
    robot.at(0);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("An automaton begins in its first state, whose behaviour alone is asked") {
  Robot robot({state("one", "b", {on("go", "two")}), state("two", "a", {on("back", "one")})});
  CHECK(robot.at(0) == "b");
  CHECK(robot.team.asked("a") == 0);
  CHECK(robot.team.reason(1) == "state one");
  CHECK(robot.team.reason(0) == "other state");
  CHECK(robot.team.trace(0).inhibited_by == 1);
}

TEST_CASE("An event leads to the next state in the period in which it is perceived") {
  Robot robot({state("one", "a", {on("go", "two")}), state("two", "b", {on("back", "one")})});
  CHECK(robot.at(0) == "a");
  CHECK(robot.at(0.1, {"back"}) == "a");
  CHECK(robot.at(0.2, {"go"}) == "b");
  CHECK(robot.at(0.3, {"go"}) == "b");
  CHECK(robot.at(0.4, {"go", "back"}) == "a");  // one transition in a period
  robot.robot->reset();
  CHECK(robot.at(0) == "a");
}

TEST_CASE("A transition after a time is taken when the state is so old, for every control period") {
  for (const double period : {1e-3, 0.01, 0.03, 0.1}) {
    CAPTURE(period);
    Robot robot({state("one", "a", {after(0.6, "two")}), state("two", "b", {after(0.3, "one")})});
    for (int i = 0; i * period < 2.0; ++i) {
      const double time = i * period;
      const double first = std::ceil(0.6 / period - 1e-6) * period;
      const double second = first + std::ceil(0.3 / period - 1e-6) * period;
      const double phase = std::fmod(time + 1e-9, second);
      CHECK(robot.at(time) == (phase < first - 1e-6 ? "a" : "b"));
    }
  }
}

TEST_CASE("A condition reads own state, readings, published numbers, messages and events") {
  const auto decides = [](const std::string& condition, const auto& prepare) {
    Robot robot({state("one", "a", {when(condition, "two")}), state("two", "b")});
    robot.situation.beam(0.0, 1.0, 4.0);
    RangeReading reading;
    reading.distance_m = 0.5;
    robot.situation.reading(reading, Mounting{}, "eye");
    robot.situation.battery(0.9);
    CHECK(robot.at(0) == "a");
    CHECK(robot.at(1) == "a");
    prepare(robot);
    return robot.at(2) == "b";
  };
  CHECK(decides("battery < 0.2", [](Robot& r) { r.situation.battery(0.1); }));
  CHECK(decides("c.x > 3 and battery > 0.5", [](Robot& r) { r.published = 4.0; }));
  CHECK_FALSE(decides("c.x > 3 and battery < 0.5", [](Robot& r) { r.published = 4.0; }));
  CHECK(decides("heard.note >= 2", [](Robot& r) { r.situation.hear(Note{}).hear(Note{}); }));
  CHECK(decides("event.whistle == 1", [](Robot& r) { r.situation.event("whistle"); }));
  CHECK(decides("eye.distance_m < 0.4", [](Robot& r) {
    RangeReading reading;
    reading.distance_m = 0.3;
    r.situation.clear_readings().beam(0.0, 1.0, 4.0).reading(reading, Mounting{}, "eye");
  }));
  CHECK_FALSE(decides("c.x > 3", [](Robot& r) { r.published = std::nan(""); }));
}

TEST_CASE("All that a transition says must hold; of several the first is taken") {
  Robot robot({state("one", "a",
                     {element("transition", {{"to", "two"}, {"event", "go"}, {"after", 1.0}}),
                      on("go", "three")}),
               state("two", "b"), state("three", "c")});
  CHECK(robot.at(0) == "a");
  CHECK(robot.at(0.5, {"go"}) == "c");
  robot.robot->reset();
  CHECK(robot.at(0) == "a");
  CHECK(robot.at(1.0, {"go"}) == "b");
}

TEST_CASE("Chance: in a second without an event, however long the period is, else at each event") {
  const auto share_left = [](double period, const char* event) {
    int left = 0;
    const int runs = 2000;
    for (int run = 1; run <= runs; ++run) {
      Texts texts{{"to", "two"}, {"chance", 0.3}};
      if (*event) texts.emplace_back("event", event);
      Robot robot({state("one", "a", {element("transition", texts)}), state("two", "b")});
      robot.situation.period(period);
      robot.at(0);
      robot.robot->reset(static_cast<std::uint64_t>(run));
      robot.at(0);
      std::string last;
      const int periods = *event ? 1 : static_cast<int>(std::lround(1.0 / period));
      for (int i = 1; i <= periods; ++i) {
        last = robot.at(i * period,
                        *event ? std::vector<std::string>{event} : std::vector<std::string>());
      }
      left += last == "b" ? 1 : 0;
    }
    return left / static_cast<double>(runs);
  };
  // Three standard deviations of 2000 draws: 0.031.
  CHECK(share_left(0.1, "") == Approx(0.3).margin(0.031));
  CHECK(share_left(0.02, "") == Approx(0.3).margin(0.031));
  CHECK(share_left(0.1, "go") == Approx(0.3).margin(0.031));
}

TEST_CASE("States hold states: the innermost decides, and what leaves an outer one leaves all") {
  Robot robot(
      {element("state", {{"name", std::string("work")}},
               {state("dig", "a", {on("full", "carry")}), state("carry", "b", {on("empty", "dig")}),
                on("tired", "rest"), after(10.0, "rest")}),
       state("rest", "c", {on("fresh", "work"), on("hurry", "carry")})});
  CHECK(robot.at(0) == "a");
  CHECK(robot.at(1, {"full"}) == "b");
  CHECK(robot.at(2, {"tired"}) == "c");
  CHECK(robot.at(3, {"fresh"}) == "a");  // in the first of its states again
  CHECK(robot.at(4, {"tired"}) == "c");
  CHECK(robot.at(5, {"hurry"}) == "b");
  CHECK(robot.at(6, {"empty", "tired"}) == "a");  // inner transitions before outer ones
  CHECK(robot.at(14.9) == "a");
  CHECK(robot.at(15) == "c");  // 10 s since the outer state was entered
}

TEST_CASE("Its graph shows states, where they are held, and the present one lit") {
  Robot robot(
      {element("state", {{"name", std::string("work")}}, {state("dig", "a", {on("full", "rest")})}),
       state("rest", "c",
             {element(
                 "transition",
                 {{"to", "work"}, {"when", "battery > 0.5"}, {"after", 2.0}, {"chance", 0.5}})})});
  robot.at(0);
  const Graph graph = (*robot.robot)->graph();
  REQUIRE(graph.nodes.size() == 3);
  CHECK(graph.nodes[1].label == "dig");
  CHECK(graph.nodes[1].within == 0);
  CHECK(graph.nodes[2].within == -1);
  REQUIRE(graph.edges.size() == 2);
  CHECK(graph.edges[0].from == 1);
  CHECK(graph.edges[0].to == 2);
  CHECK(graph.edges[0].label == "full");
  CHECK(graph.edges[1].label == "[battery > 0.5] after 2 s chance 0.5");
  std::vector<NodeState> lights(3);
  (*robot.robot)->light(lights);
  CHECK(lights == std::vector<NodeState>{NodeState::running, NodeState::running, NodeState::dark});
}

TEST_CASE("A state may end the whole, and who waits for it sees how") {
  Robot robot({state("try", "a", {on("good", "done"), on("bad", "lost")}),
               element("state", {{"name", "done"}, {"ends", "success"}}, {on("again", "try")}),
               element("state", {{"name", "lost"}, {"ends", "failure"}})});
  robot.at(0);
  CHECK((*robot.robot)->status() == Status::running);
  CHECK(robot.at(1, {"good"}) == "");
  CHECK(robot.team.reason(0) == "no behavior in this state");
  CHECK((*robot.robot)->status() == Status::success);
  robot.at(2, {"again"});
  robot.at(3, {"bad"});
  CHECK((*robot.robot)->status() == Status::failure);
}

TEST_CASE("Notes name states that are never reached or left, and behaviours of no state") {
  Robot robot({state("one", "a", {on("go", "two")}), state("two", "b"),
               state("island", "b", {on("go", "one")})});
  robot.at(0);
  const std::vector<std::string> notes = (*robot.robot)->notes();
  REQUIRE(notes.size() == 3);
  CHECK_THAT(notes[0], StartsWith("the state 'two' is never left"));
  CHECK_THAT(notes[1], StartsWith("the state 'island' is never reached"));
  CHECK_THAT(notes[2], StartsWith("the behavior 'c' is in no state"));
}

TEST_CASE("A newer library goes on in the same state, as old as it was") {
  const std::vector<ElementValue> states{state("one", "a", {on("go", "two")}),
                                         state("two", "b", {after(2.0, "one")})};
  Robot before(states), next(states);
  before.at(0);
  before.at(1, {"go"});
  next.at(0);
  REQUIRE(next.robot->take_over(*before.robot));
  CHECK(next.at(2.9) == "b");
}

TEST_CASE("A newer library keeps the times of the states around, too") {
  const std::vector<ElementValue> states{
      element("state", {{"name", std::string("work")}},
              {state("one", "a", {on("go", "two")}), state("two", "b"), after(3.0, "rest")}),
      state("rest", "c")};
  Robot before(states), next(states);
  before.at(0);
  CHECK(before.at(2, {"go"}) == "b");
  next.at(0);
  REQUIRE(next.robot->take_over(*before.robot));
  CHECK(next.at(2.9) == "b");
  CHECK(next.at(3.0) == "c");
}

TEST_CASE("Who enters an outer state again enters all that is in it") {
  Robot robot({element("state", {{"name", std::string("outer")}},
                       {element("state", {{"name", std::string("inner")}},
                                {state("one", "a"), after(1.5, "end")}),
                        after(1.0, "outer")}),
               state("end", "b")});
  for (double time = 0.0; time < 10.0; time += 0.1) CHECK(robot.at(time) == "a");
}

TEST_CASE("Automata that mean nothing are refused in words") {
  CHECK_THAT(refusal({}), Contains("it has no states; expected <state> inside it"));
  CHECK_THAT(refusal({state("one", "a"), state("one", "b")}),
             Contains("two states are called 'one'"));
  CHECK_THAT(refusal({state("one", "a", {on("go", "twoo")}), state("two", "b")}),
             Contains("transition[1] of the state 'one' leads to 'twoo', which is no state; did "
                      "you mean 'two'?"));
  CHECK_THAT(
      refusal({state("one", "d")}),
      Contains("<state behavior=\"d\"> names no behaviour of this coordinator; it has: a, b, c"));
  CHECK_THAT(refusal({state("one", "a", {state("two", "b")})}),
             Contains("the state 'one' has a behavior and states in it"));
  CHECK_THAT(refusal({state("one", "a", {element("transition", {{"to", "one"}})})}),
             Contains("says not when; expected event, when, after or chance"));
  CHECK_THAT(refusal({state("one", "a", {when("batery < 1", "one")})}),
             Contains("'batery' is nothing that the robot perceives; did you mean 'battery'?"));
  CHECK_THAT(refusal({state("one", "a", {on("go", "one"), when("ghost > 1", "one")})}),
             Contains("transition[2] of the state 'one': the condition \"ghost > 1\""));
  CHECK_THAT(refusal({state("one", "a"), state("", "b")}), Contains("state[2] has an empty name"));
  CHECK_THAT(refusal({state("one", "a", {when("battery <", "one")})}),
             Contains("transition[1] of the state 'one', when=\"battery <\": column 10: "));
  CHECK_THAT(refusal({state("one", "a", {when("c.y > 1", "one")})}),
             Contains("the behavior 'c' publishes no number 'y'; did you mean 'c.x'?") ||
                 Contains("the behavior 'c' publishes no number 'y'; there are: c.x"));
  CHECK_THAT(refusal({state("one", "a", {when("front_range > 1", "one")})}),
             Contains("'front_range' needs a beam-range sensor"));
  CHECK_THAT(refusal({state("one", "a", {when("ghost.x > 1", "one")})}),
             Contains("the robot has no behavior and no sensor 'ghost'"));
}

}  // namespace of_states
