// Finds the cells that an expectation covers, and the cell with which each of them is compared. It
// is used to check an experiment before it is run, and to judge results without its file.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/experiment/experiment.h"
#include "elsie/experiment/where.h"

namespace elsie::experiment {

/// The cells of an experiment by the labels of their levels.
class Grid {
 public:
  /// `factors` are names, "world" for the worlds; `cells` has a label of each factor for each cell.
  /// Throws std::invalid_argument if a cell has more or fewer labels.
  Grid(std::vector<std::string> factors, std::vector<std::vector<std::string>> cells);

  /// `cells` must be all of cells(experiment).
  Grid(const Experiment& experiment, const std::vector<Cell>& cells);

  /// The indices of the cells that an expectation covers, in order: those that match its `where`
  /// and are not their own reference. An unknown factor matches no cell.
  std::vector<std::size_t> cells_of(const Expectation& expectation) const;

  /// Indices of the cells that match, in order. An unknown factor matches nothing.
  std::vector<std::size_t> cells_of(const std::vector<Where>& where) const;

  /// The index of the cell with which this one is compared: it has the levels of the expectation's
  /// `reference`, and this cell's levels of all other factors. None if the expectation has no
  /// reference, or there is no such cell.
  std::optional<std::size_t> reference_of(const Expectation& expectation, std::size_t cell) const;

  /// The index of a factor, if it is there.
  std::optional<std::size_t> place_of(const std::string& factor) const;

  /// The factors with the labels that cells have, each once: what a choice of cells may name.
  std::vector<Labels> labels() const;

 private:
  std::vector<std::string> factors_;
  std::vector<std::vector<std::string>> cells_;
  std::map<std::vector<std::string>, std::size_t> places_;  // indices of the cells
};

}  // namespace elsie::experiment
