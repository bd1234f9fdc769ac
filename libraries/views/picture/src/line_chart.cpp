#include <algorithm>
#include <cmath>

#include "elsie/picture/polyline.h"

#include "panel.h"
#include "text.h"

namespace elsie::picture {
namespace {

constexpr double kLegendRow = 20.0;
constexpr double kNameRow = 16.0;
constexpr double kSwatch = 26.0;

Interval data_range(const LineChart& chart, double Vector2::*coordinate, const Axis& axis,
                    bool margin) {
  Interval range;
  for (const Series& series : chart.series) {
    for (const Vector2& point : series.points) {
      if (finite(point)) range.include(point.*coordinate);
    }
  }
  if (range.empty()) return {0.0, 1.0};
  if (axis.logarithmic) {  // whole powers of ten
    const double low = std::floor(range.low);
    return {low, std::max(low + 1.0, std::ceil(range.high))};
  }
  const double extra = margin ? 0.05 * range.span() : 0.0;
  range = range.widened();
  return {range.low - extra, range.high + extra};
}

Ink ink_of(const LineChart& chart, std::size_t index) {
  if (chart.naming != Naming::in_titles) return series_ink(index);
  Ink ink = series_ink(0).with_alpha(0.5);
  ink.role = "c";
  return ink;
}

// After all colours, they repeat with dashed and then dotted lines.
Pen pen_of(const LineChart& chart, std::size_t index) {
  if (chart.naming == Naming::in_titles) return {.width = 1.2, .dash = {}, .round = true};
  Pen pen{.width = 2.0, .dash = {}, .round = true};
  const std::size_t round = index / kSeriesInks;
  if (round % 3 == 1) pen.dash = {7, 5};
  if (round % 3 == 2) pen.dash = {1, 4.5};
  return pen;
}

// A name and its place: x is its left edge; rows count upwards for peaks, downwards in the legend.
struct Name {
  std::string text;
  std::size_t series = 0;
  double x = 0.0, width = 0.0;
  int row = 0;
};

std::vector<Name> legend(const Canvas& canvas, const LineChart& chart, double width) {
  std::vector<Name> names;
  Flow flow(width, 18.0);
  const bool needed = chart.series.size() > 1;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    if (chart.series[i].name.empty() && !needed) continue;
    const TextStyle style{.size = kTick};
    const std::string text = canvas.fitted(chart.series[i].name, style, width - kSwatch - 6);
    const double entry = kSwatch + 6 + canvas.text_width(text, style);
    names.push_back({text, i, flow.place(entry), entry, flow.row()});
  }
  return names;
}

// The middle of the highest part of a curve in the range; false for a flat or empty one.
bool peak(const Series& series, const Interval& x_range, Vector2& result) {
  double first = 0.0, last = 0.0, top = 0.0;
  bool any = false;
  for (const Vector2& p : series.points) {
    if (!finite(p) || p.x < x_range.low || p.x > x_range.high) continue;
    if (!any || p.y > top + 1e-9) {
      first = last = p.x;
      top = p.y;
    } else if (p.y >= top - 1e-9) {
      last = p.x;
    }
    any = true;
  }
  result = {(first + last) / 2, top};
  return any;
}

std::vector<Name> peak_names(const Canvas& canvas, const LineChart& chart, const Rect& plot,
                             const Interval& x_range) {
  std::vector<Name> names;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    Vector2 top;
    if (chart.series[i].name.empty() || !peak(chart.series[i], x_range, top)) continue;
    const TextStyle style{.size = kTick, .bold = true};
    const std::string text = canvas.fitted(chart.series[i].name, style, plot.width / 2);
    const double width = canvas.text_width(text, style);
    const double middle = plot.x + plot.width * x_range.part(top.x);
    const double x = std::clamp(middle - width / 2, plot.x, plot.right() - width);
    names.push_back({text, i, x, width, 0});
  }
  std::stable_sort(names.begin(), names.end(),
                   [](const Name& a, const Name& b) { return a.x < b.x; });
  // Each on the lowest row on which it does not overlap its neighbour.
  std::vector<double> ends;
  for (Name& name : names) {
    const auto free =
        std::find_if(ends.begin(), ends.end(), [&](double end) { return end + 8 <= name.x; });
    name.row = static_cast<int>(free - ends.begin());
    if (free == ends.end()) ends.push_back(0.0);
    ends[static_cast<std::size_t>(name.row)] = name.x + name.width;
  }
  return names;
}

int rows_of(const std::vector<Name>& names) {
  int rows = 0;
  for (const Name& name : names) rows = std::max(rows, name.row + 1);
  return rows;
}

// The parts of a curve, in units of the drawing.
std::vector<std::vector<Vector2>> parts(const Series& series, const PlaneMap& map, double zoom) {
  std::vector<Vector2> points;
  for (const Vector2& point : series.points) points.push_back(map.pixel(point));
  std::vector<std::vector<Vector2>> result = pieces(points);
  for (auto& piece : result) piece = simplified(piece, 0.4 / zoom);
  return result;
}

void draw_series(Canvas& canvas, const LineChart& chart, const PlaneMap& map, const Rect& plot) {
  canvas.rectangle({plot.x, plot.y - 2, plot.width, plot.height + 4});
  const Clip clip(canvas);
  const double zero = chart.y.logarithmic ? plot.bottom() : map.pixel({0, 0}).y;
  const double base = std::clamp(zero, plot.y, plot.bottom());
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    if (!chart.series[i].filled) continue;
    for (const auto& piece : parts(chart.series[i], map, canvas.zoom())) {
      if (piece.size() < 2) continue;
      canvas.polyline(piece).line_to({piece.back().x, base}).line_to({piece.front().x, base});
      canvas.close().fill(ink_of(chart, i).with_alpha(0.13));
    }
  }
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    canvas.open_mark(chart.series[i].name);
    for (const auto& piece : parts(chart.series[i], map, canvas.zoom())) {
      if (piece.size() == 1) {
        canvas.circle(piece.front(), 2.5).fill(ink_of(chart, i));
      } else {
        canvas.polyline(piece).stroke(ink_of(chart, i), pen_of(chart, i));
      }
    }
    canvas.close_mark();
  }
}

// The space around the plot.
struct Surroundings {
  Interval x_range, y_range;
  double left = 0.0, width = 0.0;  // of the plot
  double below = 0.0;
  std::vector<Name> names;
};

Surroundings surroundings(const Canvas& canvas, const LineChart& chart, double width) {
  Surroundings around;
  around.x_range = interval_of(chart.x, data_range(chart, &Vector2::x, chart.x, false));
  around.y_range = interval_of(chart.y, data_range(chart, &Vector2::y, chart.y, true));
  around.left = y_labels_width(canvas, chart.y, around.y_range, 0.5 * width) +
                (chart.y.label.empty() ? 14 : 32);
  around.width = std::max(10.0, width - around.left - 10);
  around.below = with_unit(chart.x.label, chart.x.unit).empty() ? 26 : 44;
  const Rect plot{0.0, 0.0, around.width, 1.0};
  if (chart.naming == Naming::legend) around.names = legend(canvas, chart, around.width);
  if (chart.naming == Naming::at_peak) {
    around.names = peak_names(canvas, chart, plot, around.x_range);
  }
  return around;
}

double names_height(const LineChart& chart, const std::vector<Name>& names) {
  return rows_of(names) * (chart.naming == Naming::legend ? kLegendRow : kNameRow) + 6;
}

}  // namespace

LineChart in_exponents(LineChart chart) {
  const auto convert = [&](Axis& axis, double Vector2::*coordinate) {
    if (!axis.logarithmic) return;
    for (auto* limit : {&axis.low, &axis.high}) {
      if (*limit) *limit = std::log10(**limit);
    }
    for (Series& series : chart.series) {
      for (Vector2& point : series.points) point.*coordinate = std::log10(point.*coordinate);
    }
  };
  convert(chart.x, &Vector2::x);
  convert(chart.y, &Vector2::y);
  return chart;
}

double head_height(const Canvas& canvas, const LineChart& values, double width) {
  const LineChart chart = in_exponents(values);
  return (chart.title.empty() ? 0.0 : kPanelTitle + 10) +
         names_height(chart, surroundings(canvas, chart, width).names);
}

void draw(Canvas& canvas, const LineChart& values, const Rect& area, double head) {
  const LineChart chart = in_exponents(values);
  const Surroundings around = surroundings(canvas, chart, area.width);
  const Rect plot{area.x + around.left, area.y + head, around.width,
                  std::max(10.0, area.height - head - around.below)};
  draw_axes(canvas, plot, chart.x, around.x_range, chart.y, around.y_range);
  draw_series(canvas, chart, map_to(plot, around.x_range, around.y_range), plot);

  const TextStyle title{.size = kPanelTitle, .bold = true, .down = Down::top};
  canvas.text(canvas.fitted(chart.title, title, plot.width), {plot.x, area.y}, title);
  const double names_top = plot.y - names_height(chart, around.names);
  for (const Name& name : around.names) {
    const Ink colour = ink_of(chart, name.series);
    const double x = plot.x + name.x;
    if (chart.naming == Naming::legend) {
      const double y = names_top + kLegendRow * name.row + kLegendRow / 2;
      canvas.line({x, y}, {x + kSwatch, y}).stroke(colour, pen_of(chart, name.series));
      canvas.text(name.text, {x + kSwatch + 6, y}, {.size = kTick, .down = Down::middle});
    } else {
      canvas.text(name.text, {x, plot.y - 7 - kNameRow * name.row},
                  {.size = kTick, .bold = true, .ink = readable(colour)});
    }
  }
}

}  // namespace elsie::picture
