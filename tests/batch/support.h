// Small experiments made in code, and a folder for them.
#pragma once

#include <string>
#include <vector>

#include "elsie/batch/plan.h"
#include "elsie/batch/results_database.h"
#include "elsie/experiment/experiment.h"
#include "elsie/results/hash.h"

#include "folder.h"
#include "shipped.h"

namespace elsie::test {

/// A robot that wanders, and one that avoids obstacles: a plugin with data files.
inline constexpr const char* kWorld = R"(<world format="1" name="small">
  <limits time="2"/>
  <obstacles><static_box x="0.4" y="0"/></obstacles>
  <goals><travel robot="r1" distance="0.25"/></goals>
  <robots>
    <robot id="r1" team="red">
      <sensors><beam_range id="left" yaw_deg="15"/><beam_range id="right" yaw_deg="-15"/></sensors>
      <behaviors><wander/><avoid_obstacle/></behaviors>
      <coordinator><fusion_vector_summation/></coordinator>
    </robot>
    <robot id="r2" team="blue" x="-1">
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
</world>
)";

inline experiment::Setting setting(const std::string& path, const std::string& value) {
  return {path, value, {}};
}

/// Two speeds, three seeds: six runs.
inline experiment::Experiment small_experiment(const Folder& folder) {
  experiment::Experiment experiment;
  experiment.name = "small";
  experiment.description = "For a test";
  experiment.file = folder.write("small_experiment.xml", "<experiment/>");
  const std::string world = folder.write("small.xml", kWorld);
  experiment.worlds.push_back({"small", world, "small.xml", {}, {}});
  experiment.factors.push_back({"speed",
                                {{"slow", {setting("robot[r1]/@max_speed", "0.1")}, {}},
                                 {"fast", {setting("robot[r1]/@max_speed", "0.4")}, {}}},
                                {}});
  experiment.seeds = {1, 2, 18446744073709551615U};
  experiment.wall_limit = 60.0;
  experiment.trajectory_period = 0.1;
  return experiment;
}

inline batch::PlanOptions plan_options(batch::Shard shard = {}) {
  return {.elsie_version = "1.2.3",
          .text = "<experiment/>",
          .data_directories = {source_path("")},
          .shard = shard};
}

inline batch::Plan plan_of(const experiment::Experiment& experiment, batch::Shard shard = {}) {
  return batch::make_plan(experiment, shipped(), plan_options(shard));
}
inline batch::Plan small_plan(const Folder& folder, batch::Shard shard = {}) {
  return plan_of(small_experiment(folder), shard);
}

/// The data files of that experiment in the folder, which is then their data directory.
inline batch::PlanOptions with_models_in(const Folder& folder) {
  for (const char* side : {"left", "right"}) {
    const std::string name = std::string("fuzzy_models/avoid_obstacle_") + side + ".fcl";
    folder.write(name, results::file_content(source_path(name)));
  }
  batch::PlanOptions options = plan_options();
  options.data_directories = {folder.file("")};
  return options;
}

/// A folder for the plan of a small experiment and its database.
struct SmallBatch {
  const Folder folder{};
  const std::string file = folder.file("r.sqlite");
  const batch::Plan plan = small_plan(folder);
};

/// A possible record of a run that is done.
inline batch::RunRecord some_record(const std::string& hash = "0123456789abcdef") {
  batch::RunRecord record;
  record.state = batch::RunState::done;
  record.outcome = simulation::Outcome::success;
  record.message = "all goals are reached";
  record.steps = 200;
  record.simulated_s = 2.0;
  record.solver_gave_up = 12;
  record.solver_unsolved = 3;
  record.state_hash = hash;
  record.exit_code = 0;
  record.wall_s = 0.1;
  record.measures = {{"success", "", "1 or 0", 1.0}, {"time_s", "s", "how long", 2.0}};
  simulation::RobotResult robot;
  robot.id = "r1";
  robot.team = "red";
  robot.distance_m = 0.1 + 0.2;
  robot.collected = 1;
  robot.energy = 4998.0;
  robot.pose = {1.0, -2.0, 0.5};
  robot.collisions = 3;
  record.robots = {robot};
  record.events = {{0.5, "r1", "collected", "resource 'a'"}, {0.7, "r1", "hello", ""}};
  record.trajectories = {{"r1", 0.0, 0.1, "[[0,0,0]]", "[]"}};
  record.curves = {{"r1", "fusion", "error", "presentations", "error", "[[1,0.5]]"}};
  record.timelines = {{"r1", "[]", "[]"}};
  record.notes = {{"r1", "fusion", "It has learned."}};
  return record;
}

}  // namespace elsie::test
