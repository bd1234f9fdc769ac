// Plots: line charts, heat maps and surfaces over two axes, tiles and rows of things compared, in
// rows on a page.
//
// A page is plain data: fill it in and save it. Colour-blind readers can distinguish the colours
// and dashes, also in grey.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/picture/axis.h"
#include "elsie/picture/size.h"

namespace elsie::picture {

/// A text at a place on an axis.
struct Tick {
  double at = 0.0;
  std::string text{};
};

struct Axis {
  std::string label{};
  std::string unit{};  // "" for a pure number
  // Empty: taken from the data.
  std::optional<double> low{};
  std::optional<double> high{};
  bool logarithmic = false;   // of a line chart: values that are not positive are not drawn
  std::vector<Tick> names{};  // texts in place of numbers, ascending
};

/// Series::colour: that of the text. Further such curves of a chart are paler, and dashed.
inline constexpr std::size_t kNeutral = static_cast<std::size_t>(-1);

/// How the points of a curve are joined.
enum class Joining { lines, steps, nothing };

/// A curve. Points that are not finite interrupt it.
struct Series {
  std::string name{};
  std::vector<Vector2> points{};  // x and y in the units of the axes
  bool filled = false;            // true: the area down to zero, or to the axis, is tinted
  Joining joining = Joining::lines;
  bool marked = false;  // a mark on every point; its shape follows from the place of the series
  /// Around each point, along y: an area behind the curve, or bars. A bar whose high end is
  /// infinite reaches the edge of the plot and has an arrow. Empty: none.
  std::vector<Interval> spread{};
  bool bars = false;
  std::vector<Vector2> strokes{};  // short upright strokes
  /// Its number among the colours; none: its place in the chart.
  std::optional<std::size_t> colour{};
};

/// Numbers in a row below a chart.
struct NumberRow {
  std::string name{};
  std::vector<Tick> numbers{};
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
  std::string rows_title{};
  std::vector<NumberRow> rows{};  // below the x axis
};

/// Numbers over a regular grid of two axes. There must be a value for each point of the grid.
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
  std::optional<Vector2> mark{};  // a dot; at the border if it is outside
};

/// A field as a surface in space, seen at an angle from above.
struct Mesh {
  std::string title{};
  Field field{};
};

/// Two factors as a table of coloured tiles, each with its text. There must be a value and a text
/// for each tile.
struct Tiles {
  std::string title{};
  Axis x{};  // names: of the columns
  Axis y{};  // names: of the rows, from the lowest
  Axis z{};
  std::vector<double> values{};      // row by row from the lowest; NaN: unknown
  std::vector<std::string> texts{};  // parallel to the values
};

/// A part of a row, of a colour.
struct RowBar {
  Interval from_to{};
  std::size_t colour = 0;
  Interval height{0.0, 1.0};  // of the height of a bar, from the bottom
};

/// A box plot.
struct RowBox {
  Interval whiskers{}, quartiles{};
  double median = 0.0;
};

/// A single value.
struct RowDot {
  double at = 0.0;
  bool crossed = false;  // true: a cross
  bool ringed = false;
  std::string title{};  // what an SVG shows when the pointer is over it
};

/// What is shown of one thing over the common axis. All parts are optional.
struct ChartRow {
  std::string name{};  // on the left; above the rows if some are too long
  std::string note{};  // on the right
  std::size_t colour = 0;
  std::optional<RowBox> box{};
  std::vector<RowDot> dots{};
  std::optional<Interval> interval{};
  std::optional<double> mark{};  // a diamond
  std::vector<RowBar> bars{};
};

/// Things below each other over one axis, as box plots, intervals or bars. In an SVG, bars show the
/// names of their colour when the pointer is over them.
struct RowChart {
  std::string title{};
  Axis x{};
  std::vector<ChartRow> rows{};
  std::vector<std::pair<std::string, std::size_t>> key{};  // names of colours
};

using Panel = std::variant<LineChart, HeatMap, Mesh, Tiles, RowChart>;

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

/// Draws the page into a file of the type that the suffix names, .png, .svg or .pdf. The same page
/// gives the same bytes. With a height of 0 the picture is as high as its rows need; otherwise the
/// rows share the height.
///
/// Throws std::invalid_argument for another suffix, a size out of range, or an axis whose low is
/// not below its high; std::runtime_error when the file cannot be written; an existing file is then
/// unchanged.
void save_page(const Page& page, const std::filesystem::path& file, const Size& size = {});

/// The panel as an element of an HTML page. The page's style defines its colours: --ink, --muted,
/// --grid, --quiet, --surface, --bad, --c, and --c0 to --c5 for the first six of a chart. `label`:
/// for readers who do not see it. A height of 0: as high as the content needs. Throws like
/// save_page() for an axis.
std::string page_chart(const Panel& panel, const std::string& label, const Size& size);

/// The colours of a screen, which may be dark, by the names that page_chart() has for them: "ink",
/// "c0". Those that are not named stay as in a file.
using Style = std::map<std::string, Colour, std::less<>>;

/// The panel as pixels, 0x??RRGGBB, row by row: of this width and height, with so many of them for
/// a unit, of which a text has 12 to 15. Curves differ in dashes, too, from the second on. Throws
/// like save_page() for an axis.
std::vector<std::uint32_t> screen_chart(const Panel& panel, int width, int height, double zoom,
                                        const Style& style);

/// Where screen_chart() puts the plot of a line chart, between its axes: in pixels from the left
/// and from the top, and the values at its left and right edge (exponents of ten of a logarithmic
/// axis).
struct PlotPlace {
  Interval across{}, down{};
  Interval x{};
};
PlotPlace screen_plot(const LineChart& chart, int width, int height, double zoom);

}  // namespace elsie::picture
