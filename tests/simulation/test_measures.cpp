// The measures of a world while it runs.
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/measure.h"
#include "elsie/simulation/measures.h"
#include "elsie/simulation/trace_account.h"
#include "elsie/simulation/trace_recorder.h"
#include "elsie/world/error.h"
#include "elsie/world/reader.h"

#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using simulation::MeasuredValue;
using simulation::PluginFault;
using simulation::RunResult;
using simulation::Simulation;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// What a measure of a test does.
struct Script {
  std::function<void(const Observation&)> equipped = [](const Observation&) {};
  std::function<void(const Observation&)> observe = [](const Observation&) {};
  std::function<std::optional<double>()> value = [] { return std::nullopt; };
  std::vector<Quantity> quantities{{"", "", "a test's"}};
};

class ScriptedMeasure final : public Measure {
 public:
  explicit ScriptedMeasure(std::shared_ptr<Script> script) : script_(std::move(script)) {}
  void equipped(const Observation& start) override { script_->equipped(start); }
  std::vector<Quantity> quantities() const override { return script_->quantities; }
  void observe(const Observation& now) override { script_->observe(now); }
  void report(const RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = script_->value();
  }
  std::vector<std::string> notes() const override { return {"It watches."}; }

 private:
  std::shared_ptr<Script> script_;
};

Declaration measure_declaration(const Script& script) {
  Declaration declaration;
  declaration.kind = PluginKind::measure;
  declaration.name = "scripted_measure";
  declaration.description = "Does what the test says";
  declaration.create = [shared = std::make_shared<Script>(script)] {
    return std::make_unique<ScriptedMeasure>(shared);
  };
  return declaration;
}

world::PluginUse measure(const std::string& plugin, Parameters parameters = {}) {
  world::PluginUse use;
  use.plugin = use.id = plugin;
  use.parameters = std::move(parameters);
  use.location = {"world.xml", 7};
  return use;
}

/// A robot that drives as it is told, in a world with measures.
struct Run {
  explicit Run(Script script = {},
               std::vector<world::PluginUse> measures = {measure("scripted_measure")})
      : scripted([this](const Perception& now) { return Response(drive(now)); }) {
    scripted.host.add(measure_declaration(script));
    world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted")));
    world.limits.time = 1.0;
    world.measures = std::move(measures);
  }
  RunResult run() { return Simulation(world, scripted.host).run(); }
  std::string refusal() const {
    try {
      Simulation(world, scripted.host);
      return "";
    } catch (const world::WorldError& error) {
      return error.what();
    }
  }

  std::function<MotorCommand(const Perception&)> drive = [](const Perception&) {
    return MotorCommand{10, 10};
  };
  ScriptedHost scripted;
  world::World world;
};

std::optional<double> value(const RunResult& result, const std::string& name) {
  const auto found =
      std::find_if(result.measures.begin(), result.measures.end(),
                   [&](const MeasuredValue& measured) { return measured.name == name; });
  INFO(name);
  REQUIRE(found != result.measures.end());
  return found->value;
}

/// A shipped world that ends after so many seconds, whatever its goals want.
world::World shipped_world(const std::string& name, double seconds) {
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  world::World world =
      world::read_world(source_path("worlds/" + name + ".xml"), shipped(), options);
  world.limits.time = seconds;
  return world;
}

}  // namespace

TEST_CASE("Every run has six values, whatever its world measures") {
  Run run({}, {});
  world::Robot other = robot("r2", 2, 0, 90, behavior("scripted"));
  other.energy = 400.0;
  run.world.robots.push_back(other);
  world::Box food = box("food", world::BoxKind::resource, 0.25, 0.0);
  food.energy = 0.0;
  run.world.boxes.push_back(food);
  const RunResult result = run.run();
  REQUIRE(result.robots.size() == 2);
  REQUIRE(result.measures.size() == simulation::kMeasuresOfEveryRun);
  CHECK(result.measures[0].name == "success");
  CHECK(value(result, "success") == 0.0);
  CHECK(value(result, "time_s") == Approx(1.0));
  CHECK(value(result, "path_length_m") ==
        Approx(result.robots[0].distance_m + result.robots[1].distance_m));
  CHECK(*value(result, "path_length_m") > 0.3);
  CHECK(value(result, "collected") == 1.0);
  CHECK(value(result, "collisions") == 0.0);
  CHECK(value(result, "energy_left") == Approx(5400.0));
  run.world.goals.push_back(world::CollectGoal{});
  CHECK(value(run.run(), "success") == 1.0);
}

TEST_CASE("Which values a run has is known without running it") {
  Run run({}, {measure("path_length"), measure("energy"), measure("time_share")});
  run.world.measures[0].id = "way";
  const std::vector<Quantity> names = simulation::measure_names(run.world, run.scripted.host);
  const RunResult result = run.run();
  REQUIRE(names.size() == result.measures.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    CHECK(names[i].name == result.measures[i].name);
    CHECK(names[i].unit == result.measures[i].unit);
    CHECK(names[i].meaning == result.measures[i].meaning);
    CHECK(result.measures[i].value.has_value());
  }
  CHECK(names[6].name == "way");
  CHECK(names[7].name == "energy.used");
  CHECK(names[8].name == "energy.left");
  CHECK(names[9].name == "time_share.decided.scripted");
  CHECK(names.size() == 11);
}

TEST_CASE("A measure sees the start, then every step once it is made") {
  struct Seen {
    double time_s;
    bool is_start, decided;
    double x, distance_m;
    MotorCommand command;
    bool asked;
    double share;
  };
  std::vector<Seen> seen;
  Script script;
  script.equipped = [](const Observation& start) {
    CHECK(start.is_start);
    CHECK(start.step_s == 0.01);
    CHECK(start.period_s == Approx(0.03));
    CHECK(start.arena_length_m == 10.0);
    CHECK(start.robot("r1").team == "red");
    CHECK(start.robot("r1").capacity == 5000.0);
    REQUIRE(start.robot("r1").behaviors.size() == 1);
    CHECK(start.robot("r1").behavior("scripted") != nullptr);
    CHECK(start.robot("r1").behavior("nobody") == nullptr);
  };
  script.observe = [&](const Observation& now) {
    const ObservedRobot& r = now.robot("r1");
    const ObservedBehavior& b = r.behaviors[0];
    seen.push_back({now.time_s, now.is_start, now.decided, r.pose.x, r.distance_m, r.command,
                    b.asked, b.robot_share});
  };
  Run run(script);
  run.drive = [](const Perception& now) {
    return now.time_s() > 0.05 ? MotorCommand{5, 5} : MotorCommand{10, 10};
  };
  run.world.physics.control_steps = 3;
  run.world.limits.time = 0.1;
  run.run();
  REQUIRE(seen.size() == 11);
  CHECK(seen[0].is_start);
  CHECK(seen[0].time_s == 0.0);
  CHECK(seen[0].command == MotorCommand{});
  CHECK_FALSE(seen[0].asked);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    CAPTURE(i);
    CHECK_FALSE(seen[i].is_start);
    CHECK(seen[i].time_s == Approx(0.01 * static_cast<double>(i)));
    CHECK(seen[i].decided == (i % 3 == 1));
    CHECK(seen[i].command == (i > 6 ? MotorCommand{5, 5} : MotorCommand{10, 10}));
    CHECK(seen[i].asked);
    CHECK(seen[i].share == 1.0);
    CHECK(seen[i].x > seen[i - 1].x);
    CHECK(seen[i].distance_m > seen[i - 1].distance_m);
  }
}

TEST_CASE("Measures see what is in the world, and what is gone") {
  std::vector<std::size_t> boxes;
  std::vector<double> cart_x;
  Script script;
  script.observe = [&](const Observation& now) {
    boxes.push_back(now.boxes.size());
    for (const ObservedBox& box : now.boxes) {
      if (box.kind == ObservedBox::Kind::moving) {
        cart_x.push_back(box.pose.x);
      }
      CHECK((box.id == "food" || box.id == "cart"));
      CHECK((box.id != "food" || box.kind == ObservedBox::Kind::resource));
    }
  };
  Run run(script);
  world::Box cart = box("cart", world::BoxKind::moving, -2, 0);
  cart.waypoints = {{-3.0, 0.0}};
  run.world.boxes = {cart, box("food", world::BoxKind::resource, 0.2, 0.0)};
  run.run();
  CHECK(boxes.front() == 2);
  CHECK(boxes.back() == 1);
  CHECK(cart_x.front() == Approx(-2.0));
  CHECK(cart_x.back() == Approx(-2.2).margin(0.02));  // 0.2 m/s for a second
}

TEST_CASE("What a user changes before the start is part of the start") {
  std::vector<double> x;
  Script script;
  script.observe = [&](const Observation& now) { x.push_back(now.robot("r1").pose.x); };
  Run run(script);
  Simulation simulation(run.world, run.scripted.host);
  const std::vector<simulation::TimedChange> changes{{0.0, {"robot[r1]/@x", "1.5"}}};
  simulation.run({}, changes);
  REQUIRE_FALSE(x.empty());
  CHECK(x.front() == 1.5);
}

TEST_CASE("A run is the same with measures and without") {
  for (const std::string name : {"clutter", "group_to_resource", "nested", "khepera"}) {
    CAPTURE(name);
    world::World plain = shipped_world(name, 15);
    plain.measures.clear();
    world::World measured = plain;
    for (const Declaration* declaration : shipped().all(PluginKind::measure)) {
      if (declaration->name != "place_reached" && declaration->name != "formation_error" &&
          (declaration->name != "group_gathered" || plain.robots.size() > 1)) {
        measured.measures.push_back(measure(declaration->name));
      }
    }
    const RunResult with = Simulation(measured, shipped(), {.seed = 5}).run();
    const RunResult without = Simulation(plain, shipped(), {.seed = 5}).run();
    CHECK(with.state_hash == without.state_hash);
    CHECK(with.steps == without.steps);
    CHECK(with.measures.size() > without.measures.size());
    // And the values are the same again.
    const RunResult again = Simulation(measured, shipped(), {.seed = 5}).run();
    for (std::size_t i = 0; i < with.measures.size(); ++i) {
      CHECK(with.measures[i].value == again.measures[i].value);
    }
  }
}

TEST_CASE("Measures agree with what the run tells otherwise") {
  world::World world = shipped_world("nested", 20);
  for (const char* name :
       {"path_length", "collisions", "collected", "energy", "run_time", "time_share"}) {
    world.measures.push_back(measure(name));
  }
  TemporaryFile file;
  simulation::TraceRecorder recorder(file.path);
  simulation::Observer* const observers[] = {&recorder};
  const RunResult result = Simulation(world, shipped(), {.seed = 3}).run(observers);
  CHECK(value(result, "path_length") == value(result, "path_length_m"));
  CHECK(value(result, "collisions.count") == value(result, "collisions"));
  CHECK(value(result, "collected.count") == value(result, "collected"));
  CHECK(value(result, "energy.left") == value(result, "energy_left"));
  CHECK(value(result, "run_time") == value(result, "time_s"));
  const simulation::Trace trace = simulation::read_trace(file.path);
  REQUIRE(trace.robots.size() == 1);
  const simulation::TraceRobot& traced = trace.robots[0];
  const simulation::RobotAccount account =
      simulation::account(traced, simulation::within({}, trace));
  REQUIRE(traced.members.size() >= 3);
  for (std::size_t i = 0; i < traced.members.size(); ++i) {
    CAPTURE(traced.members[i].path);
    CHECK(*value(result, "time_share.decided." + traced.members[i].path) * result.simulated_s ==
          Approx(account.members[i].decided_s).margin(1e-6));
    CHECK(*value(result, "time_share.share." + traced.members[i].path) ==
          Approx(account.members[i].robot_share).margin(1e-3));
  }
}

TEST_CASE("Energy that sensors use is counted, and no more than there was") {
  Run run({}, {measure("energy")});
  world::Robot& robot = run.world.robots[0];
  robot.sensors.push_back(beam("eye", 0));
  robot.sensors[0].energy_cost = 20.0;
  CHECK(value(run.run(), "energy.used") == Approx(20.0));
  robot.energy = 5.0;
  const RunResult result = run.run();
  CHECK(value(result, "energy.used") == Approx(5.0));
  CHECK(value(result, "energy.left") == 0.0);
}

TEST_CASE("A measure that refuses the world is a mistake of its line, beside all others") {
  Run run({}, {measure("path_length", {{"robot", "r9"}}), measure("collisions", {{"team", "x"}})});
  run.world.measures[1].location.line = 8;
  run.world.robots[0].behaviors[0].plugin = "nobody";
  run.world.robots[0].behaviors[0].location = {"world.xml", 3};
  const std::string refusal = run.refusal();
  CHECK_THAT(refusal, Catch::Contains("world.xml:7: plugin 'path_length': there is no robot 'r9' "
                                      "in the world; there is 'r1'"));
  CHECK_THAT(refusal, Catch::Contains("world.xml:8: plugin 'collisions': there is no team 'x'"));
  CHECK_THAT(refusal, Catch::Contains("world.xml:3: plugin 'nobody'"));
  CHECK_THROWS_AS(simulation::measure_names(run.world, run.scripted.host), world::WorldError);
}

TEST_CASE("Two values of one name are refused") {
  Run run({}, {measure("path_length")});
  run.world.measures[0].id = "time_s";
  CHECK_THAT(run.refusal(),
             Catch::Contains("world.xml:7: plugin 'path_length': one of its values would be called "
                             "'time_s', as a value that every run has; give it another id"));
  run.world.measures = {measure("energy"), measure("path_length")};
  run.world.measures[1].id = "energy.left";
  CHECK_THAT(run.refusal(), Catch::Contains("'energy.left', as another one is already"));
}

TEST_CASE("Names of values are made of what names are made of") {
  Script script;
  script.quantities = {{"two words", "", ""}};
  CHECK_THAT(Run(script).refusal(),
             Catch::Contains("it calls a value 'two words'; expected letters"));
  script.quantities.clear();
  CHECK_THAT(Run(script).refusal(), Catch::Contains("it has no values to report in this world"));
}

TEST_CASE("A measure that fails is named, with the step") {
  Script script;
  script.observe = [](const Observation& now) {
    if (now.time_s > 0.025) {
      throw std::runtime_error("lost count");
    }
  };
  script.value = [] { return 1.0; };
  Run run(script);
  Simulation simulation(run.world, run.scripted.host);
  CHECK_THROWS_WITH(
      simulation.run(),
      "plugin 'scripted_measure' among the world's measures failed in step 2: lost count");
  // The rest of the result is there all the same.
  const RunResult result = simulation.result();
  CHECK(result.steps == 3);
  CHECK_FALSE(value(result, "scripted_measure"));
  CHECK(*value(result, "path_length_m") > 0.0);
  // A new run begins anew.
  simulation.reset();
  CHECK(value(simulation.result(), "scripted_measure") == 1.0);
}

TEST_CASE("So is one that reports what is no number") {
  Script script;
  script.value = [] { return kNan; };
  Run run(script);
  Simulation simulation(run.world, run.scripted.host);
  CHECK_THROWS_WITH(simulation.run(),
                    Catch::Contains("its value 'scripted_measure' is not a finite number"));
  CHECK_FALSE(value(simulation.result(), "scripted_measure"));
}

TEST_CASE("What a measure has to say is told without a robot") {
  Run run;
  const RunResult result = run.run();
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes[0].robot.empty());
  CHECK(result.notes[0].plugin == "scripted_measure");
  CHECK(result.notes[0].text == "It watches.");
}

TEST_CASE("What a measure is told cannot be changed while the world runs") {
  Run run({}, {measure("path_length", {{"robot", "r1"}})});
  Simulation simulation(run.world, run.scripted.host);
  CHECK_THROWS_WITH(simulation.change("measure[path_length]/@robot", "r2"),
                    Catch::Contains("'robot' of <path_length> is settled before a run"));
}

TEST_CASE("Measures stay when plugins are replaced, and the user is told") {
  Run run;
  Simulation simulation(run.world, run.scripted.host);
  simulation.step();
  ScriptedHost other([](const Perception&) { return Response(MotorCommand{1, 1}); });
  Script script;
  script.value = [] { return 2.0; };
  other.host.add(measure_declaration(script));
  const simulation::Replacement replaced = simulation.replace_plugins(other.host);
  CHECK_FALSE(replaced.objects.empty());
  REQUIRE(replaced.notes.size() == 1);
  CHECK_THAT(replaced.notes[0],
             Catch::StartsWith("the measure 'scripted_measure' stays as it was"));
  CHECK_FALSE(value(simulation.result(), "scripted_measure"));
}

TEST_CASE("The learning curve of a network is part of the result") {
  const RunResult result = Simulation(shipped_world("learned_priorities", 0.1), shipped()).run();
  REQUIRE_FALSE(result.curves.empty());
  for (const simulation::LearningCurve& curve : result.curves) {
    CHECK_FALSE(curve.robot.empty());
    CHECK_THAT(curve.plugin, Catch::Contains("neural_network"));
    CHECK(curve.curve.name == "error");
    CHECK(curve.curve.x_label == "presentations");
    const auto& points = curve.curve.points;
    REQUIRE(points.size() > 100);
    CHECK(points.size() <= 200);
    CHECK(points.back().x == Approx(200'000).epsilon(0.01));
    for (std::size_t i = 1; i < points.size(); ++i) {
      CHECK(points[i].x > points[i - 1].x);
      CHECK(points[i].y >= 0.0);
    }
    CHECK(points.back().y < points.front().y);
  }
}

TEST_CASE("So is that of a network inside a behaviour") {
  const std::string training = source_path("training_sets/two_sensors_two_behaviors.txt");
  const auto run = [&](const std::string& outer) {
    const std::string text = R"(<world format="1"><robots><robot id="r1">
      <sensors><beam_range id="left" yaw_deg="15"/><beam_range id="right" yaw_deg="-15"/></sensors>
      <behaviors>
        <blend id="explore">
          <behaviors><avoid_obstacle/><wander/></behaviors>
          <coordinator><arbiter_neural_network presentations="90" training=")" +
                             training + R"("/></coordinator>
        </blend>
        <wander/>
      </behaviors>
      <coordinator>)" + outer +
                             R"(</coordinator></robot></robots><limits time="0.05"/></world>)";
    world::ReadOptions options;
    options.data_directories = {source_path("")};
    return Simulation(world::parse_world(text, "nets.xml", shipped(), options), shipped()).run();
  };
  const RunResult one = run("<arbiter_suppression/>");
  REQUIRE(one.curves.size() == 1);
  CHECK(one.curves[0].robot == "r1");
  CHECK(one.curves[0].plugin == "explore/arbiter_neural_network");
  // Nine samples, ten epochs: each is a point.
  REQUIRE(one.curves[0].curve.points.size() == 10);
  CHECK(one.curves[0].curve.points[0].x == 9.0);
  CHECK(one.curves[0].curve.points[9].x == 90.0);
  const RunResult two = run("<fusion_neural_network training=\"" + training + "\"/>");
  REQUIRE(two.curves.size() == 2);
  CHECK(two.curves[0].plugin == "explore/arbiter_neural_network");
  CHECK(two.curves[1].plugin == "fusion_neural_network");
}

TEST_CASE("Where nothing was trained there is no curve") {
  world::World world = shipped_world("learned_priorities", 0.05);
  world::World plain = world;
  plain.robots[0].coordinator->plugin = "fusion_vector_summation";
  plain.robots[0].coordinator->parameters.clear();
  CHECK(Simulation(plain, shipped()).run().curves.empty());
  CHECK(Simulation(world, shipped()).run().curves.size() == 1);
}
