// Figures of the page, as SVG inside of HTML. Colours are classes of page.css, so that a figure is
// readable in light and dark; what is wide is placed in parts of the width (percent), so that text
// and marks keep their size on a phone.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/report/findings.h"
#include "elsie/report/results.h"

namespace elsie::report {

/// The colours that page.css has for things to be told apart: classes c0 to c5.
inline constexpr std::size_t kColours = 6;

/// Which colour means what, on the whole page.
struct Inks {
  /// The factor whose levels have colours: the innermost one with several that are few enough.
  std::optional<std::size_t> factor;
  std::vector<std::string> levels;  // of that factor, in order; each has the colour of its place
  std::vector<std::size_t> cells;   // the colour of each cell
  /// The behaviours by their paths, those that decide most first; they begin where the levels end.
  std::vector<std::string> behaviors;

  /// "c0"...; "more" for behaviours that there is no colour for.
  std::string cell_class(std::size_t cell) const;
  std::string behavior_class(const std::string& path) const;
};

Inks choose_inks(const Findings& findings);
/// Completes the inks from the timelines of these cells.
void add_behaviors(const ResultsFile& file, const Findings& findings,
                   const std::vector<std::size_t>& cells, Inks& inks);

/// An axis from 0 to 1 of a figure's width, with a little room at both ends.
class Span {
 public:
  Span(double low, double high) : low_(low), high_(high) {}

  double low() const { return low_; }
  double high() const { return high_; }
  /// "34.52%"
  std::string at(double value) const;
  /// How wide an interval of values is.
  std::string width(double from, double to) const;

 private:
  double part(double value) const;

  double low_, high_;
};

/// The axis for values from `low` to `high`: a little wider, from zero where that is near.
Span span_of(double low, double high);

/// Lines from `top` to `bottom` at round values, and their labels below (and above, where asked).
std::string grid(const Span& span, double top, double bottom, bool labels_above);

/// The rates of success of all cells with their intervals.
std::string rate_figure(const Findings& findings, const Inks& inks);

/// The values of one measure (a place in Findings::measures) in all cells.
std::string box_figure(const Findings& findings, std::size_t measure, const Inks& inks);

/// How much may be drawn of each cell, so that pages with many cells do not become too large.
struct Budget {
  std::size_t points = 0;  // of ways
  std::size_t runs = 60;   // whose ways are drawn
  std::size_t rows = 30;   // of runs or robots, of who decided when
  int columns = 600;       // of time
};
Budget budget_for(std::size_t cells);

/// Where the runs of a cell went, over its world.
std::string map_figure(const Findings& findings, std::size_t cell,
                       const std::vector<Trajectory>& ways, const Inks& inks, const Budget& budget);

/// Who decided when, in the runs of a cell; "" when nobody noted that.
std::string decision_figure(const Findings& findings, std::size_t cell,
                            const std::vector<Timeline>& timelines, const Inks& inks,
                            const Budget& budget);

/// What plugins learned before the runs of a cell; "" for nothing.
std::string curve_figures(const Findings& findings, std::size_t cell,
                          const std::vector<Curve>& curves, const Inks& inks);

/// Of a cell's runs with the commonest outcome (of two as common, success) the one whose first
/// measure is nearest to their median; never an outlier in any measure. A place in Results::runs;
/// none when no run ended by itself, or all of these are outliers.
std::optional<std::size_t> typical_run(const Findings& findings, std::size_t cell);

}  // namespace elsie::report
