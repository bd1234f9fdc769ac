// That what is to be shown, and what is expected, is measured at all.
#include <algorithm>
#include <iterator>
#include <map>

#include "elsie/experiment/grid.h"

#include "cell_check.h"

namespace elsie::experiment {

namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Those of each cell that the expectation is about, and of what it is compared with.
void check_expectation(const Expectation& expectation, const std::vector<Cell>& cells,
                       const Grid& grid, const CellMeasures& measures, world::Problems& problems) {
  const auto check = [&](std::size_t cell, const std::string& name) {
    const auto& names = measures.lists[measures.of_cell[cell]];
    if (has(names, name)) {
      return true;
    }
    const bool nowhere = std::none_of(measures.lists.begin(), measures.lists.end(),
                                      [&](const auto& list) { return has(list, name); });
    problems.add(
        expectation.location,
        (nowhere ? "no run has a" : "runs of the cell '" + cells[cell].label + "' have no") +
            " measure '" + name + "'" + world::near_or_all(name, names, "there are"));
    return false;
  };
  for (const std::string& name : {expectation.measure, expectation.per}) {
    for (const std::size_t cell : grid.cells_of(expectation)) {
      const auto other = grid.reference_of(expectation, cell);
      if (!name.empty() && (!check(cell, name) || (other && !check(*other, name)))) {
        break;
      }
    }
  }
}

}  // namespace

void check_measures(const Experiment& experiment, const std::vector<Cell>& cells,
                    const CellMeasures& measures, world::Problems& problems) {
  std::vector<std::string> all;
  for (const auto& names : measures.lists) {
    std::copy_if(names.begin(), names.end(), std::back_inserter(all),
                 [&](const std::string& name) { return !has(all, name); });
  }
  for (const MeasureUse& use : experiment.measures) {
    if (!has(all, use.name)) {
      problems.add(use.location, "no run has a measure '" + use.name + "'" +
                                     world::near_or_all(use.name, all, "there are"));
    }
  }
  const Grid grid(experiment, cells);
  for (const Expectation& expectation : experiment.expectations) {
    check_expectation(expectation, cells, grid, measures, problems);
  }
}

}  // namespace elsie::experiment
