// The grid of cells.
#include <algorithm>

#include "elsie/experiment/experiment.h"
#include "elsie/world/values.h"

#include "grid.h"

namespace elsie::experiment {

namespace {

// The labels of the factors that have several levels.
std::string label_of(const Experiment& experiment, const Cell& cell) {
  const std::string& id = experiment.worlds[cell.world].id;
  std::string label = experiment.worlds.size() > 1 ? id : "";
  for (std::size_t i = 0; i < experiment.factors.size(); ++i) {
    const std::vector<Level>& levels = experiment.factors[i].levels;
    if (levels.size() > 1) {
      label += (label.empty() ? "" : ", ") + levels[cell.levels[i]].label;
    }
  }
  return label.empty() ? id : label;
}

bool has_any(const Where& where, const std::optional<std::string>& label) {
  return label && std::any_of(where.levels.begin(), where.levels.end(),
                              [&](const std::string& pattern) { return matches(pattern, *label); });
}

bool is_excluded(const Experiment& experiment, const Cell& cell) {
  return std::any_of(
      experiment.exclusions.begin(), experiment.exclusions.end(), [&](const Exclusion& exclusion) {
        return std::all_of(exclusion.where.begin(), exclusion.where.end(), [&](const Where& where) {
          return has_any(where, level_of(experiment, cell, where.factor));
        });
      });
}

}  // namespace

std::string override_of(const Setting& setting) { return setting.path + "=" + setting.value; }

std::vector<Setting> settings_of(const Experiment& experiment, const Cell& cell) {
  std::vector<Setting> settings;
  const auto append = [&](const std::vector<Setting>& more) {
    settings.insert(settings.end(), more.begin(), more.end());
  };
  if (experiment.time_limit) {
    settings.push_back(
        {kTimeLimitPath, world::format_value(*experiment.time_limit), experiment.limits_location});
  }
  append(experiment.settings);
  append(experiment.worlds[cell.world].settings);
  for (std::size_t i = 0; i < experiment.factors.size(); ++i) {
    append(experiment.factors[i].levels[cell.levels[i]].settings);
  }
  return settings;
}

std::vector<std::string> labels_of(const Experiment& experiment, const std::string& factor) {
  std::vector<std::string> labels;
  if (factor == kWorldFactor) {
    for (const WorldUse& world : experiment.worlds) {
      labels.push_back(world.id);
    }
  }
  for (const Factor& each : experiment.factors) {
    for (const Level& level : each.levels) {
      if (each.name == factor) {
        labels.push_back(level.label);
      }
    }
  }
  return labels;
}

std::vector<Cell> cells(const Experiment& experiment) {
  std::vector<Cell> grid;
  for (std::size_t world = 0; world < experiment.worlds.size(); ++world) {
    std::vector<std::size_t> levels(experiment.factors.size(), 0);
    bool more = true;
    while (more) {
      Cell cell;
      cell.index = grid.size();
      cell.world = world;
      cell.levels = levels;
      if (!is_excluded(experiment, cell)) {
        cell.label = label_of(experiment, cell);
        for (const Setting& setting : settings_of(experiment, cell)) {
          if (setting.at_s) {
            cell.changes.push_back(setting);
          } else {
            cell.edits.push_back(override_of(setting));
          }
        }
        grid.push_back(std::move(cell));
      }
      // Advances to the next cell like an odometer.
      more = false;
      for (std::size_t i = levels.size(); i > 0 && !more; --i) {
        more = ++levels[i - 1] < experiment.factors[i - 1].levels.size();
        if (!more) {
          levels[i - 1] = 0;
        }
      }
    }
  }
  return grid;
}

std::uint64_t number_of_runs(const Experiment& experiment) {
  return cells(experiment).size() * experiment.seeds.size() *
         static_cast<std::uint64_t>(experiment.repeats);
}

std::optional<std::string> level_of(const Experiment& experiment, const Cell& cell,
                                    const std::string& factor) {
  if (factor == kWorldFactor) {
    return experiment.worlds[cell.world].id;
  }
  for (std::size_t i = 0; i < experiment.factors.size(); ++i) {
    if (experiment.factors[i].name == factor) {
      return experiment.factors[i].levels[cell.levels[i]].label;
    }
  }
  return std::nullopt;
}

}  // namespace elsie::experiment
