// The contents of an experiment file before they are checked.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/base/problems.h"
#include "elsie/world/description.h"

namespace elsie::experiment {

using base::Location;

struct SettingDraft {
  std::string path;
  std::optional<std::string> value;
  std::optional<std::string> element;  // its markup
  Location location;
};

struct AtDraft {
  double time = 0.0;  // s, simulated
  std::vector<SettingDraft> settings;
  Location location;
};

struct LevelDraft {
  std::optional<std::string> label;
  std::optional<std::string> value;    // for the factor's path
  std::optional<std::string> element;  // likewise
  std::vector<SettingDraft> settings;
  std::vector<AtDraft> changes;
  Location location;
};

struct FactorDraft {
  std::optional<std::string> name;
  std::optional<std::string> path;
  std::optional<std::string> values;
  std::optional<double> from, to, step;
  std::vector<LevelDraft> levels;
  Location location;
};

struct WorldDraft {
  std::optional<std::string> id;
  std::string file;
  std::vector<SettingDraft> settings;
  std::vector<AtDraft> changes;
  Location location;
};

struct SeedsDraft {
  std::optional<std::string> from, to, list;  // no type of attribute has room for all seeds
  int repeats = 1;
  Location location;
};

struct LayoutsDraft : SeedsDraft {
  std::string rule = "crossed";
};

struct LimitsDraft {
  std::optional<double> time;  // s, simulated
  double wall_time = 600.0;    // s
  Location location;
};

struct TrajectoriesDraft {
  double period = 0.5;  // s, simulated
};

struct ExclusionDraft {
  std::string where;
  Location location;
};

struct MeasureDraft {
  std::string name;
  std::optional<std::string> formula, unit, meaning;
  Location location;
};

struct ExpectationDraft {
  std::optional<std::string> name;
  std::string measure;
  std::optional<std::string> per;
  std::optional<std::string> statistic;
  std::string runs = "all";
  std::optional<std::string> where;
  std::optional<std::string> ratio_to;
  std::optional<std::string> difference_from;
  std::optional<double> at_least, at_most, about, tolerance, confidence;
  Location location;
};

struct ExperimentDraft {
  std::optional<std::string> name;
  std::string description;
  std::optional<std::int64_t> max_runs;
  std::vector<WorldDraft> worlds;
  std::vector<SettingDraft> settings;
  std::vector<AtDraft> changes;
  std::vector<FactorDraft> factors;
  std::vector<ExclusionDraft> exclusions;
  std::optional<SeedsDraft> seeds;
  std::optional<LayoutsDraft> layouts;
  std::optional<LimitsDraft> limits;
  std::optional<TrajectoriesDraft> trajectories;
  std::vector<MeasureDraft> measures;
  std::vector<ExpectationDraft> expectations;
};

}  // namespace elsie::experiment
