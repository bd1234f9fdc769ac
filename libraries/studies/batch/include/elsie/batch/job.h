// The job that a worker process gets, and the record that it answers with.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/results/run_state.h"
#include "elsie/simulation/run_result.h"

namespace elsie::batch {

/// One run with everything that it needs.
struct Job {
  std::int64_t run = 0;  // number of the run
  std::string world_text;
  std::string world_file;                    // name of the world in messages
  std::map<std::string, std::string> files;  // data files: name in the world's text, path
  std::vector<std::string> libraries;        // libraries of the world's plugins
  std::uint64_t seed = 1;
  double trajectory_period_s = 0.5;
};

using results::RunState;

/// A measured number.
struct Measure {
  std::string name;  // for example "path_length_m"
  std::string unit;
  std::string meaning;
  std::optional<double> value;
};

/// Both texts are JSON, as schema.sql says.
struct Trajectory {
  std::string robot;
  double period_s = 0.0;
  std::string poses;
  std::string touches;
};
struct Curve {
  std::string robot;
  std::string plugin;
  std::string name;
  std::string x_label;
  std::string y_label;
  std::string points;
};
struct Timeline {
  std::string robot;
  std::string behaviors;
  std::string episodes;
};

/// The result of a run, however it ended.
struct RunRecord {
  RunState state = RunState::error;
  std::optional<std::string> outcome;  // only of a run that is done
  std::string message;
  std::optional<std::uint64_t> steps;
  std::optional<double> simulated_s;
  std::optional<std::uint64_t> solver_gave_up;   // steps, as in simulation::SolverResult
  std::optional<std::uint64_t> solver_unsolved;  // steps, as in simulation::SolverResult
  std::optional<std::string> state_hash;         // 16 hexadecimal digits
  std::optional<int> exit_code;
  std::optional<std::string> signal;
  std::optional<std::string> plugin;
  std::optional<std::string> robot;
  std::optional<std::uint64_t> step;
  std::optional<std::string> log;
  double wall_s = 0.0;
  std::vector<Measure> measures;
  std::vector<simulation::RobotResult> robots;
  std::vector<simulation::EventRecord> events;
  std::vector<Trajectory> trajectories;
  std::vector<Curve> curves;
  std::vector<Timeline> timelines;
  std::vector<simulation::Note> notes;
};

/// One line of JSON without a line feed.
std::string to_json(const Job& job);
std::string to_json(const RunRecord& record);
/// Throw std::runtime_error with a sentence when the text is not what to_json() writes.
Job job_from(std::string_view json);
RunRecord record_from(std::string_view json);

}  // namespace elsie::batch
