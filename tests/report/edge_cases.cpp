#include "edge_cases.h"

#include <limits>

#include "hostile.h"

namespace elsie::test {

namespace {

MadeExperiment all_end_as(const std::string& how) {
  MadeExperiment experiment = made_from({{1, 2, 3}, {2, 3, 4}});
  for (MadeCell& cell : experiment.cells) {
    for (MadeRun& run : cell.runs) {
      run.end_as(how);
      run.robots.clear();
      if (how == "pending") continue;
      run.signal = "SIGSEGV";
      run.message = "plugin 'wander' of robot 'r1' crashed with SIGSEGV in step 50";
    }
  }
  return experiment;
}

MadeExperiment hundred_cells() {
  MadeExperiment experiment;
  experiment.factors = {"world", "gain", "speed"};
  for (int i = 0; i < 100; ++i) {
    MadeCell& cell = experiment.cells.emplace_back();
    cell.levels = {"w", std::to_string(i / 10), std::to_string(i % 10)};
    cell.label = cell.levels[1] + ", " + cell.levels[2];
    cell.world_text = made_world();
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      MadeRun& run = cell.runs.emplace_back();
      run.seed = seed;
      run.measures = {{"path_length_m", i + 0.1 * static_cast<double>(seed)}, {"success", 1.0}};
      run.robots.emplace_back().poses = {{0, 0, 0}, {1, 0, 0}, {1, 2, 1.57}};
    }
  }
  return experiment;
}

MadeExperiment long_names() {
  std::string name;
  for (int i = 0; i < 60; ++i) {
    name += "very_";
  }
  MadeExperiment experiment = made_from({{1, 2, 3, 4, 5, 60}, {2, 3, 4, 5, 6, 7}});
  experiment.name = experiment.description = name + "long";
  experiment.factors[1] = name + "factor";
  experiment.units.emplace_back(name + "m", name);
  for (MadeCell& cell : experiment.cells) {
    cell.label = cell.levels[1] = name + cell.label;
    for (MadeRun& run : cell.runs) {
      run.measures[name + "m"] = static_cast<double>(run.seed);
      run.robots[0].id = name;
      run.robots[0].episodes = {{0, 1, name}};
      run.robots[0].shares = {{name, 1.0}};
      run.robots[0].curve = {{0, 1}, {1, 0.5}};
    }
  }
  MadeRun& broken = experiment.cells[0].runs[0];
  broken.state = "fault";
  broken.message = broken.plugin = broken.log = name;
  broken.measures.clear();
  return experiment;
}

// Levels that differ only behind a long common beginning.
MadeExperiment alike_names() {
  MadeExperiment experiment;
  experiment.factors = {"world", "coordination of the obstacle avoidance", "behaviour network"};
  const std::string beginning = "fusion by vector summation with a fading memory of ";
  const std::string network = "feed_forward_network_of_sensors_and_motors_with_hidden_layer_";
  for (const std::string seconds : {"1 s", "10 s", "100 s"}) {
    for (const std::string layer : {"4", "16"}) {
      MadeCell& cell = experiment.cells.emplace_back();
      cell.levels = {"w", beginning + seconds, network + layer};
      cell.label = cell.levels[1] + ", " + cell.levels[2];
      cell.world_text = made_world();
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        MadeRun& run = cell.runs.emplace_back();
        run.seed = seed;
        const auto number = static_cast<double>(seed * seconds.size() + layer.size());
        run.measures = {{"path_length_m", 10.0 + 0.37 * number + 0.01 * number * number},
                        {"time_s", 30.0 + number},
                        {"success", seed % seconds.size() == 0 ? 0.0 : 1.0}};
        run.outcome = seed % seconds.size() == 0 ? "time_limit" : "success";
        run.robots.emplace_back().poses = {{0, 0, 0}, {1, 0, 0}, {1, 0.1 * number, 1.57}};
      }
    }
  }
  return experiment;
}

// A value that is no number is null in the database.
MadeExperiment odd_values() {
  MadeExperiment experiment = made_from({{1, 2, 3, 4, 5, 6}, {2, 3, 4, 5, 6, 7}, {1, 1, 1, 1, 1}});
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (MadeRun& run : experiment.cells[0].runs) {
    run.measures["always_null"] = std::nullopt;
    run.measures["sometimes_null"] =
        run.seed % 2 ? std::optional(static_cast<double>(run.seed)) : std::nullopt;
    run.measures["boundless"] = kInfinity;
    run.measures["huge"] = run.seed % 2 ? 1.7e308 : -1.7e308;
    run.measures["tiny"] = 5e-324 * static_cast<double>(run.seed);
  }
  experiment.cells[1].runs[0].measures["path_length_m"] = -kInfinity;
  experiment.cells[1].runs[1].measures["path_length_m"] = std::nullopt;
  return experiment;
}

}  // namespace

std::vector<EdgeCase> edge_cases() {
  MadeExperiment one_run = made_from({{1}});
  one_run.cells[0].label = "w";
  return {{"all crashed", all_end_as("crash")},
          {"all pending", all_end_as("pending")},
          {"one run", one_run},
          {"one cell", made_from({{1, 2, 3, 4, 5, 60}})},
          {"100 cells", hundred_cells()},
          {"bad names", hostile()},
          {"long names", long_names()},
          {"alike names", alike_names()},
          {"odd values", odd_values()}};
}

report::Questions edge_questions() {
  experiment::Expectation path = expectation_of("short enough", "path_length_m");
  path.at_most = 3.0;
  path.confidence = 0.9;
  experiment::Expectation success;
  success.name = "gets there";
  success.measure = "success";
  success.statistic = report::Statistic::rate;
  success.at_least = 1.0;
  report::Questions questions;
  questions.expectations = {path, success};
  return questions;
}

}  // namespace elsie::test
