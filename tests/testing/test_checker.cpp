#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "elsie/learning/values.h"
#include "elsie/testing/catch.h"

#include "folder.h"
#include "places.h"

using namespace elsie;
using elsie::testing::check_plugin;
using elsie::testing::CheckOptions;
using elsie::testing::finds_nothing;
using elsie::testing::Plugins;

namespace {

const Plugins& broken() {
  static const Plugins plugins{test::build_path("tests/testing/plugins/broken_plugins.so")};
  return plugins;
}

// As in the plugin "lonely".
struct RareReading {
  static constexpr const char* kind = "rare";
  double value = 0.0;
};

struct Fault {
  PluginKind kind;
  const char* name;
  const char* finding;
};
constexpr PluginKind kBehavior = PluginKind::behavior;
constexpr PluginKind kCoordinator = PluginKind::coordinator;
constexpr PluginKind kSensor = PluginKind::sensor;
constexpr PluginKind kMeasure = PluginKind::measure;
constexpr PluginKind kDrive = PluginKind::drive;
constexpr PluginKind kActuator = PluginKind::actuator;

const Fault kFaults[] = {
    {kDrive, "deep", "The part 'left_wheel' of a robot's body is below the floor."},
    {kDrive, "floating", "The part 'left_wheel' of a robot's body is in the air"},
    {kDrive, "racing", "m/s, and the most is 0.5 m/s"},
    {kDrive, "boasting", "odometry() of the joints that command() set is"},
    {kDrive, "creeping", "command() for the motion that it returned is"},
    {kMeasure, "counts_on", "reset() must forget"},
    {kMeasure, "keeps_all", "its memory grows with the number of steps"},
    {kMeasure, "counts_calls", "report() answers differently when it is called once more"},
    {kMeasure, "dividing", "its own value is inf, which is no finite number"},
    {kMeasure, "twins", "two of its values have the name 'one'"},
    {kMeasure, "choosy", "refused every world that it was offered"},
    {kBehavior, "board", "must not share state (a static or a global)"},
    {kBehavior, "follower", "must not share state (a static or a global)"},
    {kBehavior, "turns_by_way", "parameter 'offset_m' has the unit 'deg', but its name says 'm'"},
    {kBehavior, "shares_static", "state that all objects share (a static or a global)"},
    {kBehavior, "shares_quietly", "while another object of it works on something else"},
    {kBehavior, "scratch", "while another object of it works in another thread"},
    {kBehavior, "address", "two objects answer the same input differently"},
    {kBehavior, "clock", "uses a clock"},
    {kBehavior, "other_random", "random numbers other than now.random()"},
    {kBehavior, "forgetless", "reset() must forget"},
    {kBehavior, "rarely_forgetless", "reset() must forget"},
    {kBehavior, "half_forgets",
     "what remember() names continues differently: remember() must name everything that outlives a "
     "step: in step 75 (at 0.75 s) its turn is -1, and was -76"},
    {kBehavior, "refuses_memory", "remember() fails, or what follows it: that is too long ago"},
    {kBehavior, "not_a_number", "nan, which is no finite number"},
    {kBehavior, "at_the_bound",
     "its forward speed is inf, which is no finite number (distance = 0"},
    {kBehavior, "undeclared", "raises the event 'surprise', which its declaration does not name"},
    {kBehavior, "acts_undeclared",
     "it gives a command of the kind 'led', which its declaration does not name; add "
     "elsie::commands<...>() to it"},
    {kBehavior, "enchanted", "nan, which is no finite number"},
    {kBehavior, "eavesdrops",
     "it reads messages of the kind 'tune', which its declaration does not name; add "
     "elsie::hears<...>() to it"},
    {kBehavior, "overactive", "its activation is 1.5, which is not in [0, 1]"},
    {kBehavior, "bad_rating", "its rating of a candidate command is -0.1"},
    {kBehavior, "bad_sets", "not in ascending order: 0 comes after 1"},
    {kBehavior, "throws", "in step 11 (at 0.11 s) it throws: out of ideas"},
    {kBehavior, "grows", "its memory grows with the number of steps"},
    {kBehavior, "leaks", "leave memory behind when they are destroyed: "},
    {kBehavior, "configured_twice",
     "after configured() was called once more it answers differently"},
    {kBehavior, "unsteady_default",
     "parameter 'speed' of a new object is not what the declaration"},
    {kBehavior, "refuses_defaults", "it refuses its defaults: "},
    {kBehavior, "refuses_robots", "it refused every robot that it was offered"},
    {kBehavior, "lonely", "needs readings of the kind 'rare', but no sensor that was found"},
    {kBehavior, "no_meaning", "parameter 'speed' has no meaning"},
    {kBehavior, "no_unit", "parameter 'speed' is a number without a unit"},
    {kBehavior, "other_unit", "has the unit 'rad', but its name says 'deg'"},
    {kBehavior, "wordless_event", "event 'something' has no meaning"},
    {kCoordinator, "too_much", "the shares in its trace add up to"},
    {kCoordinator, "overreaches", "resolve() chooses wish 3 of 2"},
    {kCoordinator, "divides", "which is no finite number"},
    {kCoordinator, "remembers", "reset() must forget"},
    {kBehavior, "scrawling", "it throws: it draws a place that is not finite"},
    {kSensor, "infinite", "it throws: the number 'value' of its reading is inf"},
    {kSensor, "varying", "lists 1 names, and 2 before"},
    {kSensor, "radio", "it answers differently while the behavior 'gossip' of its library works"},
    {kActuator, "boundless", "its reach is inf, which is no finite number"},
    {kActuator, "loud", "the range of its message is nan, which is no finite number"},
    {kActuator, "fading", "reset() must forget"},
    {kSensor, "shared_noise", "two objects answer the same input differently"},
};

}  // namespace

TEST_CASE("The checker reports the fault of a plugin, once, and names it", "[release]") {
  for (const Fault& fault : kFaults) {
    CAPTURE(fault.name);
    const auto findings = check_plugin(fault.kind, fault.name, {}, broken());
    CAPTURE(findings);
    REQUIRE(findings.size() == 1);
    CHECK_THAT(findings[0], Catch::Contains(fault.finding));
    CHECK_THAT(findings[0], Catch::Contains("'" + std::string(fault.name) + "': "));
  }
}

TEST_CASE("Each plugin that is broken on purpose is in the list") {
  std::set<std::string> listed{"sound", "scratch_alone", "gossip"};
  for (const Fault& fault : kFaults) {
    listed.insert(fault.name);
  }
  for (const PluginKind kind : {kBehavior, kCoordinator, kSensor, kDrive, kActuator}) {
    for (const Declaration* declaration : broken().host().all(kind)) {
      if (broken().host().file_of(kind, declaration->name).stem() == "broken_plugins") {
        CHECK(listed.count(declaration->name) == 1);
      }
    }
  }
}

TEST_CASE("The checker finds nothing in a sound plugin, whatever the seed") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CheckOptions options;
    options.seed = seed;
    CHECK_THAT(check_plugin(kBehavior, "sound", options, broken()), finds_nothing());
    CHECK_THAT(check_plugin(kDrive, "sound", options, broken()), finds_nothing());
  }
}

TEST_CASE("A plugin that wants one thread is not tried in two") {
  CHECK_THAT(check_plugin(kBehavior, "scratch_alone", {}, broken()), finds_nothing());
}

TEST_CASE("Readings of a kind that no sensor makes can be handed to the checker") {
  CheckOptions options;
  options.add_readings = [](testing::Situation& now, Random& random) {
    now.reading(RareReading{random.uniform()});
  };
  CHECK_THAT(check_plugin(kBehavior, "lonely", options, broken()), finds_nothing());
}

TEST_CASE("The checker tries the robot that it is given") {
  CheckOptions options;
  options.robots = {testing::Situation().beam(0, 0.5)};  // wall_follow also needs one to the side
  const auto refused = check_plugin(kBehavior, "wall_follow", options);
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0], Catch::Contains("refused every robot") &&
                             Catch::Contains("one that looks to the right"));
  options.robots[0].beam(-90, 0.3);
  CHECK_THAT(check_plugin(kBehavior, "wall_follow", options), finds_nothing());
}

TEST_CASE("A plugin that is not there is no finding") {
  CHECK_THROWS_WITH(check_plugin(kBehavior, "wandr"), Catch::Contains("did you mean 'wander'?"));
}

namespace {

ElementValue state(const char* name, const char* behavior, const char* next) {
  const ElementValue after{"transition", {{"to", std::string(next)}, {"after", 0.05}}};
  return {"state", {{"name", std::string(name)}, {"behavior", std::string(behavior)}}, {after}};
}
ElementValue run(const char* behavior) { return {"run", {{"behavior", std::string(behavior)}}}; }

}  // namespace

TEST_CASE("All shipped plugins pass the checker") {
  const test::Folder folder;
  for (const PluginKind kind : {kBehavior, kCoordinator, kSensor, kDrive, kActuator}) {
    for (const Declaration* declaration : Plugins::found().host().all(kind)) {
      const std::string& name = declaration->name;
      CAPTURE(name);
      CheckOptions options;
      if (name == "fusion_context_blending") {
        options.settings = {{"model", "fuzzy_models/contexts_of_travel.fcl"}};
        options.members = {"go_to_point", "avoid_obstacle", "recharge"};
      } else if (name == "arbiter_states") {
        options.members = {"low", "high"};
        options.elements = {state("a", "low", "b"), state("b", "high", "a")};
      } else if (name == "arbiter_tree") {
        options.members = {"low", "high"};
        options.elements = {{"fallback",
                             {{"memory", false}},
                             {{"sequence", {}, {run("low"), run("high")}}, run("high")}}};
      } else if (name == "remote" || name == "arbiter_remote") {
        options.settings = {{"timeout", 60.0},
                            {"command",
                             "while read -r line; do case $line in *'\"time\":'*) echo "
                             "'{\"forward\":0.1}';; *'\"end\"'*) ;; *) echo '{}';; esac; done"}};
        options.variants = 5;
        options.steps = 500;  // each is a question to another process
      } else if (name == "arbiter_learning") {
        options.members = {"low", "high"};
        options.settings = {{"values", folder.file("learned.values")}};
        options.elements = {{"feature", {{"of", std::string("x")}, {"at", std::vector{0.0}}}}};
        learning::ValueTable table(2, 2);
        table.at(0, 1) = table.at(1, 0) = 1.0;
        learning::write_values(
            {{{"value", table}},
             {{"method", "q"}, {"behaviors", "low high"}, {"features", "x at 0"}}},
            std::get<std::string>(options.settings.at("values")));
      }
      CHECK_THAT(check_plugin(kind, name, options), finds_nothing());
    }
  }
}

TEST_CASE("Subsumption passes with layers that suppress and inhibit each other") {
  CheckOptions options;
  options.members = {"low", "middle", "high"};
  options.elements = {{"suppress", {{"by", "high"}, {"of", "low"}, {"hold", 0.05}}},
                      {"inhibit", {{"by", "middle"}, {"of", "low"}}}};
  CHECK_THAT(check_plugin(kCoordinator, "arbiter_subsumption", options), finds_nothing());
}
