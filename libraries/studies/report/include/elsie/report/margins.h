// Groups of cells next to each other: which of their runs count, and the centre of each group.
//
// Groups are comparable only if they differ in nothing but the factors that tell them apart.
// Therefore cells count only if they have a match in every group, and seeds only if they have a
// value in each of these cells: the runs that are left are balanced.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "elsie/report/factors.h"

namespace elsie::report {

/// What counts in groups of cells.
struct Balance {
  /// The cells of each group that count, ascending: those with values, of which every group with
  /// values has one with the same levels of the factors that do not tell the groups apart.
  std::vector<std::vector<std::size_t>> groups;
  std::set<std::uint64_t> seeds;  // with a value in each of these cells
  std::size_t dropped_seeds = 0;  // with a value in some of them only
  std::size_t dropped_cells = 0;  // with values, but without a match
  /// True if no cell has a match in every group. All cells count then.
  bool confounded = false;
  std::size_t cells = 0;    // that count
  std::size_t one_run = 0;  // of them, those whose seeds all gave one and the same run
  /// True if a run of any cell has only a bound: all centres of the response are medians.
  bool medians = false;

  /// Returns whether nothing is random: there is then no interval and no test.
  bool certain() const { return cells > 0 && one_run == cells; }
};

/// `named`: the factors that tell the groups apart, indices into Results::factors.
Balance balanced(const Findings& findings, const Response& response,
                 const std::vector<std::vector<std::size_t>>& groups,
                 const std::vector<std::size_t>& named);

/// The values of the runs of a group that count. `once`: of a cell whose seeds all gave one and the
/// same run, only that run.
std::vector<Observation> observations(const Findings& findings, const Response& response,
                                      const Balance& balance, std::size_t group, bool once);

/// What was left out, and what that means, as sentences without a full stop.
std::vector<std::string> notes_on(const Balance& balance);

/// Notes on several things by their names; a note on all of them is there once, without names.
std::vector<std::string> gathered(
    const std::vector<std::pair<std::string, std::vector<std::string>>>& notes);

/// The notes on the main effects of all varied factors.
std::vector<std::string> notes_on_effects(const Findings& findings, const Response& response);

/// Some cells together.
struct Margin {
  std::size_t runs = 0;     // with a value, that count
  double effective = 0.0;   // the number of independent runs that they are worth
  std::size_t cut_off = 0;  // of them, those of which only a bound is known
  std::size_t seeds = 0;    // that count
  std::size_t dropped_seeds = 0;
  std::size_t dropped_cells = 0;
  bool median = false;  // the centre is a median
  /// Success: the rate of all runs. A measure: the mean, where each seed counts with the mean of
  /// its runs; with Balance::medians, the median of all runs if it is known.
  std::optional<double> centre;
  /// Success: Wilson's. A measure: mean_interval() of the seeds; a median: that of survival_of(),
  /// whose upper end may be infinite. Cells that are one run have no part in the uncertainty; none
  /// if all are, and none of a median if any is. Copies of a run do not make it narrower.
  std::optional<Interval> interval;
  std::optional<double>
      at_least;  // the lowest of the bounds, if neither centre nor interval is known
};

Margin margin_of(const Findings& findings, const Response& response, const Balance& balance,
                 std::size_t group, bool with_interval = true);

}  // namespace elsie::report
