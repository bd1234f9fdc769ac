// Things below each other over one axis: box plots, intervals, bars.
#include <algorithm>
#include <cmath>

#include "panel.h"
#include "text.h"

namespace elsie::picture {
namespace {

constexpr double kKeyRow = 20.0;
constexpr double kHalfBox = 7.0;
constexpr double kMostOfName = 0.34;  // of the width

struct KeyEntry {
  std::string text;
  std::size_t colour = 0;
  double x = 0.0;
  int row = 0;
};

std::vector<KeyEntry> key(const Canvas& canvas, const RowChart& chart, double width) {
  std::vector<KeyEntry> entries;
  Flow flow(width, 18.0);
  for (const auto& [name, colour] : chart.key) {
    const std::string text = canvas.fitted(name, {.size = kTick}, width - 20);
    const double x = flow.place(18 + canvas.text_width(text, {.size = kTick}));
    entries.push_back({text, colour, x, flow.row()});
  }
  return entries;
}

double names_width(const Canvas& canvas, const RowChart& chart, double width) {
  double widest = 0.0;
  for (const ChartRow& row : chart.rows) {
    widest = std::max(widest, canvas.text_width(row.name, {.size = kTick}));
  }
  return std::min(widest, kMostOfName * width) + 14;
}

Interval range_of(const RowChart& chart) {
  Interval range;
  for (const ChartRow& row : chart.rows) {
    for (const double dot : row.dots) range.include(dot);
    for (const double cross : row.crosses) range.include(cross);
    if (row.mark) range.include(*row.mark);
    for (const Interval& part :
         {row.interval.value_or(Interval{}), row.box ? row.box->whiskers : Interval{}}) {
      range.include(part.low);
      range.include(part.high);
    }
    for (const RowBar& bar : row.bars) {
      range.include(bar.from_to.low);
      range.include(bar.from_to.high);
    }
  }
  const Interval wide = range.widened();
  const double extra = range.empty() ? 0.0 : 0.03 * wide.span();
  return interval_of(chart.x, {wide.low - extra, wide.high + extra});
}

// The offset of the i-th dot from the middle, in [-1, 1].
double scattered(std::size_t i) {
  return std::fmod(0.5 + 0.61803398875 * static_cast<double>(i), 1.0) * 2.0 - 1.0;
}

void draw_row(Canvas& canvas, const ChartRow& row, const PlaneMap& map, double middle,
              double height) {
  const Ink ink = series_ink(row.colour);
  const auto x_of = [&](double value) { return map.pixel({value, 0}).x; };
  for (const RowBar& bar : row.bars) {
    const double from = x_of(bar.from_to.low), to = x_of(bar.from_to.high);
    canvas.rectangle({from, middle - 0.32 * height, to - from, 0.64 * height});
    canvas.fill(series_ink(bar.colour));
  }
  if (row.box) {
    canvas.line({x_of(row.box->whiskers.low), middle}, {x_of(row.box->whiskers.high), middle});
    canvas.stroke(ink.with_alpha(0.8), {.width = 1.2});
    const double from = x_of(row.box->quartiles.low), to = x_of(row.box->quartiles.high);
    const Rect box{from, middle - kHalfBox, to - from, 2 * kHalfBox};
    canvas.rectangle(box).fill(mix(kPaper, ink, 0.16));
    canvas.rectangle(box).stroke(ink.with_alpha(0.8), {.width = 1.2});
    const double at = x_of(row.box->median);
    canvas.line({at, middle - kHalfBox}, {at, middle + kHalfBox}).stroke(ink, {.width = 2.5});
  }
  for (std::size_t i = 0; i < row.dots.size(); ++i) {
    canvas.circle({x_of(row.dots[i]), middle + 5.0 * scattered(i)}, 2.1).fill(ink.with_alpha(0.6));
  }
  for (std::size_t i = 0; i < row.crosses.size(); ++i) {
    const Vector2 at{x_of(row.crosses[i]), middle + 5.0 * scattered(i)};
    canvas.line({at.x - 3, at.y - 3}, {at.x + 3, at.y + 3});
    canvas.line({at.x - 3, at.y + 3}, {at.x + 3, at.y - 3});
    canvas.stroke(hex(0xbb1414, "bad"), {.width = 1.5});
  }
  const double below = row.box ? middle + kHalfBox + 4 : middle;
  if (row.interval) {
    canvas.line({x_of(row.interval->low), below}, {x_of(row.interval->high), below});
    canvas.stroke(row.box ? kText : ink.with_alpha(0.6), {.width = row.box ? 1.4 : 3.0});
  }
  if (row.mark) {
    const double x = x_of(*row.mark), r = row.box ? 3.6 : 4.6;
    canvas.polygon(
        std::vector<Vector2>{{x, below - r}, {x + r, below}, {x, below + r}, {x - r, below}});
    canvas.fill_keep(row.box ? kText : ink);
    canvas.stroke(kPaper, {.width = 0.8});
  }
}

}  // namespace

double head_height(const Canvas& canvas, const RowChart& chart, double width) {
  int rows = 0;
  for (const KeyEntry& entry : key(canvas, chart, width)) rows = std::max(rows, entry.row + 1);
  return (chart.title.empty() ? 0.0 : kPanelTitle + 10) + kKeyRow * rows + 6;
}

void draw(Canvas& canvas, const RowChart& chart, const Rect& area, double head) {
  const double left = names_width(canvas, chart, area.width);
  const Rect plot{area.x + left, area.y + head, std::max(10.0, area.width - left - 10),
                  std::max(10.0, area.height - head - 44)};
  const auto count = static_cast<double>(std::max<std::size_t>(chart.rows.size(), 1));
  const Interval x_range = range_of(chart), y_range{0.0, count};
  Axis y;
  for (std::size_t i = chart.rows.size(); i-- > 0;) {
    y.names.push_back({count - 0.5 - static_cast<double>(i),
                       canvas.fitted(chart.rows[i].name, {.size = kTick}, left - 12)});
  }
  draw_axes(canvas, plot, chart.x, x_range, y, y_range);
  const PlaneMap map = map_to(plot, x_range, y_range);
  for (std::size_t i = 0; i < chart.rows.size(); ++i) {
    const double middle = plot.y + plot.height * (static_cast<double>(i) + 0.5) / count;
    draw_row(canvas, chart.rows[i], map, middle, plot.height / count);
  }
  const TextStyle title{.size = kPanelTitle, .bold = true, .down = Down::top};
  canvas.text(canvas.fitted(chart.title, title, area.width), {area.x, area.y}, title);
  const double top = area.y + (chart.title.empty() ? 0.0 : kPanelTitle + 10);
  for (const KeyEntry& entry : key(canvas, chart, area.width)) {
    const double y_of = top + kKeyRow * entry.row + kKeyRow / 2;
    canvas.rectangle({area.x + entry.x, y_of - 6, 12, 12}).fill(series_ink(entry.colour));
    canvas.text(entry.text, {area.x + entry.x + 18, y_of}, {.size = kTick, .down = Down::middle});
  }
}

}  // namespace elsie::picture
