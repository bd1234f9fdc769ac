// Figures of the page, as SVG in HTML. Colours are classes of page.css, so that figures are
// readable in light and dark mode; horizontal positions are percentages of the width, so that text
// and marks keep their size on a phone.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/picture/axis.h"
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
  /// Paths of the behaviours, in descending order of deciding time; their colours follow those of
  /// the levels.
  std::vector<std::string> behaviors;

  /// "c0"...; "more" for behaviours without a colour.
  std::string cell_class(std::size_t cell) const;
  std::string behavior_class(const std::string& path) const;
};

Inks choose_inks(const Findings& findings);
/// Adds the behaviours in the timelines of these cells.
void add_behaviors(const ResultsFile& file, const Findings& findings,
                   const std::vector<std::size_t>& cells, Inks& inks);

/// An axis over a figure's width, with a margin, a part of the width, at both ends.
class Span {
 public:
  Span(double low, double high, double margin = 0.025) : low_(low), high_(high), margin_(margin) {}

  double low() const { return low_; }
  double high() const { return high_; }
  /// The position of a value, "34.52%".
  std::string at(double value) const;
  /// The labels of the ticks at the height `y`; without a margin, those at the ends stay inside.
  /// `unit` follows the zero.
  std::string labels(const picture::Ticks& ticks, double y, const std::string& unit = "") const;
  /// The width of an interval of values.
  std::string width(double from, double to) const;

 private:
  double part(double value) const;

  double low_, high_, margin_;
};

/// The axis for values from `low` to `high`: a little wider, and from zero if that is near.
Span span_of(double low, double high);

/// Lines from `top` to `bottom` at round values, with labels below (and above, if asked for).
std::string grid(const Span& span, double top, double bottom, bool labels_above);

/// The success rates of all cells with their intervals.
std::string rate_figure(const Findings& findings, const Inks& inks);

/// Box plots of one measure (an index into Findings::measures) in all cells.
std::string box_figure(const Findings& findings, std::size_t measure, const Inks& inks);

/// Limits on the drawing of each cell, so that pages with many cells do not become too large.
struct Budget {
  std::size_t points = 0;  // points of paths
  std::size_t runs = 60;   // runs whose paths are drawn
  std::size_t rows = 30;   // rows of decisions: runs or robots
  int columns = 600;       // columns of decisions: parts of the time
};
Budget budget_for(std::size_t cells);

/// The paths of the runs of a cell over its world.
std::string map_figure(const Findings& findings, std::size_t cell,
                       const std::vector<Trajectory>& ways, const Inks& inks, const Budget& budget);

/// Which behaviour decided when in the runs of a cell; "" if nothing was recorded.
std::string decision_figure(const Findings& findings, std::size_t cell,
                            const std::vector<Timeline>& timelines, const Inks& inks,
                            const Budget& budget);

/// Learning curves of plugins from before the runs of a cell; "" if there are none.
std::string curve_figures(const Findings& findings, std::size_t cell,
                          const std::vector<Curve>& curves, const Inks& inks);

/// Index of a typical run in Results::runs: of the runs with the most frequent outcome (in a tie,
/// success), the one whose first measure is nearest to their median. Never an outlier in any
/// measure; none if no run is done, or all are outliers.
std::optional<std::size_t> typical_run(const Findings& findings, std::size_t cell);

}  // namespace elsie::report
