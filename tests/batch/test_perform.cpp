#include <algorithm>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elsie/batch/batch.h"
#include "elsie/batch/perform.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "support.h"

using namespace elsie;
using Catch::Contains;

namespace {

batch::Job small_job(const test::Folder& folder) {
  const batch::Plan plan = test::small_plan(folder);
  return batch::job_of(plan, plan.runs[4]);
}

double measure(const batch::RunRecord& record, const std::string& name) {
  for (const simulation::MeasuredValue& one : record.measures) {
    if (one.name == name) {
      return one.value.value();
    }
  }
  throw std::runtime_error("no measure " + name);
}

}  // namespace

TEST_CASE("A job gives the same result as the same world and seed alone") {
  const test::Folder folder;
  const batch::Job job = small_job(folder);
  const batch::RunRecord record = batch::perform(job);
  CAPTURE(record.message);
  REQUIRE(record.state == batch::RunState::done);

  world::ReadOptions options;
  options.data_directories = {test::source_path("")};
  options.edits = {"robot[r1]/@max_speed=0.4"};
  simulation::Simulation alone(
      world::read_world(folder.file("small.xml"), test::shipped(), options), test::shipped(),
      {.seed = 2});
  const simulation::RunResult result = alone.run();
  CHECK(record.state_hash == simulation::hash_text(result.state_hash));
  CHECK(record.outcome == result.outcome);
  CHECK(record.message == result.reason);
  CHECK(record.steps == result.steps);
  CHECK(record.simulated_s == result.simulated_s);
  REQUIRE(record.robots.size() == 2);
  CHECK(record.robots[0].distance_m == result.robots[0].distance_m);
  CHECK(record.robots[1].pose.x == result.robots[1].pose.x);
  CHECK(record.events.size() == result.events.size());

  CHECK(measure(record, "success") == (result.outcome == simulation::Outcome::success ? 1 : 0));
  CHECK(measure(record, "time_s") == result.simulated_s);
  CHECK(measure(record, "path_length_m") ==
        result.robots[0].distance_m + result.robots[1].distance_m);
  CHECK(measure(record, "energy_left") == result.robots[0].energy + result.robots[1].energy);
  CHECK(measure(record, "collected") == 0);
}

TEST_CASE("A job gives the same record whenever it is done") {
  const test::Folder folder;
  const batch::Job job = small_job(folder);
  const auto without_time = [](batch::RunRecord record) {
    record.wall_s = 0.0;
    return to_json(record);
  };
  CHECK(without_time(batch::perform(job)) == without_time(batch::perform(job)));
}

TEST_CASE("A record has the way of every robot and who decided when") {
  const test::Folder folder;
  const batch::RunRecord record = batch::perform(small_job(folder));
  REQUIRE(record.trajectories.size() == 2);
  CHECK(record.trajectories[0].robot == "r1");
  CHECK(record.trajectories[0].period_s == Approx(0.1));
  const auto poses = nlohmann::json::parse(record.trajectories[0].poses);
  CHECK(poses.size() == static_cast<std::size_t>(*record.simulated_s / 0.1 + 1e-9) + 1);
  CHECK(poses[0] == nlohmann::json{0.0, 0.0, 0.0});
  REQUIRE(record.timelines.size() == 2);
  const auto behaviors = nlohmann::json::parse(record.timelines[0].behaviors);
  REQUIRE(behaviors.size() == 2);
  CHECK(behaviors[0]["path"] == "wander");
  CHECK(behaviors[1]["path"] == "avoid_obstacle");
  CHECK(behaviors[0]["share"].get<double>() + behaviors[1]["share"].get<double>() ==
        Approx(1.0).margin(0.002));
  const auto episodes = nlohmann::json::parse(record.timelines[1].episodes);
  REQUIRE(episodes.size() == 1);
  CHECK(episodes[0]["decider"] == "wander");
  CHECK(episodes[0]["from_s"] == 0.0);
  CHECK(episodes[0]["to_s"] == *record.simulated_s);
  CHECK(episodes[0]["share"] == 1.0);
}

TEST_CASE("A record of an edited run has each robot for the time that it was there") {
  const test::Folder folder;
  batch::Job job = small_job(folder);
  job.world_text = R"(<world format="1"><limits time="4"/><arena length="6" width="6"/>
      <robots><robot id="r1"><behaviors><wander/></behaviors><coordinator>
      <arbiter_suppression/></coordinator></robot></robots><changes>
      <change time="1" path="robot[r1]/behavior[+]"><wander id="more" priority="2"/></change>
      <change time="2.03" path="robot[+]"><robot id="r2" x="1"><behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator></robot></change>
      <change time="3" path="robot[r1]/@remove" value="true"/></changes></world>)";
  job.libraries = {test::plugin_directory() + "/arbiter_suppression.so",
                   test::plugin_directory() + "/wander.so"};
  job.trajectory_period_s = 0.1;
  const batch::RunRecord record = batch::perform(job);
  CAPTURE(record.message);
  REQUIRE(record.state == batch::RunState::done);
  REQUIRE(record.trajectories.size() == 1);
  CHECK(record.trajectories[0].robot == "r2");
  CHECK(record.trajectories[0].from_s == Approx(2.1));
  CHECK(nlohmann::json::parse(record.trajectories[0].poses).size() == 20);
  REQUIRE(record.timelines.size() == 2);
  CHECK(record.timelines[0].robot == "r1");
  const auto episodes = nlohmann::json::parse(record.timelines[0].episodes);
  CHECK(episodes.back()["to_s"].get<double>() == Approx(3.0).margin(0.05));
  const auto behaviors = nlohmann::json::parse(record.timelines[0].behaviors);
  REQUIRE(behaviors.size() == 2);
  CHECK(behaviors[0]["decided_s"].get<double>() + behaviors[1]["decided_s"].get<double>() ==
        Approx(3.0).margin(0.05));
  CHECK(record.timelines[1].robot == "r2");
}

TEST_CASE("A record has the measures of its world, after those of every run") {
  const test::Folder folder;
  auto experiment = test::small_experiment(folder);
  std::string text = folder.read("small.xml");
  text.insert(text.find("<robots>"), "<measures><path_length id=\"way\" robot=\"r1\"/></measures>");
  folder.write("small.xml", text);
  const auto plan = test::plan_of(experiment);
  CHECK(std::count_if(plan.plugins.begin(), plan.plugins.end(), [](const auto& plugin) {
          return plugin.kind == "measure" && plugin.name == "path_length";
        }) == 1);
  const batch::RunRecord record = batch::perform(batch::job_of(plan, plan.runs[0]));
  REQUIRE(record.robots.size() == 2);
  CHECK(record.measures.front().name == "success");
  const auto way = std::find_if(record.measures.begin(), record.measures.end(),
                                [](const auto& each) { return each.name.rfind("way", 0) == 0; });
  REQUIRE(way != record.measures.end());
  CHECK(way->unit == "m");
  CHECK(way->value == Approx(record.robots[0].distance_m));
}

TEST_CASE("A record has the learning curves of a run, thinned") {
  const test::Folder folder;
  experiment::Experiment experiment;
  experiment.file = folder.write("e.xml", "<experiment/>");
  experiment.worlds.push_back(
      {"learned", test::source_path("worlds/learned_priorities.xml"), "learned.xml", {}, {}});
  experiment.seeds = {1};
  experiment.time_limit = 1.0;
  const auto plan = test::plan_of(experiment);
  const batch::Job job = batch::job_of(plan, plan.runs[0]);
  const batch::RunRecord record = batch::perform(job);
  CAPTURE(record.message);
  REQUIRE(record.curves.size() == 1);
  CHECK_FALSE(record.curves[0].robot.empty());
  const auto points = nlohmann::json::parse(record.curves[0].points);
  REQUIRE(points.size() > 10);
  CHECK(points.size() <= batch::kMostCurvePoints);
  for (std::size_t i = 1; i < points.size(); ++i) {
    CHECK(points[i][0].get<double>() > points[i - 1][0].get<double>());
  }
  CHECK(points.back()[1].get<double>() < points.front()[1].get<double>());
}

TEST_CASE("A long way is thinned") {
  const test::Folder folder;
  auto experiment = test::small_experiment(folder);
  experiment.settings = {test::setting("limits/@time", "30"),
                         test::setting("goal[1]/@distance", "100")};
  experiment.trajectory_period = 0.01;
  const auto plan = test::plan_of(experiment);
  const batch::RunRecord record = batch::perform(batch::job_of(plan, plan.runs[0]));
  REQUIRE(record.steps == 3000U);
  const auto poses = nlohmann::json::parse(record.trajectories[0].poses);
  CHECK(poses.size() == 1501);  // every second of 3001
  CHECK(record.trajectories[0].period_s == Approx(0.02));
}

TEST_CASE("What goes wrong is in the record, not thrown") {
  const test::Folder folder;
  batch::Job job = small_job(folder);
  SECTION("a world that is wrong") {
    job.world_text = "<world format=\"1\"><nonsense/></world>";
    CHECK_THAT(batch::perform(job).message, Contains("nonsense"));
  }
  SECTION("a library that is gone") {
    job.libraries.clear();
    CHECK_THAT(batch::perform(job).message, Contains("wander"));
  }
  SECTION("a data file that is gone") {
    job.files.begin()->second = folder.file("gone.fcl");
    CHECK_THAT(batch::perform(job).message, Contains("gone.fcl"));
  }
  const batch::RunRecord record = batch::perform(job);
  CHECK(record.state == batch::RunState::error);
  CHECK_FALSE(record.outcome);
  CHECK_FALSE(record.state_hash);
  CHECK(record.measures.empty());
}

TEST_CASE("A plugin that fails is named with robot and step, and partial results are kept") {
  const auto performed = [](const std::string& behavior, const std::string& measures) {
    batch::Job job;
    job.world_text = "<world format=\"1\"><limits time=\"1\"/>" + measures +
                     "<robots><robot id=\"r1\" team=\"red\"><behaviors><" + behavior +
                     "/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>"
                     "</robots></world>";
    job.world_file = "w.xml";
    job.libraries = {test::plugin_directory() + "/arbiter_suppression.so",
                     test::build_path("tests/program/plugins/faulty.so")};
    job.trajectory_period_s = 0.1;
    return batch::perform(job);
  };
  // A measure that cannot report does not hide which plugin failed before.
  const std::string lost = "<measures><unable_to_report id=\"lost\"/></measures>";
  for (const std::string& measures : {std::string(), lost}) {
    for (const std::string plugin : {"throwing", "not_a_number"}) {
      CAPTURE(plugin, measures);
      const batch::RunRecord record = performed(plugin, measures);
      CHECK(record.state == batch::RunState::fault);
      CHECK(record.plugin == plugin);
      CHECK(record.robot == "r1");
      CHECK(record.step == 50U);
      CHECK_THAT(record.message,
                 Contains("plugin '" + plugin + "' of robot 'r1' failed in step 50 (at 0.5 s)"));
      CHECK(record.steps == 50U);
      CHECK_FALSE(record.outcome);
      CHECK(record.measures.empty());
      REQUIRE(record.trajectories.size() == 1);
      CHECK(nlohmann::json::parse(record.trajectories[0].poses).size() == 6);
      CHECK(record.timelines.size() == 1);
    }
  }
  const batch::RunRecord ended = performed("thrifty", lost);
  CHECK(ended.state == batch::RunState::fault);
  CHECK(ended.plugin == "unable_to_report");
  CHECK_THAT(ended.message, Contains("lost count"));
  CHECK_FALSE(ended.outcome);
  CHECK(ended.trajectories.size() == 1);
}

TEST_CASE_METHOD(test::SmallBatch,
                 "A give-up in the very step that the physics fails in is written, too") {
  batch::Job job = small_job(folder);
  // The ram pushes the robot through the wall in the first step.
  job.world_text = R"(<world format="1"><limits time="1"/><arena length="4" width="4"/>
      <physics cfm="0" friction="1000"/><obstacles><moving_box id="ram" x="0.9" length="1"
      width="3" speed="100"><waypoint x="1.9" y="0"/></moving_box></obstacles><robots>
      <robot id="r1" x="1.8"><behaviors><wander speed="20"/></behaviors><coordinator>
      <arbiter_suppression/></coordinator></robot></robots></world>)";
  job.libraries = {test::plugin_directory() + "/arbiter_suppression.so",
                   test::plugin_directory() + "/wander.so"};
  const batch::RunRecord record = batch::perform(job);
  CAPTURE(record.message);
  REQUIRE(record.state == batch::RunState::error);
  CHECK_THAT(record.message, Contains("the physics failed after 0.01 s (step 0)"));
  CHECK(record.steps == 0U);
  REQUIRE(record.solver_gave_up == 1U);
  CHECK(std::any_of(record.notes.begin(), record.notes.end(), [](const auto& note) {
    return note.text.find("gave up in 1 of 1 step,") != std::string::npos;
  }));

  {
    auto database = batch::ResultsDatabase::create(file, plan);
    database.write(1, record);
    CHECK(database.pending().size() == 5);
  }
  auto database = batch::ResultsDatabase::open(file);  // this also checks for damage
  const auto stored = database.run(1);
  REQUIRE(stored);
  CHECK(stored->record.steps == 0U);
  CHECK(stored->record.solver_gave_up == 1U);
}

TEST_CASE("A job makes the edits of its cell, also with plugins and files that the world has not") {
  const test::Folder folder;
  const auto at = [](double time_s, const std::string& path, const std::string& value) {
    return experiment::Setting{path, value, {}, time_s};
  };
  auto experiment = test::small_experiment(folder);
  experiment.settings = {at(0.5, "obstacle[+]", "<static_box id=\"late\" x=\"1\" y=\"1\"/>"),
                         at(0.7, "robot[r2]/behavior[+]", "<turn_left/>"),
                         at(0.9, "robot[r2]/coordinator", "<fusion_vector_summation/>")};
  const batch::Plan plan = test::plan_of(experiment);
  CHECK(std::any_of(plan.plugins.begin(), plan.plugins.end(),
                    [](const auto& plugin) { return plugin.name == "turn_left"; }));
  const batch::RunRecord record = batch::perform(batch::job_of(plan, plan.runs[4]));
  CAPTURE(record.message);
  REQUIRE(record.state == batch::RunState::done);

  world::ReadOptions options;
  options.data_directories = {test::source_path("")};
  options.edits = {"robot[r1]/@max_speed=0.4"};
  simulation::Simulation alone(
      world::read_world(folder.file("small.xml"), test::shipped(), options), test::shipped(),
      {.seed = 2, .data_directories = options.data_directories});
  std::vector<simulation::TimedEdit> edits;
  for (const experiment::Setting& setting : experiment.settings) {
    edits.push_back({*setting.at_s, {setting.path, setting.value}});
  }
  CHECK(record.state_hash == simulation::hash_text(alone.run({}, edits).state_hash));
}
