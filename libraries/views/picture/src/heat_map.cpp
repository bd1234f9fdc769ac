#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "isoband.h"
#include "panel.h"
#include "text.h"

namespace elsie::picture {
namespace {

constexpr int kShades = 36;

void draw_field(Canvas& canvas, const Field& field, const Interval& range, const Rect& plot) {
  const Grid grid{field.columns, field.rows, field.values};
  const double cell_x = plot.width / static_cast<double>(field.columns - 1);
  const double cell_y = plot.height / static_cast<double>(field.rows - 1);
  const auto place = [&](const Vector2& p) {
    return Vector2{plot.x + cell_x * p.x, plot.bottom() - cell_y * p.y};
  };
  // From the lowest shade upwards, each over the ones below, without gaps.
  for (int shade = 0; shade < kShades; ++shade) {
    const double level = shade == 0 ? -std::numeric_limits<double>::max()
                                    : range.low + range.span() * shade / kShades;
    for (auto& polygon : region_above(grid, level)) {
      std::transform(polygon.begin(), polygon.end(), polygon.begin(), place);
      canvas.polygon(polygon);
    }
    canvas.fill(viridis((shade + 0.5) / kShades));
  }
  const Ticks levels = nice_ticks(range.low, range.high, 8);
  for (const double level : levels.at) {
    // Slightly above the level, so that a plateau at the level has one smooth border.
    for (const auto& [from, to] : contour(grid, level + 1e-6 * range.span())) {
      canvas.line(place(from), place(to));
    }
    const bool dark = range.part(level) < 0.65;
    canvas.stroke((dark ? kPaper : kText).with_alpha(0.65),
                  {.width = 1, .dash = {}, .round = true});
  }
}

}  // namespace

// Grey with hatching.
void draw_unknown(Canvas& canvas, const Rect& area) {
  canvas.rectangle(area).fill(hex(0xf0f1f2, "panel"));
  hatch(canvas.rectangle(area), area, 8.0, hex(0xd5d8db, "line"));
}

void draw_colour_bar(Canvas& canvas, const Axis& axis, const Interval& range, const Rect& bar) {
  for (int shade = 0; shade < kShades; ++shade) {
    // Each reaches down to the bottom; the next one covers it up to its own part.
    const double height = bar.height * (kShades - shade) / kShades;
    canvas.rectangle({bar.x, bar.y, bar.width, height}).fill(viridis((shade + 0.5) / kShades));
  }
  const Ticks ticks = nice_ticks(range.low, range.high, 8);
  double widest = 0.0;
  for (const double tick : ticks.at) {
    const double y = canvas.crisp(bar.bottom() - bar.height * range.part(tick));
    canvas.line({bar.right(), y}, {bar.right() + 4, y}).stroke(kFrame, {.width = 1});
    const TextStyle style{.size = kTick, .down = Down::middle};
    const std::string label = ticks.label(tick);
    widest = std::max(widest, canvas.text_width(label, style));
    canvas.text(label, {bar.right() + 8, y}, style);
  }
  const TextStyle beside{.size = kLabel, .across = Across::centre, .angle = -std::numbers::pi / 2};
  canvas.text(canvas.fitted(with_unit(axis.label, axis.unit), beside, bar.height),
              {bar.right() + 8 + widest + 18, bar.centre().y}, beside);
}

void draw(Canvas& canvas, const HeatMap& map, const Rect& area, double head) {
  const Field& field = map.field;
  const Interval x_range{*field.x.low, *field.x.high};
  const Interval y_range{*field.y.low, *field.y.high};
  const Interval z_range = interval_of(field);

  constexpr double kBar = 16.0, kBarGap = 14.0;
  const double left = y_labels_width(canvas, field.y, y_range, area.height) + 32;
  const double right = kBarGap + kBar + 8 + y_labels_width(canvas, field.z, z_range, 8 * 45) + 24;
  const Rect plot{area.x + left, area.y + head, std::max(10.0, area.width - left - right),
                  std::max(10.0, area.height - head - 44)};

  draw_unknown(canvas, plot);
  draw_field(canvas, field, z_range, plot);
  draw_axes(canvas, plot, field.x, x_range, field.y, y_range, false);
  if (map.mark) {
    const Vector2 at = map_to(plot, x_range, y_range).pixel(*map.mark);
    canvas.circle({std::clamp(at.x, plot.x, plot.right()), std::clamp(at.y, plot.y, plot.bottom())},
                  5.0);
    canvas.fill_keep(hex(0x000000));
    canvas.stroke(hex(0xffffff), {.width = 2.5});
  }
  draw_colour_bar(canvas, field.z, z_range, {plot.right() + kBarGap, plot.y, kBar, plot.height});
  const TextStyle title{.size = kPanelTitle, .bold = true, .down = Down::top};
  canvas.text(canvas.fitted(map.title, title, area.width - left), {plot.x, area.y}, title);
}

}  // namespace elsie::picture
