// The grid: which cells there are, and which of them an expectation is about.
#include <algorithm>
#include <string_view>

#include "elsie/experiment/experiment.h"
#include "elsie/world/values.h"

#include "grid.h"

namespace elsie::experiment {

namespace {

// The labels, without those that tell nothing because there is no other.
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

bool is_selected(const Experiment& experiment, const std::vector<Where>& where, const Cell& cell) {
  return std::all_of(where.begin(), where.end(), [&](const Where& each) {
    const auto label = level_of(experiment, cell, each.factor);
    return label &&
           std::any_of(each.levels.begin(), each.levels.end(),
                       [&](const std::string& pattern) { return matches(pattern, *label); });
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
    settings.push_back({"limits/@time", world::format_value(*experiment.time_limit), {}});
  }
  append(experiment.settings);
  append(experiment.worlds[cell.world].settings);
  for (std::size_t i = 0; i < experiment.factors.size(); ++i) {
    append(experiment.factors[i].levels[cell.levels[i]].settings);
  }
  return settings;
}

bool matches(const std::string& pattern, const std::string& label) {
  // After the last star that was met, and what it stood for until now.
  std::size_t star = std::string::npos, stood_for = 0, at = 0, in = 0;
  while (in < label.size()) {
    if (at < pattern.size() && pattern[at] == '*') {
      star = ++at;
      stood_for = in;
    } else if (at < pattern.size() && pattern[at] == label[in]) {
      ++at;
      ++in;
    } else if (star != std::string::npos) {
      at = star;
      in = ++stood_for;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', at) == std::string::npos;
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
      Cell& cell = grid.emplace_back();
      cell.index = grid.size() - 1;
      cell.world = world;
      cell.levels = levels;
      cell.label = label_of(experiment, cell);
      for (const Setting& setting : settings_of(experiment, cell)) {
        cell.overrides.push_back(override_of(setting));
      }
      // The next one, as an odometer counts.
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
  std::uint64_t runs = experiment.worlds.size() * experiment.seeds.size() *
                       static_cast<std::uint64_t>(experiment.repeats);
  for (const Factor& factor : experiment.factors) {
    runs *= factor.levels.size();
  }
  return runs;
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

std::vector<std::size_t> cells_of(const Experiment& experiment, const Expectation& expectation,
                                  const std::vector<Cell>& grid) {
  std::vector<std::size_t> found;
  for (const Cell& cell : grid) {
    if (is_selected(experiment, expectation.where, cell) &&
        reference_of(experiment, expectation, cell) != cell.index) {
      found.push_back(cell.index);
    }
  }
  return found;
}

std::optional<std::size_t> reference_of(const Experiment& experiment,
                                        const Expectation& expectation, const Cell& cell) {
  if (expectation.relation == Relation::none) {
    return std::nullopt;
  }
  // The place of the level that is asked for, or the cell's own.
  const auto place = [&](const std::string& factor, std::size_t own, const auto& levels,
                         const auto& label) {
    for (const LevelOf& other : expectation.reference) {
      if (other.factor == factor) {
        return static_cast<std::size_t>(
            std::find_if(levels.begin(), levels.end(),
                         [&](const auto& level) { return label(level) == other.level; }) -
            levels.begin());
      }
    }
    return own;
  };
  std::size_t index = place(kWorldFactor, cell.world, experiment.worlds,
                            [](const WorldUse& world) { return std::string_view(world.id); });
  for (std::size_t i = 0; i < experiment.factors.size(); ++i) {
    const Factor& factor = experiment.factors[i];
    index = index * factor.levels.size() +
            place(factor.name, cell.levels[i], factor.levels,
                  [](const Level& level) { return std::string_view(level.label); });
  }
  return index;
}

}  // namespace elsie::experiment
