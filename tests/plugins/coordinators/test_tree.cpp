// Behaviour trees.
#include <fstream>
#include <string>
#include <vector>

#include "elsie/files/scratch_folder.h"

#include "support.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

namespace of_trees {
namespace {

using Attributes = std::vector<std::pair<const char*, ParameterValue>>;

ElementValue node(const char* kind, std::vector<ElementValue> inside = {},
                  const Attributes& attributes = {}) {
  ElementValue made{kind, {}, std::move(inside)};
  for (const auto& [name, value] : attributes) made.parameters[name] = value;
  return made;
}
ElementValue run(const std::string& behavior, const Attributes& more = {}) {
  ElementValue made = node("run", {}, more);
  made.parameters["behavior"] = behavior;
  return made;
}
ElementValue condition(const std::string& when) { return node("condition", {}, {{"when", when}}); }

struct Robot {
  explicit Robot(const std::vector<ElementValue>& tree, const Parameters& parameters = {}) {
    double speed = 0.0;
    for (const char* name : {"a", "b", "c"}) team.member(name, 1, Motion{speed += 0.1, 0, 0});
    robot.emplace("arbiter_tree", team, parameters, tree);
  }

  /// Who is running after a tick, with a "+" for success and a "-" for failure of who was asked
  /// but is not: "a+ b".
  std::string tick(double time_s = 0.0, const std::vector<std::string>& events = {}) {
    Situation now = situation;
    now.time(time_s);
    for (const std::string& event : events) now.event(event);
    command = robot->decide(now);
    std::string text;
    for (const Member& member : team.members()) {
      if (!member.trace.asked) continue;
      const Status status = member.trace.status;
      text += (text.empty() ? "" : " ") + std::string(member.name()) +
              (status == Status::success   ? "+"
               : status == Status::failure ? "-"
                                           : "");
    }
    return text;
  }
  void end(std::size_t member, Status status) { team.answer(member).status = status; }
  Status status() { return (*robot)->status(); }

  Situation situation;
  Team team;
  Motion command;
  std::optional<testing::Coordinator> robot;
};

constexpr Status kRunning = Status::running, kSuccess = Status::success, kFailure = Status::failure;

std::string refusal(const std::vector<ElementValue>& tree, const Parameters& parameters = {}) {
  try {
    Robot robot(tree, parameters);
    robot.tick();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("A sequence runs one after the other until one fails") {
  Robot robot({node("sequence", {run("a"), run("b"), run("c")})});
  CHECK(robot.tick() == "a");
  CHECK(robot.status() == kRunning);
  robot.end(0, kSuccess);
  CHECK(robot.tick() == "a+ b");  // the next begins in the same period
  CHECK(robot.command.forward == Approx(0.2));
  CHECK(robot.team.trace(1).share == 1.0);
  CHECK(robot.tick() == "b");  // what is done is not asked again
  robot.end(1, kFailure);
  CHECK(robot.tick() == "b-");
  CHECK(robot.status() == kFailure);
  CHECK(robot.command == Motion{});
  robot.end(1, kSuccess);
  robot.end(2, kSuccess);
  CHECK(robot.tick() == "a+ b+ c+");  // it begins again
  CHECK(robot.status() == kSuccess);
}

TEST_CASE("A fallback runs one after the other until one succeeds") {
  Robot robot({node("fallback", {run("a"), run("b"), run("c")})});
  robot.end(0, kFailure);
  CHECK(robot.tick() == "a- b");
  CHECK(robot.tick() == "b");
  robot.end(1, kFailure);
  robot.end(2, kFailure);
  CHECK(robot.tick() == "b- c-");
  CHECK(robot.status() == kFailure);
  robot.end(2, kSuccess);
  CHECK(robot.tick() == "a- b- c+");
  CHECK(robot.status() == kSuccess);
}

TEST_CASE("Without memory all are ticked again, so that a condition guards what follows") {
  const auto guarded = [](bool memory) {
    Robot robot({node(
        "fallback",
        {node("sequence", {condition("battery > 0.5"), run("a")}, {{"memory", memory}}), run("b")},
        {{"memory", memory}})});
    robot.situation.battery(0.9);
    CHECK(robot.tick() == "a");
    robot.situation.battery(0.1);
    return robot.tick();
  };
  CHECK(guarded(false) == "b");  // reactive: the condition is looked at again
  CHECK(guarded(true) == "a");
}

TEST_CASE("A parallel runs all at once and ends when enough have ended") {
  Robot robot({node("parallel", {run("a"), run("b"), run("c")},
                    {{"successes", std::int64_t{2}}, {"failures", std::int64_t{2}}})});
  CHECK(robot.tick() == "a b c");
  CHECK(robot.command.forward == Approx(0.2));  // the mean of 0.1, 0.2 and 0.3
  CHECK(robot.team.trace(0).share == Approx(1.0 / 3.0));
  robot.end(0, kSuccess);
  CHECK(robot.tick() == "a+ b c");
  CHECK(robot.tick() == "b c");  // who is done waits for the others
  robot.end(1, kSuccess);
  CHECK(robot.tick() == "b+ c");
  CHECK(robot.status() == kSuccess);
  robot.end(0, kFailure);
  robot.end(1, kRunning);
  CHECK(robot.tick() == "a- b c");
  CHECK(robot.status() == kRunning);
  robot.end(1, kFailure);
  CHECK(robot.tick() == "b- c");
  CHECK(robot.status() == kFailure);
}

TEST_CASE("Decorators turn round, try again, repeat, and wait no longer") {
  {
    Robot robot({node("inverter", {run("a")})});
    robot.end(0, kSuccess);
    robot.tick();
    CHECK(robot.status() == kFailure);
    robot.end(0, kFailure);
    robot.tick();
    CHECK(robot.status() == kSuccess);
  }
  {
    Robot robot({node("retry", {run("a")}, {{"times", std::int64_t{3}}})});
    robot.end(0, kFailure);
    for (const Status expected : {kRunning, kRunning, kFailure, kRunning}) {
      CHECK(robot.tick() == "a-");
      CHECK(robot.status() == expected);
    }
    robot.end(0, kSuccess);
    robot.tick();
    CHECK(robot.status() == kSuccess);
  }
  {
    Robot robot({node("repeat", {run("a")}, {{"times", std::int64_t{0}}})});
    robot.end(0, kSuccess);
    for (int i = 0; i < 50; ++i) {
      robot.tick();
      CHECK(robot.status() == kRunning);
    }
    robot.end(0, kFailure);
    robot.tick();
    CHECK(robot.status() == kFailure);
  }
  {
    Robot robot({node("fallback", {node("timeout", {run("a")}, {{"seconds", 2.0}}), run("b")})});
    CHECK(robot.tick(1.0) == "a");
    CHECK(robot.tick(2.9) == "a");
    CHECK(robot.tick(3.0) == "b");
    robot.end(1, kSuccess);
    CHECK(robot.tick(3.1) == "b+");
    CHECK(robot.tick(3.2) == "a");  // it has begun again, and waits as long again
    CHECK(robot.tick(5.1) == "a");
    CHECK(robot.tick(5.2) == "b+");
  }
}

TEST_CASE("Events say that a behaviour is done, not those from before it began") {
  Robot robot({node("sequence", {run("a", {{"success", "there"}, {"failure", "stuck"}}),
                                 run("b", {{"success", "there"}})})});
  CHECK(robot.tick(0, {"there"}) == "a");
  CHECK(robot.tick(1, {"there"}) == "b");  // the event was of a; b begins with it
  CHECK(robot.tick(2) == "b");
  CHECK(robot.tick(3, {"there"}) == "");
  CHECK(robot.status() == kSuccess);
  robot.tick(4);
  robot.tick(5, {"stuck"});
  CHECK(robot.status() == kFailure);
}

TEST_CASE("What is not ticked any more is halted, and begins anew") {
  Robot robot({node("fallback",
                    {node("sequence", {condition("battery > 0.5"), run("c")}),
                     node("sequence", {run("a"), run("b")})},
                    {{"memory", false}})});
  robot.situation.battery(0.1);
  robot.end(0, kSuccess);
  CHECK(robot.tick() == "a+ b");
  CHECK(robot.tick() == "b");
  robot.situation.battery(0.9);
  CHECK(robot.tick() == "c");
  robot.end(2, kFailure);
  CHECK(robot.tick() == "a+ b c-");  // the second sequence from its beginning
}

TEST_CASE("Its graph is the tree, lit by the last tick") {
  Robot robot(
      {node("fallback", {node("sequence", {condition("battery > 0.5"), run("a")}), run("b")},
            {{"name", "main"}})});
  robot.situation.battery(0.1);
  robot.tick();
  const Graph graph = (*robot.robot)->graph();
  std::vector<std::string> labels;
  for (const Graph::Node& each : graph.nodes) labels.push_back(each.label);
  CHECK(labels == std::vector<std::string>{"?* main", "→*", "if battery > 0.5", "a", "b"});
  REQUIRE(graph.edges.size() == 4);
  CHECK(graph.edges[2].from == 1);
  CHECK(graph.edges[2].to == 3);
  std::vector<NodeState> lights(5);
  (*robot.robot)->light(lights);
  CHECK(lights == std::vector<NodeState>{NodeState::running, NodeState::failure, NodeState::failure,
                                         NodeState::dark, NodeState::running});
}

TEST_CASE("A label has the symbol of the node's kind, a * for memory, and its name") {
  Robot robot(
      {node("sequence",
            {node("parallel", {run("a", {{"name", "drive"}})}, {{"name", "charge"}}),
             node("inverter", {node("condition", {}, {{"event", "arrived"}, {"name", "there"}})}),
             node("timeout", {node("retry", {run("b")}, {{"name", "dock"}})}, {{"seconds", 12.0}}),
             node("repeat", {node("fallback", {run("c")}, {{"name", "live"}, {"memory", false}})},
                  {{"times", std::int64_t{0}}})},
            {{"memory", false}})});
  std::vector<std::string> labels;
  for (const Graph::Node& each : (*robot.robot)->graph().nodes) labels.push_back(each.label);
  CHECK(labels == std::vector<std::string>{"→", "⇉ charge", "drive", "¬", "if there",
                                           "timeout 12 s", "retry 3 dock", "b", "repeat", "? live",
                                           "c"});
}

TEST_CASE("What is wrong with a node is said with its path") {
  CHECK_THAT(refusal({node("fallback", {node("sequence", {run("a")}), node("sequence")})}),
             Contains("fallback/sequence[2]: <sequence> has 0 nodes in it"));
  CHECK_THAT(refusal({node("inverter", {condition("battery <")})}),
             Contains("inverter/condition: ") && Contains("column 10"));
  CHECK_THAT(refusal({node("sequence", {run("a"), run("d")})}),
             Contains("sequence/run[2]: <run behavior=\"d\"> names no behaviour"));
}

TEST_CASE("A tree of BehaviorTree.CPP is read from its file") {
  const files::ScratchFolder folder(std::filesystem::temp_directory_path());
  const std::string file = (folder.path() / "tree.xml").string();
  const auto write = [&](const std::string& text) { std::ofstream(file) << text; };
  const auto with_file = [&](std::vector<ElementValue> defines = {}) {
    return Robot(defines, {{"file", file}});
  };
  write(R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <ReactiveFallback name="top">
      <ReactiveSequence><Condition ID="BatteryLow"/><SubTree ID="Rest"/></ReactiveSequence>
      <Sequence><a goal="1;2"/><RetryUntilSuccessful num_attempts="2"><Action ID="b"/></RetryUntilSuccessful></Sequence>
    </ReactiveFallback>
  </BehaviorTree>
  <BehaviorTree ID="Rest"><Timeout msec="1500"><c/></Timeout></BehaviorTree>
</root>)");
  const ElementValue low = node("define", {}, {{"name", "BatteryLow"}, {"when", "battery < 0.2"}});
  Robot robot = with_file({low});
  CHECK(robot.tick(0) == "a");
  robot.end(0, kSuccess);
  CHECK(robot.tick(1) == "a+ b");
  robot.situation.battery(0.1);
  CHECK(robot.tick(2) == "c");
  CHECK(robot.tick(3.4) == "c");
  CHECK(robot.tick(3.5) == "a+ b");
  REQUIRE((*robot.robot)->notes().size() == 1);
  CHECK_THAT((*robot.robot)->notes()[0],
             Contains("tree.xml:5: ") && Contains("goal=\"1;2\" of <a> is left out"));

  const auto why_not = [&](const std::string& text) {
    write(text);
    return refusal({low}, {{"file", file}});
  };
  CHECK_THAT(why_not("<tree/>"), Contains("tree.xml:1: found <tree> as the root element"));
  CHECK_THAT(why_not("<root/>"), Contains("has no <BehaviorTree>"));
  CHECK_THAT(why_not("\n"), Contains("is empty; expected <root>"));
  CHECK_THAT(why_not("<root main_tree_to_execute='A'>\n<BehaviorTree ID='A'><a/></BehaviorTree>\n"
                     "<BehaviorTree ID='A'><b/></BehaviorTree></root>"),
             Contains(":3: there are two <BehaviorTree> of the ID 'A'"));
  CHECK_THAT(why_not("<root><BehaviorTree ID='A'><SubTree ID='B'/></BehaviorTree>\n"
                     "<BehaviorTree ID='B'><SubTree ID='A'/></BehaviorTree></root>"),
             Contains("there are 2 trees; say which is the first"));
  CHECK_THAT(
      why_not("<root main_tree_to_execute='A'>\n<BehaviorTree ID='A'><SubTree ID='B'/>"
              "</BehaviorTree>\n<BehaviorTree ID='B'><SubTree ID='A'/></BehaviorTree></root>"),
      Contains("tree.xml:3: the tree 'A' holds itself"));
  CHECK_THAT(why_not("<root><BehaviorTree ID='A'><Condition ID='Full'/></BehaviorTree></root>"),
             Contains("the condition 'Full' is not known"));
  CHECK_THAT(why_not("<root><BehaviorTree ID='A'><Sequense><a/></Sequense></BehaviorTree></root>"),
             Contains("did you mean 'Sequence'?"));
  CHECK_THAT(why_not("<root><BehaviorTree ID='A'><Timeout><a/></Timeout></BehaviorTree></root>"),
             Contains("<Timeout> lacks msec"));
  CHECK_THAT(why_not("<root><BehaviorTree ID='A'><fly/></BehaviorTree></root>"),
             Contains("tree.xml:1: <run behavior=\"fly\"> names no behaviour"));
  const auto node_refused = [&](const std::string& inner) {
    return why_not("<root><BehaviorTree ID='A'>" + inner + "</BehaviorTree></root>");
  };
  CHECK_THAT(node_refused("<Sequence _skipIf='x'><a/></Sequence>"),
             Contains("the condition _skipIf of <Sequence> is not understood"));
  CHECK_THAT(node_refused("<Timeout msec='-100'><a/></Timeout>"), Contains("above 0"));
  CHECK_THAT(node_refused("<Repeat num_cycles='2.5'><a/></Repeat>"),
             Contains("expected a whole number"));
  CHECK_THAT(node_refused("<Parallel failure_count='0'><a/></Parallel>"),
             Contains("at least one success and one failure"));
  CHECK_THAT(node_refused("<Sequence>text<a/></Sequence>"), Contains("found text in <Sequence>"));
  CHECK_THAT(why_not("<root><include path='x'/></root>"),
             Contains("<root> may not hold <include> here"));
  std::string doubling = "<root main_tree_to_execute='t0'>";
  for (int i = 0; i < 26; ++i) {
    const std::string next = "<SubTree ID='t" + std::to_string(i + 1) + "'/>";
    doubling += "<BehaviorTree ID='t" + std::to_string(i) + "'><Sequence>" + next + next +
                "</Sequence></BehaviorTree>";
  }
  CHECK_THAT(why_not(doubling + "<BehaviorTree ID='t26'><a/></BehaviorTree></root>"),
             Contains("more than 10000 nodes"));
}

TEST_CASE("Trees that mean nothing are refused in words") {
  CHECK_THAT(refusal({}), Contains("it has 0 nodes in it; expected one"));
  CHECK_THAT(refusal({run("a"), run("b")}), Contains("it has 2 nodes in it; expected one"));
  CHECK_THAT(refusal({node("sequence")}), Contains("<sequence> has 0 nodes in it"));
  CHECK_THAT(refusal({node("inverter", {run("a"), run("b")})}),
             Contains("<inverter> has 2 nodes in it; expected one"));
  CHECK_THAT(refusal({node("condition")}), Contains("<condition> needs either when"));
  CHECK_THAT(refusal({run("d")}),
             Contains("<run behavior=\"d\"> names no behaviour of this coordinator"));
  CHECK_THAT(refusal({node("parallel", {run("a")}, {{"successes", std::int64_t{2}}})}),
             Contains("waits for more nodes than the 1 in it"));
  CHECK_THAT(refusal({condition("batery > 1")}), Contains("did you mean 'battery'?"));
}

TEST_CASE("What a parallel halts in the tick in which it ends has no part in the command") {
  Robot robot({node("fallback", {node("parallel", {run("a"), run("c")}), run("b")})});
  CHECK(robot.tick() == "a c");
  robot.end(2, kFailure);
  CHECK(robot.tick() == "a b c-");
  CHECK(robot.team.reason(0) == "halted");
  CHECK(robot.team.trace(0).share == 0.0);
  CHECK(robot.command.forward == Approx(0.2));
}

TEST_CASE("A newer library goes on where the tree was") {
  const std::vector<ElementValue> tree{
      node("sequence", {run("a"), node("timeout", {run("b")}, {{"seconds", 2.0}})})};
  Robot before(tree), next(tree), other({node("sequence", {run("c")})});
  before.end(0, kSuccess);
  CHECK(before.tick(1.0) == "a+ b");
  next.tick(0.0);
  REQUIRE(next.robot->take_over(*before.robot));
  CHECK(next.tick(2.9) == "b");
  CHECK(next.tick(3.0) == "");
  CHECK(next.status() == kFailure);
  other.tick(0.0);
  REQUIRE(other.robot->take_over(*before.robot));  // a tree of another shape begins anew
  CHECK(other.tick(1.0) == "c");
}

}  // namespace of_trees
