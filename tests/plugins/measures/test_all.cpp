// Properties of every measure.
#include <map>

#include "support.h"

namespace testing = elsie::testing;
using elsie::Declaration;
using elsie::ObservedRobot;
using elsie::PluginKind;
using namespace elsie::test;

TEST_CASE("Every shipped measure keeps its promises, whatever it is shown") {
  const std::map<std::string, Settings> needed{{"place_reached", {{"robot", "r1"}}},
                                               {"formation_error", {{"leader", "r1"}}},
                                               {"published", {{"number", "explore.known"}}},
                                               {"reward", {{"of", "collected - collisions"}}}};
  const auto all = testing::Plugins::found().host().all(PluginKind::measure);
  CHECK(all.size() == 15);
  for (const Declaration* measure : all) {
    CAPTURE(measure->name);
    testing::CheckOptions options;
    if (const auto found = needed.find(measure->name); found != needed.end()) {
      options.settings = found->second;
    }
    if (measure->name == "formation_error") {
      options.elements = {{"member", {{"robot", "r2"}, {"x", -0.5}}}};
    }
    CHECK_THAT(testing::check_plugin(PluginKind::measure, measure->name, options),
               testing::finds_nothing());
  }
}

TEST_CASE("Measures about robots take one, those of a team, or all, and know who is there") {
  const std::map<std::string, std::string> values{
      {"path_length", ""}, {"collected", "count"}, {"collisions", "count"}, {"energy", "used"}};
  for (const auto& [name, value] : values) {
    CAPTURE(name);
    const auto of = [&](const Settings& settings) {
      Scene now = three_robots();
      Measure measure(name, settings);
      measure.observe(now);
      double amount = 1.0;
      for (const char* id : {"r1", "r2", "b1"}) {
        ObservedRobot& robot = now[id];
        robot.distance_m = robot.energy_used = amount;
        robot.collected = robot.collisions = static_cast<int>(amount);
        amount *= 10.0;
      }
      measure.observe(now.step());
      return measure.value(value);
    };
    CHECK(of({}) == 111.0);
    CHECK(of({{"team", "red"}}) == 11.0);
    CHECK(of({{"team", "blue"}}) == 100.0);
    CHECK(of({{"robot", "r2"}}) == 10.0);
  }
  for (const char* name :
       {"path_length", "collected", "collisions", "energy", "command_smoothness", "coverage"}) {
    CAPTURE(name);
    const Scene now = three_robots();
    CHECK(refusal(Measure(name, {{"robot", "r9"}}), now) ==
          "there is no robot 'r9' in the world; there are 'r1', 'r2', 'b1'");
    CHECK(refusal(Measure(name, {{"team", "green"}}), now) ==
          "there is no team 'green' in the world; there are 'red', 'blue'");
    CHECK(refusal(Measure(name, {{"robot", "r1"}, {"team", "red"}}), now) ==
          "it names both a robot, 'r1', and a team, 'red'; expected one of them, or none for all "
          "robots");
    CHECK(refusal(Measure(name, {{"team", "idle"}}), Scene(now).team("idle")) ==
          "the team 'idle' has no robot");
    CHECK(refusal(Measure(name), Scene()) == "there is no robot in the world");
  }
}

TEST_CASE("A measure starts again with each run") {
  Scene now = three_robots();
  for (const char* name : {"path_length", "collected", "collisions", "energy"}) {
    CAPTURE(name);
    Measure measure(name);
    measure.observe(now.restart());
    const std::string value = measure.quantities()[0].name;
    Scene later = now;
    later["r1"].distance_m = later["r1"].energy_used = 5.0;
    later["r1"].collected = later["r1"].collisions = 5;
    measure.observe(later.step());
    CHECK(measure.value(value) == 5.0);
    measure.reset();
    CHECK(measure.value(value) == 0.0);
    measure.observe(now);
    CHECK(measure.value(value) == 0.0);
  }
}
