// The values of a run: which there are, whether they are right, and what a measure does wrong.
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/recording/mcap_recorder.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/traces/trace_account.h"

#include "measures_support.h"

using namespace elsie;
using namespace elsie::test;
using simulation::RunResult;
using simulation::Simulation;

namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("Every run has six values, whatever its world measures") {
  Run run({}, {});
  world::Robot other = robot("r2", 2, 0, 90, behavior("scripted"));
  other.energy = 400.0;
  run.world.robots.push_back(other);
  world::Obstacle food = box("food", world::ObstacleKind::resource, 0.25, 0.0);
  food.energy = 0.0;
  run.world.obstacles.push_back(food);
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

TEST_CASE("Measures agree with what the run tells otherwise") {
  world::World world = shipped_world("nested", 20);
  for (const char* name :
       {"path_length", "collisions", "collected", "energy", "run_time", "time_share"}) {
    world.measures.push_back(measure(name));
  }
  TemporaryFile file;
  const auto recorder = recording::mcap_recorder(file.path);
  simulation::Observer* const observers[] = {recorder.get()};
  const RunResult result = Simulation(world, shipped(), {.seed = 3}).run(observers);
  CHECK(value(result, "path_length") == value(result, "path_length_m"));
  CHECK(value(result, "collisions.count") == value(result, "collisions"));
  CHECK(value(result, "collected.count") == value(result, "collected"));
  CHECK(value(result, "energy.left") == value(result, "energy_left"));
  CHECK(value(result, "run_time") == value(result, "time_s"));
  const traces::Trace trace = recording::read_trace(file.path);
  REQUIRE(trace.robots.size() == 1);
  const traces::TraceRobot& traced = trace.robots[0];
  const traces::RobotAccount account = traces::account(traced, traces::within({}, trace));
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
  CHECK_THROWS_WITH(simulation.run(),
                    "plugin 'scripted_measure' of the world failed in step 2 (at "
                    "0.03 s): lost count");
  // The rest of the result is there all the same.
  const RunResult result = simulation.result();
  CHECK(result.steps == 3);
  CHECK_FALSE(value(result, "scripted_measure"));
  CHECK(*value(result, "path_length_m") > 0.0);
  // A new run starts again.
  simulation.reset();
  CHECK(value(simulation.result(), "scripted_measure") == 1.0);
}

TEST_CASE("So is one that reports what is no number") {
  Script script;
  script.value = [] { return kUndefined; };
  Run run(script);
  Simulation simulation(run.world, run.scripted.host);
  CHECK_THROWS_WITH(simulation.run(),
                    Catch::Contains("its value 'scripted_measure' is not a finite number"));
  CHECK_FALSE(value(simulation.result(), "scripted_measure"));
}
