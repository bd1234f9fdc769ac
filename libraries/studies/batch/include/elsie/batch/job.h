// The job that a worker process gets, and the record that it returns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/results/run_fields.h"
#include "elsie/simulation/run_result.h"

namespace elsie::batch {

/// One run and all its inputs.
struct Job {
  std::int64_t run = 0;  // number of the run
  std::string world_text;
  std::string world_file;                    // name of the world in messages
  std::map<std::string, std::string> files;  // data files: name in the world's text, path
  std::vector<std::string> libraries;        // libraries of the world's plugins
  std::uint64_t seed = 1;
  double trajectory_period_s = 0.5;
  std::size_t threads = 1;  // as simulation::Options::threads
  // Not told to the worker: the run does not depend on them.
  int repetition = 1;
  /// Runs of one cell, of one plan, differ in number, seed and repetition only. None: the run has a
  /// world of its own.
  std::optional<std::size_t> cell{};
};

using results::RunState;

/// An event on a robot.
struct Event {
  double time_s = 0.0;
  std::string robot;
  std::string name;
  std::string detail;
};

/// Strings such as `poses` are JSON; schema.sql describes them.
struct Trajectory {
  std::string robot;
  double from_s = 0.0;
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
struct RunRecord : results::RunFields {
  RunRecord() {
    state = RunState::error;
    wall_s = 0.0;
  }

  std::vector<simulation::MeasuredValue> measures;
  std::vector<simulation::RobotResult> robots;
  std::vector<Event> events;
  std::vector<Trajectory> trajectories;
  std::vector<Curve> curves;
  std::vector<Timeline> timelines;
  std::vector<simulation::Note> notes;
};

/// Return one line of JSON without a line feed.
std::string to_json(const Job& job);
std::string to_json(const RunRecord& record);
/// Throw std::runtime_error with a sentence if the text was not written by to_json().
Job job_from(std::string_view json);
RunRecord record_from(std::string_view json);

}  // namespace elsie::batch
