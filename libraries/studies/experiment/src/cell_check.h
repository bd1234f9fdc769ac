// Making sure of every cell before the first run begins.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "elsie/api/measure.h"
#include "elsie/base/problems.h"
#include "elsie/experiment/reader.h"

namespace elsie::experiment {

/// What the runs of each cell are measured by.
struct CellMeasures {
  std::vector<std::vector<Quantity>> lists;  // that differ
  std::vector<std::size_t> of_cell;          // the place of its list
};

/// Reads the world of every cell and puts it together. Mistakes in a setting become problems where
/// it stands, with the levels that it takes to make them; so do cells between which there is no
/// difference. `files` are the worlds' files as messages should call them, `lists` the factors
/// whose levels stand in values="A; B". Complete only when there were no problems.
CellMeasures check_cells(const Experiment& experiment, const std::vector<Cell>& grid,
                         const std::vector<std::string>& files, const std::set<std::size_t>& lists,
                         const plugin::Host& host, const ReadOptions& options,
                         base::Problems& problems);

/// That a name means one quantity in all cells; that a measure to show is one of some cell, and one
/// of an expectation that of every cell that it is about.
void check_measures(const Experiment& experiment, const std::vector<Cell>& grid,
                    const CellMeasures& measures, base::Problems& problems);

}  // namespace elsie::experiment
