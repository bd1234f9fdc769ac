// The results by factor: what changes when one thing is varied, over everything else that is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/experiment/grid.h"
#include "elsie/report/findings.h"
#include "elsie/report/survival.h"

namespace elsie::report {

/// A factor with several levels in these results.
struct VariedFactor {
  std::size_t factor = 0;  // index into Results::factors
  std::string name;
  std::vector<std::string> levels;   // in the order of the experiment, numbers ascending
  std::vector<std::size_t> of_cell;  // the level of each cell
  /// The values of the levels if all are different numbers; else empty.
  std::vector<double> numbers;

  bool numeric() const { return !numbers.empty(); }
  /// The cells at a level, ascending.
  std::vector<std::size_t> cells_at(std::size_t level) const;
  /// The cells at each level.
  std::vector<std::vector<std::size_t>> groups() const;
};

/// In the order of the experiment.
std::vector<VariedFactor> varied_factors(const Results& results);

/// The cells by the levels of all factors.
experiment::Grid grid_of(const Results& results);

/// The levels of a cell, empty for these factors (indices into Results::factors).
std::vector<std::string> levels_without(const CellInfo& cell,
                                        const std::vector<std::size_t>& factors);

/// What is looked at: success, or a measure.
struct Response {
  std::optional<std::size_t> measure;  // index into Findings::measures; none: success
  std::string name;                    // "success", "time_s"
  std::string words;                   // "success", "time"
  std::string unit;
};

/// Success, if a cell has goals, and the measures that are shown.
std::vector<Response> responses(const Findings& findings);

/// A run's value of a response.
struct Observation {
  std::uint64_t seed = 0;
  std::size_t cell = 0;
  Observed of;
  std::size_t original = 0;  // the run that it repeats, or itself: see Findings::originals
};

/// The values of the runs of these cells, in the order of the cells and runs. Success is 1 or 0 of
/// every run that ended in a cell with goals; runs that ended abnormally have no other values. A
/// bound of a run that failed is the largest value of all runs.
std::vector<Observation> observations(const Findings& findings, const Response& response,
                                      const std::vector<std::size_t>& cells);

/// Whether the values of all runs are_equal(), or none has any.
bool is_constant(const Findings& findings, const Response& response);

/// All cells of the results.
std::vector<std::size_t> all_cells(const Findings& findings);

/// The cells in both lists, which are ascending.
std::vector<std::size_t> common(const std::vector<std::size_t>& first,
                                const std::vector<std::size_t>& second);

/// Times until the goals of the runs of a cell that ended normally. A run that failed before never
/// reaches them: it stays at risk as long as the longest run (Fine and Gray 1999).
std::vector<Observed> times_to_goals(const Findings& findings, std::size_t cell);

/// Whether a limit or a failure cut off such a time in any cell.
bool any_cut_off(const Findings& findings);

}  // namespace elsie::report
