// An experiment as plain data: what an experiment file says, checked and complete. Which worlds,
// what is varied in them, with which seeds, what is measured, and what is expected to come of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/base/problems.h"
#include "elsie/world/description.h"

namespace elsie::experiment {

using base::Location;

/// Something to set in a world, as with `elsie run --set`: ReadOptions::overrides has the paths. A
/// value may be an element: "<fusion_interval/>".
struct Setting {
  std::string path;
  std::string value;
  Location location;
};

/// One of the values of a factor: what is set for it, all of it together.
struct Level {
  std::string label;  // unique within its factor: "4 4", "0.25"; without , ; | and *
  std::vector<Setting> settings;
  Location location;
};

/// What is varied: independent of other factors, so that each of its levels meets each of theirs.
struct Factor {
  std::string name;  // unique among the factors; "world" is that of the worlds
  std::vector<Level> levels;
  Location location;
};

struct WorldUse {
  std::string id;    // unique; by default the file's name without folder and suffix
  std::string file;  // absolute path of a file that exists
  std::string name;  // as the experiment file names it
  std::vector<Setting> settings;
  Location location;
};

/// What is looked at in the runs of a cell, of a measure's values in them. Runs in which a measure
/// has no value (a null in the results) are left out.
enum class Statistic {
  mean,
  median,
  standard_deviation,  // of the sample: n - 1
  minimum,
  maximum,
  rate,  // the share of runs in which the value is not zero
};

/// Which runs of a cell a statistic is over.
enum class Runs { all, successes };

/// Whether a cell's statistic is looked at by itself or beside that of another cell.
enum class Relation {
  none,
  ratio,       // the cell's divided by the other's
  difference,  // the cell's minus the other's
};

/// Levels of a factor, or ids of worlds ("world").
struct Where {
  std::string factor;
  std::vector<std::string> levels;  // any of these labels; "*" in one stands for any text
};

struct LevelOf {
  std::string factor;  // or "world"
  std::string level;   // its label
};

/// A sentence that is true or false once all runs are done. It holds when it does for every one of
/// Grid::cells_of().
struct Expectation {
  std::string name;  // unique; what JUnit calls the test case
  std::string measure;
  /// Not empty: each run's value is divided by that of this measure; where that is zero, the run
  /// has no value.
  std::string per;
  Statistic statistic = Statistic::mean;
  Runs runs = Runs::all;
  std::vector<Where> where;  // a cell matches all of them; of none: every cell
  /// What the cell's statistic is compared with: that of the cell that differs in these levels
  /// only; see Grid::reference_of().
  Relation relation = Relation::none;
  std::vector<LevelOf> reference;
  // At least one of them; of the statistic, the ratio or the difference:
  std::optional<double> at_least;
  std::optional<double> at_most;
  std::optional<double> about;  // within `tolerance`; then alone
  double tolerance = 0.0;       // of what is compared, for all three; >= 0
  /// None: what comes out is compared as it is. Else the whole of its interval at this confidence,
  /// in (0, 1), must keep to what is expected: by bootstrap (Wilson's for a rate by itself). For a
  /// ratio or a difference, both cells' runs are drawn by their seeds, the same for both.
  std::optional<double> confidence;
  Location location;
};

/// A measure to show, in this order; when none are named: all that the runs have.
struct MeasureUse {
  std::string name;
  Location location;
};

struct Experiment {
  std::string name;
  std::string description;
  std::string file;  // it was read from
  std::vector<WorldUse> worlds;
  std::vector<Setting> settings;  // in every world
  std::vector<Factor> factors;
  std::vector<std::uint64_t> seeds;  // each once, in order
  /// How often each cell and seed is run. The same seed must give the same run: a repetition whose
  /// final state differs is reported as a fault of the experiment's plugins.
  int repeats = 1;
  /// s, simulated, instead of the worlds' own. Cell::overrides have it: nothing else is to be done.
  std::optional<double> time_limit;
  Location limits_location;        // of <limits>, if there is one
  double wall_limit = 600.0;       // s on the clock, for one run
  double trajectory_period = 0.5;  // s, simulated, between two kept poses of a robot
  std::vector<MeasureUse> measures;
  std::vector<Expectation> expectations;
};

/// One world with one level of each factor: what differs between two runs of it is the seed.
struct Cell {
  std::size_t index = 0;            // from 0; worlds outermost, the last factor innermost
  std::size_t world = 0;            // place in Experiment::worlds
  std::vector<std::size_t> levels;  // of each factor, in order
  /// "four_resources, fusion, 2 2": the labels, without those that are the only one.
  std::string label;
  /// In order, the last one of a path counts: the experiment's time limit, its settings, the
  /// world's, those of the levels; "PATH=VALUE". Files that they name are meant as in the
  /// experiment file: read them with world::ReadOptions::overrides_from, as read_cell() does.
  std::vector<std::string> overrides;
};

/// The whole grid, by index.
std::vector<Cell> cells(const Experiment& experiment);

/// How many runs an experiment has: of all cells, with all seeds, as often as each is repeated.
std::uint64_t number_of_runs(const Experiment& experiment);

/// The label of the cell's level of a factor ("world": the id of its world), or none when there is
/// no such factor.
std::optional<std::string> level_of(const Experiment& experiment, const Cell& cell,
                                    const std::string& factor);

}  // namespace elsie::experiment
