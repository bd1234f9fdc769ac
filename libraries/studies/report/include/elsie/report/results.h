// The contents of a results database as plain data: see schema.sql and run_fields.h in
// libraries/studies/results.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/results/run_fields.h"
#include "elsie/simulation/run_result.h"

namespace elsie::report {

using results::RunState;
using simulation::Outcome;

struct Measure {
  std::string name;  // "path_length_m"
  std::string unit;  // "" for a pure number
  std::string meaning;
};

struct Factor {
  std::string name;
};

/// A cell, whose runs differ in their seeds only.
struct CellInfo {
  std::int64_t id = 0;
  std::string label;  // unique
  std::string world;  // its id in the experiment
  std::string world_text;
  std::string world_file;
  /// The seed of the runs that have this world, if each seed has a layout of its own.
  std::optional<std::uint64_t> seed;
  std::vector<std::string> levels;  // labels, parallel to Results::factors; "" for none
  std::vector<int> places;          // index of each level in its factor
};

struct Run : results::RunFields {
  std::int64_t id = 0;
  std::size_t cell = 0;  // index into Results::cells
  std::uint64_t seed = 0;
  int repetition = 1;
  double robots = 0.0;  // at its end
  /// In the order of Results::measures; none for a measure without a value in this run.
  std::vector<std::optional<double>> values;
  /// The formulas that rise with the time of this run, which never reached its goals: indices into
  /// Results::measures. Their values are lower bounds.
  std::vector<std::size_t> bounds;

  bool ended() const { return state != RunState::pending; }
  /// Returns whether the run failed: a plugin failed, or the process crashed, hung or could not do
  /// its work.
  bool broken() const { return ended() && state != RunState::done; }
  bool success() const { return outcome == Outcome::success; }
};

/// The experiment and all its runs.
struct Results {
  std::string elsie_version;
  std::string experiment;
  std::string description;
  std::string file;  // the experiment file, as the user named it
  std::string text;  // text of that file
  std::string fingerprint;
  std::string shard;         // "2/5": every fifth run from the second on; "1/1": all
  std::size_t all_runs = 0;  // runs of the experiment, in all shards
  std::string created;       // UTC, ISO 8601
  std::vector<Factor> factors;
  std::vector<Measure> measures;
  std::vector<CellInfo> cells;
  std::vector<Run> runs;  // sorted by id

  /// The seed of all random numbers for these results, derived from the fingerprint.
  std::uint64_t seed() const;
};

struct Trajectory {
  std::int64_t run = 0;
  std::string robot;
  double period_s = 0.0;
  /// The last pose is at the end of the run, less than a period after its predecessor, if there is
  /// one: see has_end.
  std::vector<Pose> poses;
  double from_s = 0.0;  // the time of the first
  bool has_end =
      false;  // otherwise the run failed, or the robot was removed: all are a period apart
};

/// What a robot's plugins or the simulator said during a run.
struct Event {
  std::int64_t run = 0;
  double time_s = 0.0;
  std::string name;
  std::string robot;   // empty: the world's
  std::string detail;  // only of run_details()
};

/// A learning curve of a plugin, from training before the run.
struct Curve {
  std::int64_t run = 0;
  std::string robot;
  std::string plugin;  // its id on the robot
  std::string name;
  std::string x_label;
  std::string y_label;
  std::vector<Vector2> points;
};

/// Which behaviour decided when on a robot.
struct Timeline {
  struct Behavior {
    std::string path;
    double share = 0.0;  // mean share in the robot's command
    double decided_s = 0.0;
  };
  struct Episode {
    double from_s = 0.0;
    double to_s = 0.0;
    std::string decider;  // a path; "": no behaviour; "*": several
    double share = 0.0;
    /// If several alternated quickly: the time of each, s.
    std::vector<std::pair<std::string, double>> parts;
  };

  std::int64_t run = 0;
  std::string robot;
  std::vector<Behavior> behaviors;
  std::vector<Episode> episodes;
};

/// Everything that is stored of one run over its time.
struct RunDetails {
  std::string world_text;  // as resolved for its seed
  std::vector<Trajectory> trajectories;
  std::vector<Timeline> timelines;
  std::vector<Event> events;
};

/// A results database, opened for reading in one state, even while a batch is writing it.
class ResultsFile {
 public:
  /// Throws like results::open_to_read().
  explicit ResultsFile(const std::filesystem::path& file);
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// Returns everything except the details below. All of these functions throw
  /// results::DatabaseRefused if the file is damaged, results::DatabaseError if it cannot be read.
  Results results() const;

  // Details of the runs of one cell, by run and robot; `cell` is CellInfo::id.
  std::vector<Trajectory> trajectories(std::int64_t cell) const;
  std::vector<Curve> curves(std::int64_t cell) const;
  std::vector<Timeline> timelines(std::int64_t cell) const;
  /// In the order of the runs and of time.
  std::vector<Event> events(std::int64_t cell) const;

  /// The ids of the runs that have trajectories, ascending.
  std::vector<std::int64_t> runs_with_trajectories() const;
  RunDetails run_details(std::int64_t run) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace elsie::report
