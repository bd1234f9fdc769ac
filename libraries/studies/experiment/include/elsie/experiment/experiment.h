// An experiment as plain data, read from its file, checked and complete: its worlds, the factors
// that are varied, the seeds, the measures, and the expected results.
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

/// A setting in a world, as with `elsie run --set`; for paths see ReadOptions::edits. A value
/// may be an element: "<fusion_interval/>".
struct Setting {
  std::string path;
  std::string value;
  Location location;
  std::optional<double> at_s{};  // simulated time of the change; none: before the run
};

/// A value of a factor, with all its settings.
struct Level {
  std::string label;  // unique in its factor: "4 4", "0.25"; without , ; | and *
  std::vector<Setting> settings;
  Location location;
};

/// A varied quantity: each of its levels is combined with each level of all other factors.
struct Factor {
  std::string name;  // unique; "world" is the factor of the worlds
  std::vector<Level> levels;
  Location location;
};

struct WorldUse {
  std::string id;    // unique; by default the file's name without folder and suffix
  std::string file;  // absolute path of a file that exists
  std::string name;  // as in the experiment file
  std::vector<Setting> settings;
  Location location;
};

/// A statistic of a measure over the runs of a cell. Runs without a value (null in the results) are
/// ignored.
enum class Statistic {
  mean,
  median,
  standard_deviation,  // of the sample: n - 1
  minimum,
  maximum,
  rate,  // share of runs with a value other than 0
};

/// The runs of a cell that a statistic covers.
enum class Runs { all, successes };

/// Whether a cell's statistic is judged alone or relative to that of another cell.
enum class Relation {
  none,
  ratio,       // the cell's divided by the other's
  difference,  // the cell's minus the other's
};

/// Levels of a factor, or ids of worlds ("world").
struct Where {
  std::string factor;
  std::vector<std::string> levels;  // a cell matches any of these labels; "*" stands for any text
};

struct LevelOf {
  std::string factor;  // or "world"
  std::string level;   // its label
};

/// A statement that is true or false once all runs are done. It holds if it holds for each of
/// Grid::cells_of().
struct Expectation {
  std::string name;  // unique; the name of JUnit's test case
  std::string measure;
  /// If not empty, each run's value is divided by the value of this measure; where that is 0, the
  /// run has no value.
  std::string per;
  Statistic statistic = Statistic::mean;
  Runs runs = Runs::all;
  std::vector<Where> where;  // a cell must match all of these; empty: every cell
  /// The cell's statistic is compared with that of the cell that differs only in the levels of
  /// `reference`; see Grid::reference_of().
  Relation relation = Relation::none;
  std::vector<LevelOf> reference;
  // At least one of these; bounds of the statistic, the ratio or the difference:
  std::optional<double> at_least;
  std::optional<double> at_most;
  std::optional<double> about;  // within `tolerance`; excludes the other two
  double tolerance = 0.0;       // >= 0, of the compared number, for all three
  /// None: only the compared number is judged. Otherwise its whole interval at this confidence, in
  /// (0, 1), must be within the bounds: Wilson's for a rate alone, else by bootstrap. For a ratio
  /// or a difference, the runs of both cells are drawn by the same seeds.
  std::optional<double> confidence;
  Location location;
};

/// Cells that are left out of the grid: those that match all of these.
struct Exclusion {
  std::vector<Where> where;
  Location location;
};

/// A measure to show, in this order; if only formulas are named, all measures of the runs are
/// shown, and then these.
struct MeasureUse {
  std::string name;
  Location location;
  /// If not empty, the measure is computed from others, from factors whose labels are numbers, and
  /// from formulas before it, when results are read. See Formula.
  std::string formula;
  std::string unit;     // of a formula; "" for a pure number
  std::string meaning;  // of a formula
};

/// The names of measures to show; none: all.
std::vector<std::string> shown_measures(const std::vector<MeasureUse>& uses);

struct Experiment {
  std::string name;
  std::string description;
  std::string file;  // the experiment file
  std::vector<WorldUse> worlds;
  std::vector<Setting> settings;  // for every world
  std::vector<Factor> factors;
  std::vector<Exclusion> exclusions;
  std::vector<std::uint64_t> seeds;  // unique, in order
  /// The number of runs of each cell with each seed. Equal seeds must give equal runs: a repetition
  /// with another final state is reported as a fault of the plugins.
  int repeats = 1;
  /// Whether the layouts of every world must follow the seeds of the runs: another layout for each
  /// seed. Otherwise each world may say from which seed its layouts are drawn.
  bool layouts_follow_seeds = false;
  Location layouts_location;
  /// s, simulated; replaces the limit of the worlds. Already included in Cell::edits.
  std::optional<double> time_limit;
  Location limits_location;        // of <limits>, if it exists
  double wall_limit = 600.0;       // s on the clock, for one run
  double trajectory_period = 0.5;  // s, simulated, between two kept poses of a robot
  std::vector<MeasureUse> measures;
  std::vector<Expectation> expectations;
  /// Warnings of edits that no run of a cell makes, and of what has no effect in a cell's world,
  /// each once: "study.xml:12: warning: ...". Only filled by a reader that checks the cells.
  std::vector<std::string> warnings;
};

/// One world with one level of each factor. Its runs differ in their seeds only.
struct Cell {
  std::size_t index = 0;            // from 0; worlds outermost, the last factor innermost
  std::size_t world = 0;            // index into Experiment::worlds
  std::vector<std::size_t> levels;  // index of each factor's level, in order
  std::vector<std::string> labels;  // the id of its world, and the label of each factor's level
  /// "four_resources, fusion, 2 2": the labels of factors with several levels.
  std::string label;
  /// "PATH=VALUE" in order; the last one of a path counts: the experiment's time limit, its
  /// settings, those of the world, those of the levels. Paths of files in them are relative to the
  /// experiment file: read them with world::ReadOptions::edits_from, as read_cell() does.
  std::vector<std::string> edits;
  std::vector<Setting> changes;  // settings that are made during the run, in the same order
};

/// All cells, by index.
std::vector<Cell> cells(const Experiment& experiment);

/// The number of runs: cells times seeds times repetitions.
std::uint64_t number_of_runs(const Experiment& experiment);

/// "world", and the names of the factors: parallel to Cell::labels.
std::vector<std::string> factor_names(const Experiment& experiment);

}  // namespace elsie::experiment
