// The grid of cells.
#include <set>

#include "elsie/experiment/experiment.h"
#include "elsie/experiment/grid.h"
#include "elsie/world/values.h"

#include "grid.h"

namespace elsie::experiment {

namespace {

// The labels of the factors that have several levels.
std::string label_of(const Experiment& experiment, const Cell& cell) {
  const std::string& id = cell.labels.front();
  std::string label = experiment.worlds.size() > 1 ? id : "";
  for (std::size_t i = 0; i < experiment.factors.size(); ++i) {
    if (experiment.factors[i].levels.size() > 1) {
      label += (label.empty() ? "" : ", ") + cell.labels[i + 1];
    }
  }
  return label.empty() ? id : label;
}

void take_out_excluded(const Experiment& experiment, std::vector<Cell>& grid) {
  if (experiment.exclusions.empty()) {
    return;
  }
  const Grid all(experiment, grid);
  std::set<std::size_t> excluded;
  for (const Exclusion& exclusion : experiment.exclusions) {
    const std::vector<std::size_t> found = all.cells_of(exclusion.where);
    excluded.insert(found.begin(), found.end());
  }
  std::size_t at = 0;
  std::erase_if(grid, [&](const Cell&) { return excluded.contains(at++); });
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

std::vector<std::string> factor_names(const Experiment& experiment) {
  std::vector<std::string> names{kWorldFactor};
  for (const Factor& factor : experiment.factors) {
    names.push_back(factor.name);
  }
  return names;
}

std::vector<Cell> cells(const Experiment& experiment) {
  std::vector<Cell> grid;
  for (std::size_t world = 0; world < experiment.worlds.size(); ++world) {
    std::vector<std::size_t> levels(experiment.factors.size(), 0);
    bool more = true;
    while (more) {
      Cell& cell = grid.emplace_back();
      cell.world = world;
      cell.levels = levels;
      cell.labels.push_back(experiment.worlds[world].id);
      for (std::size_t i = 0; i < levels.size(); ++i) {
        cell.labels.push_back(experiment.factors[i].levels[levels[i]].label);
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
  take_out_excluded(experiment, grid);
  for (Cell& cell : grid) {
    cell.index = static_cast<std::size_t>(&cell - grid.data());
    cell.label = label_of(experiment, cell);
    for (const Setting& setting : settings_of(experiment, cell)) {
      if (setting.at_s) {
        cell.changes.push_back(setting);
      } else {
        cell.edits.push_back(override_of(setting));
      }
    }
  }
  return grid;
}

std::uint64_t number_of_runs(const Experiment& experiment) {
  return cells(experiment).size() * experiment.seeds.size() *
         static_cast<std::uint64_t>(experiment.repeats);
}

}  // namespace elsie::experiment
