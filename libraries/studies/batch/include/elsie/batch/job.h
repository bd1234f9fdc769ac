// What a worker process is told, and what it answers.
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

/// One run, with all that it takes.
struct Job {
  std::int64_t run = 0;  // its number
  std::string world_text;
  std::string world_file;                    // what the text is called in messages
  std::map<std::string, std::string> files;  // data files: name in the text, path
  std::vector<std::string> libraries;        // of its plugins
  std::uint64_t seed = 1;
  double trajectory_period_s = 0.5;
};

using results::RunState;

/// A number that a run came to.
struct Measure {
  std::string name;  // "path_length_m"
  std::string unit;
  std::string meaning;
  std::optional<double> value;
};

/// What happened on a robot.
struct Event {
  double time_s = 0.0;
  std::string robot;
  std::string name;
  std::string detail;
};

/// Texts are JSON, as schema.sql says.
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

/// What a run came to, whatever became of it.
struct RunRecord {
  RunState state = RunState::error;
  std::optional<std::string> outcome;  // of one that is done
  std::string message;
  std::optional<std::uint64_t> steps;
  std::optional<double> simulated_s;
  std::optional<std::uint64_t> solver_gave_up;   // steps, as in simulation::SolverResult
  std::optional<std::uint64_t> solver_unsolved;  // of them
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
  std::vector<Event> events;
  std::vector<Trajectory> trajectories;
  std::vector<Curve> curves;
  std::vector<Timeline> timelines;
  std::vector<simulation::Note> notes;
};

/// One line of JSON without its end.
std::string to_json(const Job& job);
std::string to_json(const RunRecord& record);
/// Throw std::runtime_error with a sentence when the text is not what the functions above make.
Job job_from(std::string_view json);
RunRecord record_from(std::string_view json);

}  // namespace elsie::batch
