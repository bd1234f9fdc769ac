// Checks that all measures to show, and those of expectations, exist and are the same quantity in
// every cell.
#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "elsie/base/near_name.h"
#include "elsie/experiment/grid.h"

#include "cell_check.h"

namespace elsie::experiment {

namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> names_of(const std::vector<Quantity>& quantities) {
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities) {
    names.push_back(quantity.name);
  }
  return names;
}

// "'simulated time until the run ended' in s"
std::string in_words(const Quantity& quantity) {
  return "'" + quantity.meaning + "'" + (quantity.unit.empty() ? "" : " in " + quantity.unit);
}

// The line on which two cells differ: that of the second cell's world, or of its level of the last
// factor that differs.
const Location& difference(const Experiment& experiment, const Cell& one, const Cell& other) {
  const Location* where = &experiment.worlds[other.world].location;
  for (std::size_t i = 0; one.world == other.world && i < experiment.factors.size(); ++i) {
    if (one.levels[i] != other.levels[i]) {
      where = &experiment.factors[i].levels[other.levels[i]].location;
    }
  }
  return *where;
}

// Tables combine values of the same name from all cells.
void check_quantities(const Experiment& experiment, const std::vector<Cell>& grid,
                      const CellMeasures& measures, base::Problems& problems) {
  struct Known {
    Quantity quantity;
    std::size_t cell;  // the first cell that has it
  };
  std::map<std::string, Known> known;
  std::set<std::string> complained;
  for (std::size_t list = 0; list < measures.lists.size(); ++list) {
    const auto first = std::find(measures.of_cell.begin(), measures.of_cell.end(), list);
    const auto cell = static_cast<std::size_t>(first - measures.of_cell.begin());
    for (const Quantity& quantity : measures.lists[list]) {
      const auto [at, is_new] = known.emplace(quantity.name, Known{quantity, cell});
      const Known& before = at->second;
      if (!is_new && quantity != before.quantity && complained.insert(quantity.name).second) {
        problems.add(difference(experiment, grid[before.cell], grid[cell]),
                     "the measure '" + quantity.name + "' is two things: in the cell '" +
                         grid[before.cell].label + "' it is " + in_words(before.quantity) +
                         ", in the cell '" + grid[cell].label + "' " + in_words(quantity) +
                         "; expected one: give one of them another id in <measures>");
      }
    }
  }
}

// Checks the cells that the expectation covers, and those with which they are compared.
void check_expectation(const Expectation& expectation, const std::vector<Cell>& cells,
                       const Grid& grid, const CellMeasures& measures, base::Problems& problems) {
  const auto check = [&](std::size_t cell, const std::string& name) {
    const auto names = names_of(measures.lists[measures.of_cell[cell]]);
    if (has(names, name)) {
      return true;
    }
    const bool nowhere = std::none_of(measures.lists.begin(), measures.lists.end(),
                                      [&](const auto& list) { return has(names_of(list), name); });
    problems.add(
        expectation.location,
        (nowhere ? "no run has a" : "runs of the cell '" + cells[cell].label + "' have no") +
            " measure '" + name + "'" + base::near_or_all(name, names, "there are"));
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
                    const CellMeasures& measures, base::Problems& problems) {
  check_quantities(experiment, cells, measures, problems);
  std::vector<std::string> all;
  for (const auto& list : measures.lists) {
    const std::vector<std::string> names = names_of(list);
    std::copy_if(names.begin(), names.end(), std::back_inserter(all),
                 [&](const std::string& name) { return !has(all, name); });
  }
  for (const MeasureUse& use : experiment.measures) {
    if (use.formula.empty() && !has(all, use.name)) {
      problems.add(use.location, "no run has a measure '" + use.name + "'" +
                                     base::near_or_all(use.name, all, "there are"));
    }
  }
  const Grid grid(experiment, cells);
  for (const Expectation& expectation : experiment.expectations) {
    check_expectation(expectation, cells, grid, measures, problems);
  }
}

}  // namespace elsie::experiment
