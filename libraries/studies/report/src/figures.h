// Figures of the cells' sections on the page, and what colours mean.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elsie/report/findings.h"
#include "elsie/report/results.h"

namespace elsie::report {

/// The number of colours in page.css, the classes c0 to c5.
inline constexpr std::size_t kColours = 6;

/// The meaning of colours on the whole page.
struct Inks {
  /// The factor whose levels are coloured: the innermost one with a few levels.
  std::optional<std::size_t> factor;
  std::vector<std::string> levels;  // of that factor, in order; the index is the colour
  std::vector<std::size_t> cells;   // colour of each cell
  /// Paths of the behaviours, in descending order of their share in the command; their colours
  /// follow those of the levels.
  std::vector<std::string> behaviors;

  /// "c0"...
  std::string cell_class(std::size_t cell) const;
  /// Below kColours; kColours, grey, for behaviours without a colour of their own.
  std::size_t behavior_colour(const std::string& path) const;
};

Inks choose_inks(const Findings& findings);
/// Adds the behaviours in the timelines of these cells.
void add_behaviors(const ResultsFile& file, const Findings& findings,
                   const std::vector<std::size_t>& cells, Inks& inks);

/// Limits on the drawing of each cell, so that pages with many cells do not become too large.
struct Budget {
  std::size_t points = 0;  // points of paths
  std::size_t runs = 60;   // runs whose paths are drawn
  std::size_t rows = 30;   // rows of decisions: runs or robots
};
Budget budget_for(std::size_t cells);

/// The paths of the runs of a cell over its world.
std::string map_figure(const Findings& findings, std::size_t cell,
                       const std::vector<Trajectory>& ways, const Inks& inks, const Budget& budget);

/// Index of a typical run in Results::runs: of the runs with the most frequent outcome (in a tie,
/// success), the one whose first measure is nearest to their median. Never an outlier in any
/// measure; none if no run is done, or all are outliers.
std::optional<std::size_t> typical_run(const Findings& findings, std::size_t cell);

}  // namespace elsie::report
