// Results databases with made-up runs, written with the schema of libraries/studies/results.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie::test {

struct MadeEpisode {
  double from_s = 0.0, to_s = 0.0;
  std::string decider;
};

struct MadeRobot {
  std::string id = "r1";
  std::vector<Pose> poses;
  std::optional<Pose> end{};  // its pose when the run ended
  std::vector<Vector2> touches;
  std::vector<MadeEpisode> episodes;
  std::vector<std::pair<std::string, double>> shares;  // of behaviours, by path
  std::vector<Vector2> curve;                          // of its coordinator; empty: none
};

struct MadeRun {
  std::uint64_t seed = 1;
  int repetition = 1;
  std::string state = "done";
  std::string outcome = "success";  // only of runs that are done
  std::string message;
  std::map<std::string, std::optional<double>> measures;
  std::string state_hash{};  // empty: it follows from the cell and the seed
  std::string signal, plugin, robot, log;
  std::optional<std::int64_t> step;
  std::vector<MadeRobot> robots;

  /// Makes it one without a result.
  void end_as(const std::string& how) {
    state = how;
    measures.clear();
    if (how == "pending") robots.clear();
  }
};

struct MadeCell {
  std::string label;
  std::vector<std::string> levels;  // of the factors, the world's first
  std::string world_text;
  std::vector<MadeRun> runs;
};

struct MadeExperiment {
  std::string name = "made up";
  std::string description;
  std::string text;  // of the experiment file
  std::string fingerprint = "4fd1";
  std::string shard = "1/1";
  std::int64_t all_runs = 0;                     // 0: the number of runs here
  std::vector<std::string> factors = {"world"};  // the world's first
  std::vector<std::pair<std::string, std::string>> units = {{"path_length_m", "m"},
                                                            {"time_s", "s"}};
  std::vector<MadeCell> cells;
};

/// Writes a new database.
void write_database(const MadeExperiment& experiment, const std::filesystem::path& file);

/// A world with four resources, which are goals if it has any, and this many robots of two teams.
std::string made_world(std::size_t robots = 1, bool goals = true);

/// Cells "a", "b"... of a factor "scheme", with a run for each of these path lengths; seeds from 1.
MadeExperiment made_from(const std::vector<std::vector<double>>& path_lengths);

/// A typical study: four networks with two coordinators, 20 seeds each, with ways, learning curves
/// and timelines. Some runs of the small networks fail, a few crash, a few are outliers.
MadeExperiment made_study();

}  // namespace elsie::test
