// The curves of a line chart.
#include <algorithm>
#include <cmath>

#include "elsie/picture/polyline.h"

#include "panel.h"

namespace elsie::picture {
namespace {

constexpr double kMark = 3.4;    // half of a mark's width
constexpr double kStroke = 4.0;  // half of the height of an upright stroke

bool is_neutral(const Series& series) { return series.colour == kNeutral; }

// The place of a neutral series among the neutral ones.
std::size_t neutral_place(const LineChart& chart, std::size_t index) {
  const auto begin = chart.series.begin();
  return static_cast<std::size_t>(
      std::count_if(begin, begin + static_cast<std::ptrdiff_t>(index), is_neutral));
}

// After all colours, they repeat with dashed and then dotted lines. On a screen, each curve has
// dashes other than the one before it.
Pen pen_of(const Canvas& canvas, const LineChart& chart, std::size_t index) {
  if (chart.naming == Naming::in_titles) return {.width = 1.2, .dash = {}, .round = true};
  Pen pen{.width = 2.0, .dash = {}, .round = true};
  const Series& series = chart.series[index];
  const std::size_t colour = series.colour.value_or(index);
  const std::size_t round = is_neutral(series)   ? neutral_place(chart, index)
                            : canvas.on_screen() ? colour
                                                 : colour / kSeriesInks;
  if (round % 4 == 1) pen.dash = {7, 5};
  if (round % 4 == 2) pen.dash = {1, 4.5};
  if (round % 4 == 3) pen.dash = {9, 4, 1, 4};
  return pen;
}

// The parts of a curve, in units of the drawing.
std::vector<std::vector<Vector2>> parts(const Series& series, const PlaneMap& map, double zoom) {
  std::vector<Vector2> points;
  for (const Vector2& point : series.points) {
    const Vector2 next = map.pixel(point);
    if (series.joining == Joining::steps && !points.empty() && finite(points.back())) {
      points.push_back({next.x, points.back().y});
    }
    points.push_back(next);
  }
  std::vector<std::vector<Vector2>> result = pieces(points);
  for (auto& piece : result) piece = simplified(piece, 0.4 / zoom);
  return result;
}

void tint_below(Canvas& canvas, const LineChart& chart, std::size_t index, const PlaneMap& map,
                double base) {
  for (const auto& piece : parts(chart.series[index], map, canvas.zoom())) {
    if (piece.size() < 2) continue;
    canvas.polyline(piece).line_to({piece.back().x, base}).line_to({piece.front().x, base});
    canvas.close().fill(ink_of(chart, index).with_alpha(0.13));
  }
}

// A band between the ends of all intervals.
void draw_band(Canvas& canvas, const LineChart& chart, std::size_t index, const PlaneMap& map) {
  const Series& series = chart.series[index];
  Series low{.name = {}, .points = {}, .joining = series.joining}, high = low;
  const auto finish = [&] {
    auto under = parts(low, map, canvas.zoom()), over = parts(high, map, canvas.zoom());
    if (under.size() == 1 && over.size() == 1 && under.front().size() > 1) {
      std::reverse(over.front().begin(), over.front().end());
      under.front().insert(under.front().end(), over.front().begin(), over.front().end());
      canvas.polygon(under.front()).fill(ink_of(chart, index).with_alpha(0.15));
    }
    low.points.clear();
    high.points.clear();
  };
  for (std::size_t i = 0; i < std::min(series.points.size(), series.spread.size()); ++i) {
    const Interval& around = series.spread[i];
    if (!std::isfinite(around.low) || !std::isfinite(around.high)) {
      finish();
      continue;
    }
    low.points.push_back({series.points[i].x, around.low});
    high.points.push_back({series.points[i].x, around.high});
  }
  finish();
}

void draw_bars(Canvas& canvas, const LineChart& chart, std::size_t index, const PlaneMap& map,
               const Rect& plot) {
  constexpr double kArrow = 4.0;
  const Series& series = chart.series[index];
  for (std::size_t i = 0; i < std::min(series.points.size(), series.spread.size()); ++i) {
    const double x = series.points[i].x;
    const Interval& around = series.spread[i];
    if (!std::isfinite(around.low) || !(around.high >= around.low)) continue;
    const Vector2 foot = map.pixel({x, around.low});
    if (std::isfinite(around.high)) {
      canvas.line(foot, map.pixel({x, around.high}));
    } else {
      canvas.line(foot, {foot.x, plot.y});
      canvas.line({foot.x, plot.y}, {foot.x - kArrow, plot.y + 1.5 * kArrow});
      canvas.line({foot.x, plot.y}, {foot.x + kArrow, plot.y + 1.5 * kArrow});
    }
    canvas.stroke(ink_of(chart, index).with_alpha(0.6), {.width = 1.4});
  }
}

// Circle, square, triangle, diamond.
void draw_mark(Canvas& canvas, const Vector2& at, std::size_t shape, const Ink& ink) {
  if (!finite(at)) return;
  const double r = kMark;
  switch (shape % 4) {
    case 0:
      canvas.circle(at, r);
      break;
    case 1:
      canvas.rectangle({at.x - 0.9 * r, at.y - 0.9 * r, 1.8 * r, 1.8 * r});
      break;
    case 2:
      canvas.polygon(std::vector<Vector2>{{at.x, at.y - 1.2 * r},
                                          {at.x + 1.15 * r, at.y + 0.9 * r},
                                          {at.x - 1.15 * r, at.y + 0.9 * r}});
      break;
    default:
      canvas.polygon(std::vector<Vector2>{{at.x, at.y - 1.3 * r},
                                          {at.x + 1.3 * r, at.y},
                                          {at.x, at.y + 1.3 * r},
                                          {at.x - 1.3 * r, at.y}});
  }
  canvas.fill_keep(ink);
  canvas.stroke(kPaper, {.width = 1.0});
}

}  // namespace

Ink ink_of(const LineChart& chart, std::size_t index) {
  const Series& series = chart.series[index];
  if (chart.naming == Naming::in_titles) {
    Ink ink = series_ink(0).with_alpha(0.5);
    ink.role = "c";
    return ink;
  }
  // Shades from dark to light.
  if (is_neutral(series)) {
    const auto place = static_cast<double>(neutral_place(chart, index));
    return kText.with_alpha(std::max(0.35, 1.0 - 0.2 * place));
  }
  return series_ink(series.colour.value_or(index));
}

void draw_swatch(Canvas& canvas, const LineChart& chart, std::size_t index, const Vector2& from) {
  const Series& series = chart.series[index];
  if (series.joining != Joining::nothing) {
    canvas.line(from, {from.x + kSwatch, from.y})
        .stroke(ink_of(chart, index), pen_of(canvas, chart, index));
  }
  if (series.marked) {
    draw_mark(canvas, {from.x + kSwatch / 2, from.y}, index, ink_of(chart, index));
  }
}

void draw_series(Canvas& canvas, const LineChart& chart, const PlaneMap& map, const Rect& plot) {
  canvas.rectangle({plot.x - 4, plot.y - 4, plot.width + 8, plot.height + 8});
  const Clip clip(canvas);
  const double zero = chart.y.logarithmic ? plot.bottom() : map.pixel({0, 0}).y;
  const double base = std::clamp(zero, plot.y, plot.bottom());
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    if (chart.series[i].filled) tint_below(canvas, chart, i, map, base);
    if (!chart.series[i].bars) draw_band(canvas, chart, i, map);
  }
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    canvas.open_mark(series.name);
    if (series.bars) draw_bars(canvas, chart, i, map, plot);
    if (series.joining != Joining::nothing) {
      for (const auto& piece : parts(series, map, canvas.zoom())) {
        if (piece.size() > 1) {
          canvas.polyline(piece).stroke(ink_of(chart, i), pen_of(canvas, chart, i));
        } else if (!series.marked) {
          canvas.circle(piece.front(), 2.5).fill(ink_of(chart, i));
        }
      }
    }
    for (const Vector2& point : series.strokes) {
      const Vector2 at = map.pixel(point);
      canvas.line({at.x, at.y - kStroke}, {at.x, at.y + kStroke});
    }
    if (!series.strokes.empty()) canvas.stroke(ink_of(chart, i), {.width = 1.2});
    if (series.marked) {
      for (const Vector2& point : series.points) {
        draw_mark(canvas, map.pixel(point), i, ink_of(chart, i));
      }
    }
    canvas.close_mark();
  }
}

}  // namespace elsie::picture
