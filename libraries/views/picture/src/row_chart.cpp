// Things below each other over one axis: box plots, intervals, bars.
#include <algorithm>
#include <cmath>
#include <map>

#include "panel.h"
#include "text.h"

namespace elsie::picture {
namespace {

constexpr double kKeyRow = 20.0;
constexpr double kHalfBox = 7.0;
constexpr double kMostOfName = 0.42;  // of the width; with longer names, all are above their rows
constexpr double kNameAbove = 15.0;
constexpr double kBelow = 44.0;     // the axis
constexpr double kInSight = 400.0;  // taller charts have the numbers of the axis above, too

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

// The margins around the rows, and the height of a row.
struct Plan {
  bool names_above = false, numbers_above = false;
  double left = 10.0, right = 10.0, row = 0.0;
};

Plan plan_of(const Canvas& canvas, const RowChart& chart, double width) {
  Plan plan;
  const double bars = std::clamp(280.0 / static_cast<double>(chart.rows.size() + 1), 14.0, 30.0);
  double name = 0.0, note = 0.0;
  for (const ChartRow& row : chart.rows) {
    name = std::max(name, canvas.text_width(row.name, {.size = kTick}));
    note = std::max(note, canvas.text_width(row.note, {.size = kTick}));
    const double least = row.box || !row.dots.empty() ? 32.0 : row.bars.empty() ? 22.0 : bars;
    plan.row = std::max(plan.row, least);
  }
  plan.names_above = name > kMostOfName * width;
  if (plan.names_above) plan.row += kNameAbove;
  if (!plan.names_above) plan.left = name + 14.0;
  plan.numbers_above = plan.row * static_cast<double>(chart.rows.size()) > kInSight;
  if (note > 0.0) plan.right = std::min(note, kMostOfName * width) + 14.0;
  return plan;
}

Interval range_of(const RowChart& chart) {
  Interval range;
  for (const ChartRow& row : chart.rows) {
    for (const RowDot& dot : row.dots) range.include(dot.at);
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

void draw_dot(Canvas& canvas, const RowDot& dot, const Vector2& at, const Ink& ink) {
  const Ink bad = hex(0xbb1414, "bad");
  if (!dot.title.empty()) canvas.open_mark(dot.title);
  if (dot.crossed) {
    canvas.line({at.x - 3, at.y - 3}, {at.x + 3, at.y + 3});
    canvas.line({at.x - 3, at.y + 3}, {at.x + 3, at.y - 3}).stroke(bad, {.width = 1.5});
  } else {
    canvas.dot(at, 2.1, ink.with_alpha(0.6));
  }
  if (dot.ringed) {
    canvas.circle(at, dot.crossed ? 5.5 : 3.2).stroke(dot.crossed ? bad : kText, {.width = 1.2});
  }
  if (!dot.title.empty()) canvas.close_mark();
}

void draw_row(Canvas& canvas, const ChartRow& row, const PlaneMap& map, double middle) {
  const Ink ink = series_ink(row.colour);
  const auto x_of = [&](double value) { return map.pixel({value, 0}).x; };
  if (row.box) {
    canvas.line({x_of(row.box->whiskers.low), middle}, {x_of(row.box->whiskers.high), middle});
    canvas.stroke(ink.with_alpha(0.8), {.width = 1.2});
    const double from = x_of(row.box->quartiles.low), to = x_of(row.box->quartiles.high);
    canvas.rectangle({from, middle - kHalfBox, to - from, 2 * kHalfBox}).fill_keep(kPaper);
    canvas.fill_keep(ink.with_alpha(0.16));
    canvas.stroke(ink.with_alpha(0.8), {.width = 1.2});
    const double at = x_of(row.box->median);
    canvas.line({at, middle - kHalfBox}, {at, middle + kHalfBox}).stroke(ink, {.width = 2.5});
  }
  for (std::size_t i = 0; i < row.dots.size(); ++i) {
    draw_dot(canvas, row.dots[i], {x_of(row.dots[i].at), middle + 5.0 * scattered(i)}, ink);
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

// The bars of all rows, those of a colour as one mark.
void draw_bars(Canvas& canvas, const RowChart& chart, const PlaneMap& map, double height,
               const auto& middle_of) {
  std::map<std::size_t, std::vector<Rect>> colours;
  for (std::size_t i = 0; i < chart.rows.size(); ++i) {
    for (const RowBar& bar : chart.rows[i].bars) {
      const auto y_of = [&](double part) {  // whole: parts of a bar leave no gaps
        return std::round(middle_of(i) + height * (0.5 - part));
      };
      const double from = map.pixel({bar.from_to.low, 0}).x, top = y_of(bar.height.high);
      colours[bar.colour].push_back(
          {from, top, map.pixel({bar.from_to.high, 0}).x - from, y_of(bar.height.low) - top});
    }
  }
  for (const auto& [colour, bars] : colours) {
    std::string names;
    for (const auto& [name, of] : chart.key) {
      if (of == colour) names += (names.empty() ? "" : ", ") + name;
    }
    if (!names.empty()) canvas.open_mark(names);
    for (const Rect& bar : bars) {
      if (bar.height > 0.0) canvas.rectangle(bar);
    }
    canvas.fill(series_ink(colour));
    if (!names.empty()) canvas.close_mark();
  }
}

}  // namespace

double head_height(const Canvas& canvas, const RowChart& chart, double width) {
  int rows = 0;
  for (const KeyEntry& entry : key(canvas, chart, width)) rows = std::max(rows, entry.row + 1);
  return (chart.title.empty() ? 0.0 : kPanelTitle + 10) + kKeyRow * rows + 6 +
         (plan_of(canvas, chart, width).numbers_above ? kTick + 6 : 0.0);
}

double natural_height(const Canvas& canvas, const RowChart& chart, double width) {
  return 6.0 + kBelow + plan_of(canvas, chart, width).row * static_cast<double>(chart.rows.size());
}

void draw(Canvas& canvas, const RowChart& chart, const Rect& area, double head) {
  const Plan plan = plan_of(canvas, chart, area.width);
  const Rect plot{area.x + plan.left, area.y + head,
                  std::max(10.0, area.width - plan.left - plan.right),
                  std::max(10.0, area.height - head - kBelow)};
  const auto count = static_cast<double>(std::max<std::size_t>(chart.rows.size(), 1));
  const double height = plot.height / count, name = plan.names_above ? kNameAbove : 0.0;
  const Interval x_range = range_of(chart), y_range{0.0, count};
  const PlaneMap map = map_to(plot, x_range, y_range);
  const auto middle_of = [&](std::size_t i) {
    return plot.y + height * static_cast<double>(i) + (height + name) / 2;
  };
  Axis y{.names = {{0.0, ""}}};  // no numbers
  for (std::size_t i = chart.rows.size(); !plan.names_above && i-- > 0;) {
    y.names.push_back({map.point({0, middle_of(i)}).y, chart.rows[i].name});
  }
  draw_axes(canvas, plot, chart.x, x_range, y, y_range);
  if (plan.numbers_above) {
    const Ticks ticks = ticks_of(chart.x, x_range, plot.width, 80.0);
    for (const double tick : ticks.at) {
      canvas.text(ticks.label(tick), {map.pixel({tick, 0}).x, plot.y - 6},
                  {.size = kTick, .across = Across::centre});
    }
  }
  draw_bars(canvas, chart, map, 0.76 * (height - name), middle_of);
  for (std::size_t i = 0; i < chart.rows.size(); ++i) {
    const ChartRow& row = chart.rows[i];
    draw_row(canvas, row, map, middle_of(i));
    const TextStyle style{.size = kTick, .down = Down::middle};
    const double note = plan.right - 14.0;
    canvas.text(canvas.fitted(row.note, style, note), {plot.right() + 10, middle_of(i)}, style);
    if (!plan.names_above) continue;
    const double y_of = middle_of(i) - height / 2;
    canvas.text(canvas.fitted(row.name, style, plot.width), {plot.x + 4, y_of}, style);
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
