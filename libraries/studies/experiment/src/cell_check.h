// Checks every cell before the first run begins.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "elsie/api/measure.h"
#include "elsie/base/problems.h"
#include "elsie/experiment/reader.h"

namespace elsie::experiment {

/// The measures of each cell's runs.
struct CellMeasures {
  std::vector<std::vector<Quantity>> lists;  // the different lists
  std::vector<std::size_t> of_cell;          // index of the list of each cell
  std::vector<std::string> warnings;         // Experiment::warnings
};

/// Reads and builds the world of every cell. Errors in a setting become problems on its line, with
/// the levels that cause them; so do equal cells. `files` are the worlds' files as messages name
/// them; `lists` are the factors whose levels are in values="A; B". The result is complete only if
/// there were no problems.
CellMeasures check_cells(const Experiment& experiment, const std::vector<Cell>& grid,
                         const std::vector<std::string>& files, const std::set<std::size_t>& lists,
                         const plugin::Host& host, const ReadOptions& options,
                         base::Problems& problems);

/// Checks that a name means the same quantity in all cells, that each measure to show exists in
/// some cell, and that every cell of an expectation has its measures.
void check_measures(const Experiment& experiment, const std::vector<Cell>& grid,
                    const CellMeasures& measures, base::Problems& problems);

}  // namespace elsie::experiment
