// Plots: line charts, heat maps and surfaces over two axes, in rows on a page.
//
// A page is plain data: fill it in and save it. Colour-blind readers can distinguish the colours
// and dashes, also in grey.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/picture/size.h"

namespace elsie::picture {

struct Axis {
  std::string label{};
  std::string unit{};  // "" for a pure number
  // Empty: taken from the data.
  std::optional<double> low{};
  std::optional<double> high{};
  bool logarithmic = false;  // of a line chart: values that are not positive are not drawn
};

/// A curve. Points that are not finite interrupt it.
struct Series {
  std::string name{};
  std::vector<Vector2> points{};  // x and y in the units of the axes
  bool filled = false;            // true: the area down to zero, or to the axis, is tinted
};

/// The position of the series' names.
enum class Naming {
  legend,   // in a line above the chart; a single unnamed series has none
  at_peak,  // above the highest point of each curve
  /// Only in an SVG, when the pointer is over a curve. For curves that repeat the same thing: they
  /// are thin and have one colour, which is "--c" in a page.
  in_titles,
};

struct LineChart {
  std::string title{};
  Axis x{};
  Axis y{};
  std::vector<Series> series{};
  Naming naming = Naming::legend;
};

/// Numbers over a regular grid of two axes.
struct Field {
  Axis x{};  // low and high are required
  Axis y{};
  Axis z{};
  std::size_t columns = 0;       // along x, at least 2
  std::size_t rows = 0;          // along y, at least 2
  std::vector<double> values{};  // rows * columns, row by row from the lowest y; NaN: unknown
};

/// A field as colours, with contour lines and a colour bar.
struct HeatMap {
  std::string title{};
  Field field{};
};

/// A field as a surface in space, seen at an angle from above.
struct Mesh {
  std::string title{};
  Field field{};
};

using Panel = std::variant<LineChart, HeatMap, Mesh>;

struct Row {
  std::vector<Panel> panels{};  // side by side, with equal widths
  std::string title{};          // above all panels
  /// Height of the row without the titles and names above the plots, relative to the width of a
  /// panel; 0: suitable for the panels.
  double aspect = 0.0;
};

struct Page {
  std::string title{};
  std::vector<std::string> subtitles{};
  std::vector<Row> rows{};
};

/// Draws the page into a file of the type that the suffix names, .png or .svg. The same page gives
/// the same bytes. With a height of 0 the picture is as high as its rows need; otherwise the rows
/// share the height.
///
/// Throws std::invalid_argument for another suffix, a size out of range, an axis whose low is not
/// below its high, or a field with the wrong number of values; std::runtime_error when the file
/// cannot be written; an existing file is then unchanged.
void save_page(const Page& page, const std::filesystem::path& file, const Size& size = {});

/// The chart as an element of an HTML page. The page's style defines its colours: --ink, --muted,
/// --grid, --quiet and --c. `label`: for readers who do not see the chart. Throws like save_page()
/// for an axis.
std::string page_chart(const LineChart& chart, const std::string& label, const Size& size);

}  // namespace elsie::picture
