// Which cells an expectation is about, and what each of them is compared with: one answer for those
// who check an experiment before it is run, and for those who have its results only.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/experiment/experiment.h"

namespace elsie::experiment {

/// The cells of an experiment by the labels of their levels, in words of the experiment file.
class Grid {
 public:
  /// `factors` by name, "world" for that of the worlds; of each cell a label for each of them.
  /// Throws std::invalid_argument when a cell has more or fewer.
  Grid(std::vector<std::string> factors, std::vector<std::vector<std::string>> cells);

  /// `cells` is all of cells(experiment).
  Grid(const Experiment& experiment, const std::vector<Cell>& cells);

  /// The cells that an expectation is about, by place, in order: those that match its `where` and
  /// are not their own reference. A factor that is not there matches nothing.
  std::vector<std::size_t> cells_of(const Expectation& expectation) const;

  /// The cell that this one is compared with, by place: the one that has the levels of the
  /// expectation's `reference`, and this cell's in all other factors. None when the expectation
  /// compares with none, and when there is no such cell.
  std::optional<std::size_t> reference_of(const Expectation& expectation, std::size_t cell) const;

 private:
  std::optional<std::size_t> place_of(const std::string& factor) const;

  std::vector<std::string> factors_;
  std::vector<std::vector<std::string>> cells_;
  std::map<std::vector<std::string>, std::size_t> places_;  // of the cells
};

}  // namespace elsie::experiment
