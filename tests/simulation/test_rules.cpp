// Rules: what they see, how their edits are made, and how they end a run.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/rule.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/error.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Outcome;
using simulation::Simulation;

namespace {

using Apply = std::function<void(const Observation&, WorldChanges&)>;

/// Does what a test says.
class ScriptedRule final : public Rule {
 public:
  explicit ScriptedRule(Apply apply) : apply_(std::move(apply)) {}
  void apply(const Observation& now, WorldChanges& world) override { apply_(now, world); }

 private:
  Apply apply_;
};

plugin::Host ruled_by(Apply apply, Apply other = {}) {
  plugin::Host host(shipped_directory());
  const auto add = [&](const char* name, Apply each) {
    Declaration declaration = declaration_of(
        PluginKind::rule, name, [each] { return std::make_unique<ScriptedRule>(each); });
    declaration.events = {{"alarm", "a test raises it"}};
    host.add(std::move(declaration));
  };
  add("scripted_rule", std::move(apply));
  add(
      "other_rule", other ? std::move(other) : [](const Observation&, WorldChanges&) {});
  return host;
}

const std::string kField = R"(<world format="1"><arena length="6" width="6"/>
<obstacles><dynamic_box id="crate" x="-1" y="1"/><static_box id="wall" x="-2" y="-2"/></obstacles>
<resources><resource id="food" x="1" y="1"/></resources>
<robots><robot id="r1" energy="20"/><robot id="r2" y="-1"/></robots>
<goals><endure time="0.05"/></goals>
<measures><path_length/></measures>
<rules><scripted_rule id="law"/>
<other_rule/></rules><limits time="1"/></world>)";

simulation::RunResult run_of(const plugin::Host& host, const std::string& world = kField) {
  return Simulation(world::parse_world(world, "field.xml", host), host).run();
}

std::string refusal_of(const plugin::Host& host) {
  try {
    run_of(host);
  } catch (const simulation::EditRefused& refused) {
    return refused.report();
  } catch (const simulation::PluginFault& fault) {
    return fault.what();
  }
  return "";
}

bool is_step(const Observation& now, int step) { return std::abs(now.time_s - 0.01 * step) < 1e-9; }

}  // namespace

TEST_CASE("A rule sees the start, then every step; its edits are made before the next one") {
  std::vector<double> times;
  std::vector<double> energies;
  const plugin::Host host = ruled_by([&](const Observation& now, WorldChanges& world) {
    CHECK(now.is_start == times.empty());
    times.push_back(now.time_s);
    energies.push_back(now.robot("r1").energy);
    if (now.is_start) world.set("robot[r1]/@energy", 30.0);
    if (is_step(now, 2)) world.set("robot[r1]/@energy", 40.0);
  });
  const auto result = run_of(host);
  CHECK(times.size() == 6);
  CHECK(energies == std::vector{20.0, 30.0, 30.0, 40.0, 40.0, 40.0});
  REQUIRE(result.events.size() == 2);
  CHECK(result.events[0].time_s == 0.0);
  CHECK(result.events[1].time_s == Approx(0.02));
  CHECK(result.events[1].name() == "changed");
  CHECK(result.events[1].robot == "r1");
  CHECK(result.events[1].detail() == "robot[r1]/@energy=40, by the rule 'law'");
}

TEST_CASE("A rule sees each event once, those before the first step after that") {
  std::vector<std::pair<double, std::size_t>> seen;
  const auto host = ruled_by([&](const Observation& now, WorldChanges&) {
    if (!now.events.empty()) seen.emplace_back(now.time_s, now.events.size());
  });
  Simulation simulation(world::parse_world(kField, "field.xml", host), host);
  const simulation::TimedEdit at_start{0.0, {"robot[r1]/@energy", "3"}};
  simulation.run({}, {&at_start, 1});
  CHECK(seen == std::vector<std::pair<double, std::size_t>>{{0.01, 1}});
}

TEST_CASE("Edits of rules are made after the user's, in the order of the file") {
  const plugin::Host host = ruled_by(
      [](const Observation& now, WorldChanges& world) {
        if (is_step(now, 1)) world.set("robot[r1]/@energy", 1.0);
      },
      [](const Observation& now, WorldChanges& world) {
        if (is_step(now, 1)) world.set("robot[r1]/@energy", 2.0);
      });
  Simulation simulation(world::parse_world(kField, "field.xml", host), host);
  const simulation::TimedEdit users{0.01, {"robot[r1]/@energy", "3"}};
  const auto result = simulation.run({}, {&users, 1});
  REQUIRE(result.events.size() == 3);
  CHECK(result.events[0].detail() == "robot[r1]/@energy=3");
  CHECK(result.events[2].detail() == "robot[r1]/@energy=2, by the rule 'other_rule'");
  CHECK(simulation.robot(0).state->energy == 2.0);
}

TEST_CASE("Places are changed in place, also of what was collected") {
  const std::string engine = GENERATE("ode", "planar");
  const plugin::Host host = ruled_by([](const Observation& now, WorldChanges& world) {
    if (is_step(now, 1)) {
      world.place("resource[food]", {2.0, 0.5, 0.5});
      world.place("obstacle[crate]", {2.0, -2.0, 0.0});
      world.place("robot[r2]", {-1.0, -1.0, 1.0});
    }
    // In the way of r1: it is collected, then is elsewhere.
    if (is_step(now, 3)) world.place("robot[r1]", {1.815, 0.5, 0.0});
    if (is_step(now, 30)) {
      CHECK(now.obstacles.size() == 2);
      world.place("resource[food]", {-2.0, 2.0, 0.0});
    }
    if (is_step(now, 31)) CHECK(now.obstacles.back().pose == Pose{-2.0, 2.0, 0.0});
  });
  std::string text = kField;
  text.replace(text.find("time=\"0.05\""), 11, "time=\"0.5\"");
  text.replace(text.find(R"(<robot id="r1" energy="20"/>)"), 28,
               R"(<robot id="r1"><behaviors><go_to_point x="2.5" y="0.5"/></behaviors>
                  <coordinator><arbiter_suppression/></coordinator></robot>)");
  text.replace(text.find("<obstacles>"), 0, "<physics engine=\"" + engine + "\"/>");
  Simulation simulation(world::parse_world(text, "field.xml", host), host);
  const auto result = simulation.run();
  CHECK(result.robots[0].collected == 1);
  CHECK(*simulation.obstacle(2) == Pose{-2.0, 2.0, 0.0});
  CHECK(simulation.obstacle(0)->x == Approx(2.0));
  CHECK(simulation.obstacle(0)->y == Approx(-2.0));
  CHECK(simulation.robot(1).pose.x == Approx(-1.0).margin(1e-3));
  for (const simulation::Note& note : result.notes) CHECK(note.plugin != "law");
  // The world at the start is as it was, and a run of it is the same.
  CHECK(world::parse_world(text, "field.xml", host).obstacles[2].x ==
        simulation.start().obstacles[2].x);
  simulation.reset();
  CHECK(simulation.run().state_hash == result.state_hash);
}

TEST_CASE("Room is as bodies are, and as rules have placed them since") {
  const Apply places = [](const Observation& now, WorldChanges& world) {
    if (!is_step(now, 1)) return;
    CHECK_FALSE(world.has_room("resource[food]", {0.0, 0.0, 0.0}));  // r1
    CHECK_FALSE(world.has_room("resource[food]", {2.99, 0.0, 0.0}));
    CHECK_FALSE(world.has_room("resource[nowhere]", {2.0, 2.0, 0.0}));
    CHECK(world.has_room("robot[r1]", {0.0, 0.02, 0.0}));  // it is not in its own way
    CHECK(world.has_room("resource[food]", {2.0, 2.0, 0.0}));
    CHECK(world.has_room("robot[r1]", {2.0, 2.0, 0.0}));  // asking places nothing
    world.place("resource[food]", {2.0, 2.0, 0.0});
  };
  const plugin::Host host = ruled_by(places, [](const Observation& now, WorldChanges& world) {
    if (is_step(now, 1)) CHECK_FALSE(world.has_room("robot[r1]", {2.0, 2.0, 0.0}));
  });
  CHECK(run_of(host).outcome == Outcome::success);
}

TEST_CASE("A rule goes on when its own edits change robots and boxes, and keeps its randomness") {
  std::vector<double> drawn;
  class Growing final : public Rule {
   public:
    explicit Growing(std::vector<double>& drawn) : drawn_(drawn) {}
    void reset(Random& random) override {
      random_ = &random;
      calls_ = 0;
    }
    void apply(const Observation& now, WorldChanges& world) override {
      ++calls_;
      drawn_.push_back(random_->uniform());
      CHECK(now.robots.size() == (calls_ < 2 ? 2 : calls_ < 4 ? 3 : 2));
      if (calls_ == 1) world.add("robot", R"(<robot id="late" x="2" y="2"/>)");
      if (calls_ == 2) world.add("obstacle", R"(<static_box id="late_box" x="-2.5" y="2"/>)");
      if (calls_ == 3) world.remove("robot[r1]");  // the one that is asked
    }

   private:
    std::vector<double>& drawn_;
    Random* random_ = nullptr;
    int calls_ = 0;
  };
  plugin::Host host = ruled_by([](const Observation&, WorldChanges&) {});
  host.add(declaration_of(PluginKind::rule, "growing",
                          [&] { return std::make_unique<Growing>(drawn); }));
  std::string text = kField;
  text.replace(text.find("<scripted_rule id=\"law\"/>"), 25, "<growing/>");
  Simulation simulation(world::parse_world(text, "field.xml", host), host);
  const auto first = simulation.run();
  CHECK(first.outcome == Outcome::success);
  const std::vector<double> before = std::exchange(drawn, {});
  CHECK(before.size() == 6);
  Random stream(1, "rule[growing]");
  for (const double number : before) CHECK(number == stream.uniform());
  simulation.reset();
  CHECK(simulation.robots() == 2);
  CHECK(simulation.run().state_hash == first.state_hash);
  CHECK(drawn == before);
}

TEST_CASE("A rule that names a robot goes on when that is removed") {
  const plugin::Host host(shipped_directory());
  Simulation simulation(
      world::parse_world(
          R"(<world format="1"><robots><robot id="r1"/><robot id="r2" y="-1"/></robots>
<rules><referee robot="r1"><after time="0.05"/></referee></rules><limits time="1"/></world>)",
          "field.xml", host),
      host);
  simulation.step();
  simulation.edit("robot[r1]/@remove", "true");
  CHECK(simulation.run().outcome == Outcome::failure);
  CHECK(simulation.result().simulated_s == Approx(0.05));
}

TEST_CASE("Events of a rule reach one robot or all, in the next decision") {
  plugin::Host host = ruled_by([](const Observation& now, WorldChanges& world) {
    if (is_step(now, 1)) world.raise({"alarm"}, "r2");
    if (is_step(now, 2)) {
      REQUIRE(now.events.size() == 1);
      CHECK(now.events[0].name == "alarm");
      CHECK(now.events[0].robot == "r2");
      world.raise({"alarm"});
    }
    if (is_step(now, 4)) CHECK(now.events.empty());
  });
  std::vector<double> heard_s;
  auto answer = std::make_shared<Scripted::Answer>([&](const Perception& now) {
    for (const Event& event : now.events()) {
      if (event.name == "alarm") heard_s.push_back(now.time_s());
    }
    return Response();
  });
  Declaration listener = declaration_of(PluginKind::behavior, "listener",
                                        [=] { return std::make_unique<Scripted>(answer); });
  listener.reacts_to = {"alarm"};  // no behaviour raises it
  host.add(std::move(listener));
  std::string text = kField;
  text.replace(text.find(R"(<robot id="r2" y="-1"/>)"), 23,
               R"(<robot id="r2" y="-1"><behaviors><listener/></behaviors>
                  <coordinator><arbiter_suppression/></coordinator></robot>)");
  const auto result = run_of(host, text);
  REQUIRE(heard_s.size() == 2);
  CHECK(heard_s[0] == Approx(0.01));
  CHECK(heard_s[1] == Approx(0.02));
  REQUIRE(result.events.size() == 3);
  CHECK(result.events[1].robot == "r1");
  CHECK(result.events[2].robot == "r2");
}

TEST_CASE("A rule ends the run, with its reason") {
  using Case = std::tuple<Apply, Apply, Outcome, std::string>;
  const auto at = [](int step, auto act) -> Apply {
    return [=](const Observation& now, WorldChanges& world) {
      if (is_step(now, step)) act(world);
    };
  };
  const auto succeed = [](WorldChanges& world) { world.succeed("it is done"); };
  const auto fail = [](WorldChanges& world) { world.fail("it is lost"); };
  const auto both = [](WorldChanges& world) {
    world.succeed("it is done");
    world.fail("it is lost");
  };
  const std::string done = "the rule 'law' says: it is done";
  const std::string lost = "the rule 'law' says: it is lost";
  const std::vector<Case> cases{
      {at(0, fail), {}, Outcome::failure, lost},
      {at(2, succeed), {}, Outcome::success, done},
      {at(2, both), {}, Outcome::failure, lost},
      {at(2, succeed), at(2, fail), Outcome::failure, "the rule 'other_rule' says: it is lost"},
      {at(2, fail), at(2, succeed), Outcome::failure, lost},
      {at(5, fail), {}, Outcome::failure, lost},  // in the step in which the goal is reached
      {at(5, succeed), {}, Outcome::success, "all goals are reached"}};
  for (const auto& [law, other, outcome, reason] : cases) {
    CAPTURE(reason);
    const auto result = run_of(ruled_by(law, other));
    CHECK(result.outcome == outcome);
    CHECK(result.reason == reason);
  }
  CHECK(run_of(ruled_by(at(0, fail))).steps == 0);
}

TEST_CASE("An edit of a rule that is refused ends the run and names the rule and its line") {
  const auto refused = [](std::string path, std::string value) {
    return refusal_of(ruled_by([=](const Observation& now, WorldChanges& world) {
      if (is_step(now, 2)) world.set(path, value);
    }));
  };
  const std::string begin = "field.xml:7: the rule 'law': at 0.02 s, ";
  CHECK_THAT(refused("robot[r3]/@energy", "1"),
             Catch::StartsWith(begin + "robot[r3]/@energy=1: ") && Catch::Contains("there is no"));
  CHECK_THAT(refused("robot[r1]/@energy", "many"),
             Catch::StartsWith(begin) && Catch::Contains("expected a number"));
  CHECK_THAT(refused("resource[food]/@x", "-3.5"),
             Catch::StartsWith(begin) && Catch::Contains("outside"));
  CHECK_THAT(refused("obstacle[+]", "<static_box y=\"-1\"/>"),
             Catch::StartsWith(begin) && Catch::Contains("overlaps"));
  const auto place = [](std::string what, Pose pose) {
    return refusal_of(ruled_by([=](const Observation& now, WorldChanges& world) {
      if (is_step(now, 2)) world.place(what, pose);
    }));
  };
  CHECK_THAT(place("resource[food]", {0.0, -1.0, 0.0}),
             Catch::StartsWith(begin) && Catch::Contains("overlaps the robot 'r2'"));
  CHECK_THAT(
      place("obstacle[wall]", {2.0, 2.0, 0.0}),
      Catch::Contains("plugin 'scripted_rule' (id 'law') of the world failed in step 1") &&
          Catch::Contains("'obstacle[wall]', but this world has no such robot, resource or box"));
  CHECK_THAT(
      refusal_of(ruled_by([](const Observation&, WorldChanges& world) { world.raise({"ghost"}); })),
      Catch::Contains("the event 'ghost', which its declaration does not name"));
  CHECK_THAT(refusal_of(ruled_by(
                 [](const Observation&, WorldChanges& world) { world.raise({"alarm"}, "r9"); })),
             Catch::Contains("for the robot 'r9', which this world does not have"));
}

TEST_CASE("A rule that makes the world again and again works, and a note says what it costs") {
  std::string text = kField;
  text.replace(text.find("time=\"0.05\""), 11, "time=\"0.2\"");
  const auto law = [](int steps) {
    return ruled_by([=](const Observation& now, WorldChanges& world) {
      if (now.time_s < 0.01 * steps - 0.005)
        world.set("obstacle[wall]/@x", -1.9 + 0.5 * now.time_s);
    });
  };
  const auto notes = [](const simulation::RunResult& result) {
    std::string all;
    for (const simulation::Note& note : result.notes) {
      if (note.plugin == "law") all += note.text;
    }
    return all;
  };
  CHECK_THAT(notes(run_of(law(15), text)),
             Catch::StartsWith("its edits made objects or bodies again 15 times"));
  CHECK(notes(run_of(law(5), text)).empty());
  // Nests and patches are no bodies.
  text.replace(
      text.find("<robots>"), 8,
      "<nests><nest id=\"home\"/></nests><patches><disc_patch id=\"spot\"/></patches><robots>");
  const auto moving = ruled_by([](const Observation& now, WorldChanges& world) {
    world.set("nest[home]/@x", 0.5 * now.time_s);
    world.set("patch[spot]/@radius", 0.1 + 0.5 * now.time_s);
  });
  CHECK(notes(run_of(moving, text)).empty());
}

TEST_CASE("Rules and measures have different ids, and rules of an unknown name are refused") {
  const plugin::Host host = ruled_by([](const Observation&, WorldChanges&) {});
  const auto refused = [&](const std::string& rules) {
    return why_no_world([&] {
      world::parse_world(R"(<world format="1"><measures><path_length id="a"/></measures><rules>)" +
                             rules + "</rules></world>",
                         "field.xml", host);
    });
  };
  CHECK_THAT(refused(R"(<scripted_rule id="a"/>)"),
             Catch::Contains("a second measure or rule with the id 'a'"));
  CHECK_THAT(refused("<scripted_ruler/>"), Catch::Contains("scripted_rule"));
  CHECK_THAT(refused("<path_length/>"),
             Catch::Contains("'path_length' is a measure; it belongs in <measures>"));
}

TEST_CASE("A run with rules is the same in several threads") {
  std::string text = kLively;
  text.replace(text.find("x=\"2.5\" y=\"-2.5\"/></resources>"), 16, "x=\"1\" y=\"-0.4\"");
  text.replace(
      text.find("<measures>"), 0,
      R"(<rules><respawn after="0.1" where="random"/><timetable><edit time="0.5" every="0.5"
                  path="robot[r1]/@max_speed" value="0.3"/></timetable></rules>)");
  const world::World world = world::parse_world(text, "lively.xml", shipped());
  const auto run = [&](std::size_t threads) {
    return Simulation(world, shipped(), {.seed = 5, .threads = threads}).run();
  };
  const auto alone = run(1);
  const std::string returned = "by the rule 'respawn'";
  CHECK(std::any_of(alone.events.begin(), alone.events.end(),
                    [&](const auto& event) { return event.detail().ends_with(returned); }));
  CHECK(alone.state_hash == run(3).state_hash);
}
