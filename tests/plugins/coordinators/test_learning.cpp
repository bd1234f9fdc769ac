// Which behaviour decides is learned from rewards.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "elsie/learning/reward_learner.h"

#include "folder.h"
#include "support.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;
using Catch::EndsWith;
using Catch::Equals;
using Catch::StartsWith;
using learning::Ending;
using learning::Values;
using learning::ValueTable;

namespace of_learning {
namespace {

ElementValue feature(const std::string& of, std::vector<double> at = {0.5},
                     const std::string& name = "") {
  return {"feature", {{"of", of}, {"at", std::move(at)}, {"name", name}}};
}

/// A robot with the behaviours a, b, and perhaps c, whose states are its places: x = 0, 1, 2...
struct Robot {
  explicit Robot(Parameters parameters = {{"untrained", true}},
                 const std::vector<ElementValue>& features = {feature("x")}, int members = 2) {
    for (int i = 0; i < members; ++i) {
      team.member(std::string(1, static_cast<char>('a' + i)), 1, Motion{0.1 * (i + 1), 0, 0});
    }
    parameters.try_emplace("values", std::string());
    robot.emplace("arbiter_learning", team, parameters, features);
    robot->equip(situation);
    robot->reset();
  }

  learning::RewardLearner& learner() { return dynamic_cast<learning::RewardLearner&>(**robot); }
  /// The number of the behaviour that decides at this time and place.
  std::size_t at(double time_s, double x) {
    situation.at(x, 0, 0).time(time_s);
    robot->decide(situation);
    for (std::size_t i = 0; i < team.size(); ++i) {
      if (team.trace(i).share == 1.0) return i;
    }
    return team.size();
  }

  Situation situation;
  Team team;
  std::optional<testing::Coordinator> robot;
};

/// What follows from an action in a state: the rewards, and the next state.
struct Outcome {
  std::vector<double> rewards;
  std::size_t next;
};
using Process = std::function<Outcome(std::size_t state, std::size_t action)>;

/// Learns in a process with so many choices of a second each, in control periods of this length;
/// all rewards of a choice come in its first period.
Values learned(const Process& process, Parameters parameters, int choices,
               const std::vector<ElementValue>& features = {feature("x")}, int periods = 1,
               double exploration = 1.0, int members = 2) {
  parameters["untrained"] = true;
  Robot robot(parameters, features, members);
  const double period = 1.0 / periods;
  robot.situation.period(period);
  const std::vector<double> nothing(process(0, 0).rewards.size(), 0.0);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < nothing.size(); ++i) names.push_back("r" + std::to_string(i));
  robot.learner().begin(names, {}, exploration, Random(5));
  std::size_t state = 0;
  for (int choice = 0; choice < choices; ++choice) {
    Outcome outcome;
    std::size_t chosen = 0;
    for (int i = 0; i < periods; ++i) {
      const std::size_t action = robot.at(choice + i * period, static_cast<double>(state));
      if (i == 0) {
        chosen = action;
        outcome = process(state, action);
      }
      REQUIRE(action == chosen);
      robot.learner().learned(i == 0 ? outcome.rewards : nothing);
    }
    state = outcome.next;
  }
  return robot.learner().finish(Ending::cut_off);
}

/// Optimal values of a process of two states and two actions, by value iteration (Bellman, 1957).
ValueTable by_value_iteration(const Process& process, double discount) {
  ValueTable values(2, 2);
  for (int i = 0; i < 2000; ++i) {
    const ValueTable before = values;
    for (std::size_t state = 0; state < 2; ++state) {
      for (std::size_t action = 0; action < 2; ++action) {
        const Outcome outcome = process(state, action);
        values.at(state, action) = outcome.rewards[0] + discount * before.most(outcome.next);
      }
    }
  }
  return values;
}

/// Staying where one is gives little at place 0 and more at place 1; the way there costs something.
Outcome two_places(std::size_t state, std::size_t action) {
  if (state == 0) return action == 0 ? Outcome{{1.0}, 0} : Outcome{{-0.5}, 1};
  return action == 0 ? Outcome{{0.0}, 0} : Outcome{{2.0}, 1};
}

/// Files of values in a folder of their own.
std::string written(const Folder& folder, const Values& values) {
  const std::string path = folder.file("learned");
  learning::write_values(values, path);
  return path;
}

/// Values for two behaviours and the feature x.
Values some_values(const std::string& method = "q") {
  ValueTable table(2, 2);
  table.at(0, 0) = 1.0;
  table.at(0, 1) = 3.25;
  table.at(1, 0) = -1.0;
  table.at(1, 1) = -2.0;
  return {{{"value", table}}, {{"method", method}, {"behaviors", "a b"}, {"features", "x at 0.5"}}};
}

std::string refusal(Parameters parameters,
                    const std::vector<ElementValue>& features = {feature("x")}, int members = 2) {
  try {
    Robot robot(std::move(parameters), features, members);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Q-learning finds the optimal values of a decision process") {
  for (const double discount : {0.5, 0.9}) {
    CAPTURE(discount);
    const ValueTable optimal = by_value_iteration(two_places, discount);
    const Values found = learned(two_places, {{"discount", discount}, {"rate", 0.5}}, 4000);
    REQUIRE(found.tables.size() == 1);
    for (std::size_t state = 0; state < 2; ++state) {
      for (std::size_t action = 0; action < 2; ++action) {
        CHECK(found.tables[0].values.at(state, action) ==
              Approx(optimal.at(state, action)).margin(1e-9));
      }
    }
  }
  // With much discount it stays at place 0, with little it goes to place 1.
  CHECK(by_value_iteration(two_places, 0.3).best(0) == 0);
  CHECK(learned(two_places, {{"discount", 0.3}, {"rate", 0.5}}, 4000).tables[0].values.best(0) ==
        0);
  CHECK(by_value_iteration(two_places, 0.9).best(0) == 1);
}

TEST_CASE("Q-learning learns from the sum of all rewards") {
  const auto split = [](std::size_t state, std::size_t action) {
    const Outcome whole = two_places(state, action);
    return Outcome{{whole.rewards[0] - 3.0, 3.0}, whole.next};
  };
  const Values found = learned(split, {{"rate", 0.5}, {"discount", 0.5}}, 4000);
  REQUIRE(found.tables.size() == 1);
  CHECK(found.tables[0].values.at(0, 0) ==
        Approx(by_value_iteration(two_places, 0.5).at(0, 0)).margin(1e-9));
  CHECK(found.remark("rewards") == "r0 r1");
}

TEST_CASE("What is learned does not depend on the control period") {
  const Values by_seconds = learned(two_places, {{"discount", 0.8}}, 500);
  for (const int periods : {2, 10}) {
    CAPTURE(periods);
    const Values found = learned(two_places, {{"discount", 0.8}}, 500, {feature("x")}, periods);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(found.tables[0].values.at(i / 2, i % 2) ==
            Approx(by_seconds.tables[0].values.at(i / 2, i % 2)).margin(1e-9));
    }
  }
}

TEST_CASE("Rewards during a choice are discounted by when they come") {
  Robot robot({{"untrained", true}, {"rate", 1.0}, {"discount", 0.5}, {"hold", 10.0}});
  robot.situation.period(1.0);
  robot.learner().begin({"r"}, {}, 0.0, Random(1));
  for (int second = 0; second < 3; ++second) {
    robot.at(second, 0);
    robot.learner().learned(std::vector<double>{8.0});
  }
  CHECK(robot.learner().finish(Ending::goal).tables[0].values.at(0, 0) == 8.0 + 4.0 + 2.0);
}

TEST_CASE("After a goal nothing follows; a limit of time only cuts off what would have") {
  const auto ended = [](Ending ending) {
    Robot robot({{"untrained", true}, {"rate", 1.0}, {"discount", 0.5}});
    robot.situation.period(1.0);
    robot.learner().begin({"r"}, some_values(), 0.0, Random(1));
    robot.at(0, 0);
    robot.learner().learned(std::vector<double>{1.0});
    return robot.learner().finish(ending).tables[0].values.at(0, 1);
  };
  CHECK(ended(Ending::goal) == 1.0);
  CHECK(ended(Ending::cut_off) == 1.0 + 0.5 * 3.25);
}

TEST_CASE("W-learning: who has most to lose leads, and that differs from state to state") {
  // In state 0 the first agent loses 1 and the second 10, in state 1 it is the other way round.
  const auto process = [](std::size_t state, std::size_t action) {
    const double small = action == 0 ? 1.0 : 0.0, large = action == 0 ? 0.0 : 10.0;
    return state == 0 ? Outcome{{small, large}, 1} : Outcome{{10.0 - large, 1.0 - small}, 0};
  };
  const Values found =
      learned(process, {{"method", std::string("w")}, {"discount", 0.01}, {"rate", 0.2}}, 4000,
              {feature("x")}, 1, 0.3);
  REQUIRE(found.tables.size() == 3);
  CHECK(found.tables[0].name == "r0");
  CHECK(found.tables[2].name == "W");
  const ValueTable& weights = found.tables[2].values;
  CHECK(weights.best(0) == 1);
  CHECK(weights.best(1) == 0);
  CHECK(weights.at(0, 0) == Approx(1.0).margin(0.1));  // what it loses to the other one
  CHECK(weights.at(0, 1) == Approx(10.0).margin(1.0));
}

TEST_CASE("W-learning minimises the worst loss, and Q-learning the sum of all losses") {
  // One agent loses 3 by b, two agents lose 2 each by a.
  const auto process = [](std::size_t state, std::size_t action) {
    return action == 0 ? Outcome{{3.0, 0.0, 0.0}, state} : Outcome{{0.0, 2.0, 2.0}, state};
  };
  const auto decides = [&](const char* method) {
    const Folder folder;
    const Values found =
        learned(process, {{"method", std::string(method)}, {"discount", 0.5}, {"rate", 0.2}}, 3000,
                {feature("x")}, 1, 0.3);
    Robot robot({{"method", std::string(method)}, {"values", written(folder, found)}});
    return robot.at(0, 0);
  };
  CHECK(decides("w") == 0);
  CHECK(decides("q") == 1);
}

TEST_CASE("A choice holds for a while, unless the state changes") {
  Robot robot({{"untrained", true}, {"hold", 0.5}}, {feature("x", {0.5, 1.5})}, 3);
  robot.situation.period(0.1);
  robot.learner().begin({"r"}, {}, 1.0, Random(3));
  int changes = 0;
  std::size_t last = 9;
  for (int i = 0; i < 1000; ++i) {
    const bool may_change = i % 5 == 0;
    const std::size_t now = robot.at(0.1 * i, 0);
    if (!may_change) CHECK(now == last);
    changes += now != last ? 1 : 0;
    last = now;
    robot.learner().learned(std::vector<double>{0.0});
  }
  CHECK(changes > 100);
  changes = 0;
  for (int i = 1000; i < 1200; ++i) {  // another state each time
    const std::size_t now = robot.at(0.1 * i, i % 3);
    changes += now != last ? 1 : 0;
    last = now;
  }
  CHECK(changes > 80);
}

TEST_CASE("Without exploration and in a run it takes the largest value, of equal ones the first") {
  const Folder folder;
  Robot robot({{"values", written(folder, some_values())}});
  CHECK(robot.at(0, 0) == 1);
  CHECK(robot.at(0.1, 1) == 0);
  Robot untrained;
  CHECK(untrained.at(0, 0) == 0);
  CHECK_THAT((*untrained.robot)->notes().at(0), StartsWith("It is untrained"));
}

TEST_CASE("The trace says the values in the state, and why") {
  const Folder folder;
  Robot robot({{"values", written(folder, some_values())}}, {feature("x", {0.5}, "far")});
  robot.at(0, 0);
  CHECK(robot.team.reason(1) == "value 3.25, best in state not far");
  CHECK(robot.team.trace(1).weight == 2.25);  // above the least value
  CHECK(robot.team.trace(1).share == 1.0);
  CHECK(robot.team.reason(0) == "value 1");
  CHECK(robot.team.trace(0).weight == 0.0);
  CHECK(robot.team.trace(0).inhibited_by == 1);
  CHECK(robot.team.asked("a") == 0);
  robot.at(0.1, 1);
  CHECK(robot.team.reason(0) == "value -1, best in state far");

  Values several = some_values("w");
  several.tables = {
      {"food", several.tables[0].values}, {"harm", ValueTable(2, 2)}, {"W", ValueTable(2, 2)}};
  several.tables[2].values.at(0, 0) = 0.5;
  Robot agents({{"method", std::string("w")}, {"values", written(folder, several)}});
  agents.at(0, 0);
  CHECK(agents.team.reason(1) == "food leads, W 0.5: value 3.25, best in state not x");

  Robot tries;
  tries.learner().begin({"r"}, {}, 1.0, Random(1));
  CHECK_THAT(tries.team.reason(tries.at(0, 0)), Equals("value 0, tried in state not x"));
}

TEST_CASE("A state is a level of each feature: how many thresholds are reached") {
  Robot robot({{"untrained", true}},
              {feature("x", {1.0, 2.0, 3.0}), feature("battery < 0.5", {0.5}, "hungry")});
  const auto state = [&](double x, double battery) {
    robot.situation.battery(battery);
    return robot.team.reason(robot.at(0, x));
  };
  CHECK_THAT(state(0, 1), EndsWith("in state x 0 & not hungry"));
  CHECK_THAT(state(1, 1), EndsWith("in state x 1 & not hungry"));
  CHECK_THAT(state(2.5, 1), EndsWith("in state x 2 & not hungry"));
  CHECK_THAT(state(9, 0.1), EndsWith("in state x 3 & hungry"));
}

TEST_CASE("A number that is not there reaches no threshold") {
  Team team;
  double published = std::nan("");
  team.member("a", 1, Motion{}).publishes("gap", [&] { return published; });
  Coordinated robot("arbiter_learning", team, {{"untrained", true}, {"values", std::string()}},
                    {feature("a.gap", {-5.0, 5.0})});
  robot.decide();
  CHECK_THAT(team.reason(0), EndsWith("in state a.gap 0"));
  published = 7.0;
  robot.decide_at(0.1);
  CHECK_THAT(team.reason(0), EndsWith("in state a.gap 2"));
}

TEST_CASE("A run changes no values") {
  const Folder folder;
  const std::string file = written(folder, some_values());
  const std::string before = folder.read("learned");
  Robot robot({{"values", file}});
  for (int i = 0; i < 1000; ++i) {
    robot.at(i, i % 2);
    CHECK(robot.team.reason(0) == (i % 2 == 0 ? "value 1" : "value -1, best in state x"));
  }
  CHECK(folder.read("learned") == before);
  CHECK((*robot.robot)->notes() ==
        std::vector<std::string>{"Values of learned; nothing is learned."});
}

TEST_CASE("The same rewards and numbers give the same values, bit for bit") {
  const Values one = learned(two_places, {}, 300), two = learned(two_places, {}, 300);
  CHECK(learning::values_text(one) == learning::values_text(two));
}

TEST_CASE("A newer library goes on with the same choice") {
  const Folder folder;
  const Parameters parameters{{"values", written(folder, some_values())}, {"hold", 5.0}};
  Robot before(parameters), next(parameters);
  before.at(0, 0);
  next.at(0, 1);
  REQUIRE(next.robot->take_over(*before.robot));
  CHECK(next.at(1, 0) == 1);
  CHECK(next.team.reason(1) == "value 3.25, best in state not x");
}

TEST_CASE("Inside a blend it hands the wishes of who decides outwards") {
  Team team;
  team.member("a", 1, Motion{0.1, 0, 0}).rating([](const Motion&) { return 0.25; });
  Coordinated robot("arbiter_learning", team, {{"untrained", true}, {"values", std::string()}},
                    {feature("x")});
  robot.decide();
  CHECK(robot.rate({Motion{}}) == std::vector<double>{0.25});
}

TEST_CASE("In an episode its behaviours stay the same, in a run they may change") {
  Robot robot;
  const auto equip_with = [&](const char* second) {
    Team other;
    other.member("a", 1, Motion{}).member(second, 1, Motion{});
    (*robot.robot)->equipped(other.members(), robot.situation.perception());
  };
  robot.learner().begin({"r"}, {}, 0.0, Random(1));
  CHECK_THROWS_WITH(equip_with("c"),
                    Equals("its behaviours or features changed while it was learning"));
  CHECK_NOTHROW(equip_with("b"));
  robot.learner().finish(Ending::goal);
  CHECK_NOTHROW(equip_with("c"));
}

TEST_CASE("In a run the file is read again only for other behaviours") {
  const Folder folder;
  Robot robot({{"values", written(folder, some_values())}});
  Values others = some_values();
  others.tables[0].values.at(0, 0) = 9.0;
  written(folder, others);
  robot.robot->equip(robot.situation);  // as with another sensor
  CHECK(robot.at(0, 0) == 1);
  CHECK(robot.team.reason(0) == "value 1");
  Team other;
  other.member("a", 1, Motion{}).member("c", 1, Motion{});
  CHECK_THROWS_WITH((*robot.robot)->equipped(other.members(), robot.situation.perception()),
                    Contains("it was learned with the behaviors 'a b', but here it is 'a c'"));
}

TEST_CASE("White space in a feature does not count") {
  const Folder folder;
  Robot robot({{"untrained", true}}, {feature(" x\n+  0\t"), feature("y")});
  robot.learner().begin({"r"}, {}, 0.0, Random(1));
  const Values values = robot.learner().finish(Ending::goal);
  CHECK(values.remark("features") == "x + 0 at 0.5; y at 0.5");
  const Parameters learned{{"values", written(folder, values)}};
  CHECK(refusal(learned, {feature(" x\n+  0\t"), feature("y")}).empty());
  CHECK(refusal(learned, {feature("x + 0"), feature(" y")}).empty());
}

TEST_CASE("Without behaviours nobody decides") {
  Robot robot({{"untrained", true}}, {feature("x")}, 0);
  CHECK(robot.robot->decide() == Motion{});
  for (const auto& number : robot.robot->declaration().published) {
    CHECK(std::isnan(number.get(**robot.robot)));
  }
  CHECK_THROWS_WITH(robot.learner().begin({"r"}, {}, 0.0, Random(1)),
                    Contains("it has no behaviours to choose from"));
}

TEST_CASE("What it cannot learn, or decide by, is refused in words") {
  const Folder folder;
  CHECK_THAT(refusal({}), StartsWith("it has no values: train it with `elsie train WORLD --values "
                                     "FILE`"));
  const Parameters fresh{{"untrained", true}};
  CHECK_THAT(refusal(fresh, {}), Contains("it has no features, by which it tells states apart; "
                                          "expected <feature> inside it"));
  CHECK_THAT(refusal(fresh, {feature("batery")}),
             Contains("the feature \"batery\", column 1: 'batery' is nothing that the robot "
                      "perceives; did you mean 'battery'?"));
  CHECK_THAT(refusal(fresh, {feature("battery <")}),
             Contains("<feature of=\"battery <\">: column 10: "));
  CHECK_THAT(refusal(fresh, {feature("x", {2.0, 1.0})}),
             Contains("<feature of=\"x\">: expected thresholds in ascending order in at"));
  CHECK_THAT(refusal(fresh, {feature("x", {})}), Contains("expected thresholds"));
  CHECK_THAT(refusal(fresh, std::vector<ElementValue>(17, feature("x"))),
             Contains("its features have more than 65536 states together"));
  CHECK_THAT(refusal({{"method", std::string("r")}}), Contains("method"));

  const std::string file = written(folder, some_values());
  const Parameters learned{{"values", file}};
  CHECK(refusal(learned).empty());
  CHECK_THAT(refusal(learned, {feature("x", {0.75})}),
             Equals(file + ": it was learned with the features 'x at 0.5', but here it is 'x at "
                           "0.75'; train again with elsie train, or restore that"));
  CHECK_THAT(refusal(learned, {feature("x")}, 3),
             Contains("it was learned with the behaviors 'a b', but here it is 'a b c'"));
  CHECK_THAT(refusal({{"values", file}, {"method", std::string("w")}}),
             Contains("it was learned with the method 'q', but here it is 'w'"));
  Values crippled = some_values();
  crippled.tables[0].values = ValueTable(3, 2);
  CHECK_THAT(refusal({{"values", written(folder, crippled)}}),
             Contains("its tables are not of 2 states and 2 behaviours"));
  CHECK_THAT(refusal({{"values", folder.write("w", "elsie network 1\n")}}),
             Contains("w:1: this is no file of values"));

  Robot robot({{"untrained", true}, {"method", std::string("w")}});
  CHECK_THROWS_WITH(robot.learner().begin({"r"}, {}, 0.0, Random(1)),
                    Contains("with method=\"w\" rewards compete; its robot has one"));
  CHECK_THROWS_WITH(robot.learner().learned(std::vector<double>{1.0}),
                    Contains("was made again, by an edit in the run"));
  robot.learner().begin({"r", "s"}, {}, 0.0, Random(1));
  CHECK_THROWS_WITH(robot.learner().learned(std::vector<double>{1.0, 2.0, 3.0}),
                    Equals("it got 3 rewards, but its episode began with 2"));
  const Values of_two = robot.learner().finish(Ending::goal);
  for (const std::vector<std::string>& rewards :
       {std::vector<std::string>{"r", "s", "t"}, {"s", "r"}}) {
    CHECK_THROWS_WITH(robot.learner().begin(rewards, of_two, 0.0, Random(1)),
                      Contains("what was learned before does not fit it any more"));
  }
}

}  // namespace of_learning
