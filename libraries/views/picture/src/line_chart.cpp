#include <algorithm>
#include <cmath>

#include "elsie/picture/polyline.h"

#include "panel.h"
#include "text.h"

namespace elsie::picture {
namespace {

constexpr double kLegendRow = 20.0;
constexpr double kNameRow = 16.0;
constexpr double kNumberRow = 16.0;
constexpr double kMostOfRow = 0.3;  // of the chart's width for the names of rows of numbers

Interval data_range(const LineChart& chart, double Vector2::*coordinate, const Axis& axis,
                    bool margin) {
  Interval range;
  for (const Series& series : chart.series) {
    for (const Vector2& point : series.points) {
      if (finite(point)) range.include(point.*coordinate);
    }
    for (std::size_t i = 0; margin && i < std::min(series.spread.size(), series.points.size());
         ++i) {
      range.include(series.spread[i].low);
      range.include(series.spread[i].high);
    }
  }
  if (!axis.names.empty()) return {axis.names.front().at - 0.5, axis.names.back().at + 0.5};
  if (range.empty()) return {0.0, 1.0};
  if (axis.logarithmic) {  // whole powers of ten
    const double low = std::floor(range.low);
    return {low, std::max(low + 1.0, std::ceil(range.high))};
  }
  const double extra = margin ? 0.05 * range.span() : 0.0;
  range = range.widened();
  return {range.low - extra, range.high + extra};
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

// The space around the plot.
struct Surroundings {
  Interval x_range, y_range;
  double left = 0.0, width = 0.0;  // of the plot
  double below = 0.0;              // of the axis: its labels
  double rows = 0.0;               // of the rows of numbers below it
  std::vector<Name> names;
};

Surroundings surroundings(const Canvas& canvas, const LineChart& chart, double width) {
  Surroundings around;
  around.x_range = interval_of(chart.x, data_range(chart, &Vector2::x, chart.x, false));
  around.y_range = interval_of(chart.y, data_range(chart, &Vector2::y, chart.y, true));
  around.left = y_labels_width(canvas, chart.y, around.y_range, 0.5 * width) +
                (chart.y.label.empty() ? 14 : 32);
  if (!chart.rows.empty()) {
    double widest = canvas.text_width(chart.rows_title, {.size = kTick});
    for (const NumberRow& row : chart.rows) {
      widest = std::max(widest, canvas.text_width(row.name, {.size = kTick}));
    }
    around.left = std::max(around.left, std::min(widest, kMostOfRow * width) + 26);
    around.rows = kNumberRow * static_cast<double>(chart.rows.size() + 1) + 4;
  }
  around.width = std::max(10.0, width - around.left - 10);
  around.below = (with_unit(chart.x.label, chart.x.unit).empty() ? 26 : 44) +
                 (folds(canvas, chart.x, around.x_range, around.width) ? kFold : 0.0);
  const Rect plot{0.0, 0.0, around.width, 1.0};
  if (chart.naming == Naming::legend) around.names = legend(canvas, chart, around.width);
  if (chart.naming == Naming::at_peak) {
    around.names = peak_names(canvas, chart, plot, around.x_range);
  }
  return around;
}

// The numbers below the chart, each below its place on the axis.
void draw_rows(Canvas& canvas, const LineChart& chart, const Surroundings& around, const Rect& plot,
               double left) {
  const double first = plot.bottom() + around.below + kNumberRow / 2;
  const double room = plot.x - left - 20;
  const TextStyle faint{.size = kTick, .ink = kFaintText, .down = Down::middle};
  canvas.text(canvas.fitted(chart.rows_title, faint, room), {left, first}, faint);
  const PlaneMap map = map_to(plot, around.x_range, around.y_range);
  for (std::size_t i = 0; i < chart.rows.size(); ++i) {
    const double y = first + kNumberRow * static_cast<double>(i + 1);
    TextStyle style{.size = kTick, .down = Down::middle};
    canvas.text(canvas.fitted(chart.rows[i].name, style, room), {left, y}, style);
    style.across = Across::centre;
    for (const Tick& tick : chart.rows[i].numbers) {
      canvas.text(tick.text, {map.pixel({tick.at, 0}).x, y}, style);
    }
  }
}

double names_height(const LineChart& chart, const std::vector<Name>& names) {
  return rows_of(names) * (chart.naming == Naming::legend ? kLegendRow : kNameRow) + 6;
}

Rect plot_in(const Surroundings& around, const Rect& area, double head) {
  return {area.x + around.left, area.y + head, around.width,
          std::max(10.0, area.height - head - around.below - around.rows)};
}

}  // namespace

Interval place_plot(const Canvas& canvas, const LineChart& values, const Rect& area, double head,
                    Rect& plot) {
  const Surroundings around = surroundings(canvas, in_exponents(values), area.width);
  plot = plot_in(around, area, head);
  return around.x_range;
}

LineChart in_exponents(LineChart chart) {
  const auto convert = [&](Axis& axis, double Vector2::*coordinate) {
    if (!axis.logarithmic) return;
    for (auto* limit : {&axis.low, &axis.high}) {
      if (*limit) *limit = std::log10(**limit);
    }
    for (Series& series : chart.series) {
      for (Vector2& point : series.points) point.*coordinate = std::log10(point.*coordinate);
      if (coordinate != &Vector2::y) continue;
      for (Interval& interval : series.spread) {
        interval = {std::log10(interval.low), std::log10(interval.high)};
      }
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
  const Rect plot = plot_in(around, area, head);
  draw_axes(canvas, plot, chart.x, around.x_range, chart.y, around.y_range);
  draw_series(canvas, chart, map_to(plot, around.x_range, around.y_range), plot);
  if (!chart.rows.empty()) draw_rows(canvas, chart, around, plot, area.x);

  const TextStyle title{.size = kPanelTitle, .bold = true, .down = Down::top};
  const bool fits = canvas.text_width(chart.title, title) <= plot.width;
  canvas.text(canvas.fitted(chart.title, title, area.width), {fits ? plot.x : area.x, area.y},
              title);
  const double names_top = plot.y - names_height(chart, around.names);
  for (const Name& name : around.names) {
    const Ink colour = ink_of(chart, name.series);
    const double x = plot.x + name.x;
    if (chart.naming == Naming::legend) {
      const double y = names_top + kLegendRow * name.row + kLegendRow / 2;
      draw_swatch(canvas, chart, name.series, {x, y});
      canvas.text(name.text, {x + kSwatch + 6, y}, {.size = kTick, .down = Down::middle});
    } else {
      canvas.text(name.text, {x, plot.y - 7 - kNameRow * name.row},
                  {.size = kTick, .bold = true, .ink = readable(colour)});
    }
  }
}

}  // namespace elsie::picture
