// The shipped rules.
#include <string>
#include <vector>

#include "elsie/testing/catch.h"

namespace testing = elsie::testing;
using elsie::ObservedObstacle;
using elsie::PluginKind;
using elsie::Pose;
using elsie::RunEnd;
using testing::Elements;
using testing::Rule;
using testing::Scene;
using testing::Settings;
using Texts = std::vector<std::string>;

namespace {

Scene with_food() {
  Scene now;
  now.robot("r1").robot("r2", 2, 0, "blue").resource("food", 1, 2).resource("oats", -1, -2, "blue");
  return now;
}

const Texts kFoodIsBack{"resource[food]/@x=1", "resource[food]/@y=2",
                        "resource[food]/@heading_deg=0"};

std::string why_not(const std::string& name, const Settings& settings,
                    const Elements& elements = {}) {
  try {
    Rule(name, settings, elements).apply(with_food());
  } catch (const std::exception& refused) {
    return refused.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Every shipped rule keeps its promises, whatever it is shown") {
  const auto all = testing::Plugins::found().host().all(PluginKind::rule);
  CHECK(all.size() == 3);
  for (const elsie::Declaration* rule : all) {
    CAPTURE(rule->name);
    testing::CheckOptions options;
    if (rule->name == "referee") {
      options.elements = {{"event", {{"name", "collected"}, {"count", std::int64_t{3}}}},
                          {"outside", {{"radius", 4.5}}},
                          {"closer", {{"distance", 0.2}}}};
    }
    if (rule->name == "timetable") {
      options.elements = {
          {"edit", {{"time", 0.1}, {"every", 0.2}, {"path", "robot[r1]/@x"}, {"value", "0"}}}};
    }
    CHECK_THAT(testing::check_plugin(PluginKind::rule, rule->name, options),
               testing::finds_nothing());
  }
}

TEST_CASE("A collected resource comes back after its time, where it was") {
  Scene now = with_food();
  Rule rule("respawn", {{"after", 0.05}});
  CHECK(rule.apply(now).edits.empty());
  now.remove_obstacle("food");
  for (int step = 1; step <= 5; ++step) CHECK(rule.apply(now.step()).edits.empty());
  CHECK(rule.apply(now.step()).edits == kFoodIsBack);
  Scene back = with_food();
  back.at_step(7);
  CHECK(rule.apply(back).edits.empty());
  back.remove_obstacle("food");
  CHECK(rule.apply(back.step()).edits.empty());  // its time begins anew
}

TEST_CASE("A resource that finds no room tries again a tenth of a second later") {
  Scene now = with_food();
  now.steps_of(0.01);
  Rule rule("respawn", {{"after", 0.0}});
  rule.apply(now);
  now.remove_obstacle("food");
  rule.has_room = [](std::string_view what, const Pose& pose) {
    CHECK(what == "resource[food]");
    CHECK(pose == Pose{1.0, 2.0, 0.0});
    return false;
  };
  CHECK(rule.apply(now.step()).edits.empty());
  rule.has_room = nullptr;
  for (int step = 1; step < 10; ++step) CHECK(rule.apply(now.step()).edits.empty());
  CHECK(rule.apply(now.step()).edits == kFoodIsBack);
}

TEST_CASE("Resources come back at random places of a rectangle with room, so often as allowed") {
  Scene now = with_food();
  Rule rule("respawn", {{"after", 0.0},
                        {"where", "random"},
                        {"x", 1.0},
                        {"length", 2.0},
                        {"width", 1.0},
                        {"limit", std::int64_t{1}}});
  std::vector<Pose> asked;
  rule.has_room = [&](std::string_view, const Pose& pose) {
    CHECK(std::abs(pose.x - 1.0) <= 1.0);
    CHECK(std::abs(pose.y) <= 0.5);
    asked.push_back(pose);
    return asked.size() == 3;
  };
  rule.apply(now);
  now.remove_obstacle("food").remove_obstacle("oats");
  CHECK(rule.apply(now.step()).edits.size() == 3);
  CHECK(asked.size() == 3);
  CHECK_FALSE(asked[0] == asked[1]);
  for (int step = 0; step < 5; ++step) CHECK(rule.apply(now.step()).edits.empty());
}

TEST_CASE("Only the resources that are named come back") {
  const std::vector<Settings> ways{{{"after", 0.0}, {"resource", "food"}},
                                   {{"after", 0.0}, {"team", "blue"}}};
  for (const Settings& settings : ways) {
    Scene now = with_food();
    Rule rule("respawn", settings);
    rule.apply(now);
    now.remove_obstacle("food").remove_obstacle("oats");
    const bool is_food = settings.contains("resource");
    CHECK(rule.apply(now.step()).edits[0] ==
          (is_food ? "resource[food]/@x=1" : "resource[oats]/@x=-1"));
  }
  CHECK(why_not("respawn", {{"resource", "hay"}}) == "there is no resource 'hay' in this world");
  CHECK_THAT(why_not("respawn", {{"resource", "food"}, {"team", "blue"}}),
             Catch::Contains("it names both a resource, 'food', and a team, 'blue'"));
}

TEST_CASE("A referee ends the run when an event was raised often enough") {
  Scene now = with_food();
  Rule rule("referee", {{"team", "red"}},
            {{"event", {{"name", "collision"}, {"count", std::int64_t{2}}}}});
  CHECK(rule.apply(now).outcome == RunEnd::Outcome::running);
  CHECK(
      rule.apply(
              now.step().event("collision", "r1").event("collected", "r1").event("collision", "r2"))
          .outcome == RunEnd::Outcome::running);
  CHECK(rule.apply(now.step()).outcome == RunEnd::Outcome::running);
  const testing::Ruling& ruling = rule.apply(now.step().event("collision", "r1"));
  CHECK(ruling.outcome == RunEnd::Outcome::failure);
  CHECK(ruling.reason == "the event 'collision' was raised 2 times");
  rule.reset();
  CHECK(rule.apply(now.step().event("collision", "r1")).outcome == RunEnd::Outcome::running);
}

TEST_CASE("A referee looks at places, distances and the time") {
  Scene now = with_food();
  const auto ruling = [&](const Elements& elements, const Settings& settings = {}) {
    return Rule("referee", settings, elements).apply(now);
  };
  CHECK(ruling({{"outside", {{"radius", 1.9}}}}).reason ==
        "the robot 'r2' is more than 1.9 m away from (0, 0)");
  CHECK(ruling({{"outside", {{"radius", 2.1}}}}).reason.empty());
  CHECK(ruling({{"outside", {{"radius", 1.9}}}}, {{"robot", "r1"}}).reason.empty());
  CHECK(ruling({{"closer", {{"distance", 2.1}}}}).reason ==
        "the robots 'r1' and 'r2' are closer than 2.1 m");
  CHECK(ruling({{"closer", {{"distance", 2.0}}}}).reason.empty());
  now.at_step(100);
  const auto late = ruling({{"after", {{"time", 1.0}}}}, {{"outcome", "success"}});
  CHECK(late.outcome == RunEnd::Outcome::success);
  CHECK(late.reason == "1 s have passed");
  CHECK(ruling({{"after", {{"time", 1.01}}}}).reason.empty());
  CHECK_THAT(why_not("referee", {}), Catch::Contains("it never ends a run"));
  CHECK_THAT(why_not("referee", {{"robot", "r9"}}, {{"after", {}}}),
             Catch::Contains("there is no robot 'r9'"));
}

TEST_CASE("A timetable edits once, or again and again") {
  Scene now;
  Rule rule(
      "timetable", {},
      {{"edit", {{"time", 0.02}, {"path", "robot[r1]/@energy"}, {"value", "5"}}},
       {"edit", {{"time", 0.01}, {"every", 0.02}, {"path", "obstacle[door]/@x"}, {"value", "1"}}},
       {"edit", {{"time", 0.04}, {"every", 0.001}, {"path", "fast"}, {"value", "2"}}}});
  const std::vector<Texts> expected{{},
                                    {"obstacle[door]/@x=1"},
                                    {"robot[r1]/@energy=5"},
                                    {"obstacle[door]/@x=1"},
                                    {"fast=2"},
                                    {"obstacle[door]/@x=1", "fast=2"}};
  for (int run = 0; run < 2; ++run) {
    for (std::size_t step = 0; step < expected.size(); ++step) {
      CAPTURE(run, step);
      CHECK(rule.apply(now.at_step(static_cast<int>(step))).edits == expected[step]);
    }
    rule.reset();
  }
  CHECK_THAT(why_not("timetable", {}), Catch::Contains("it is empty; expected <edit> inside it"));
}
