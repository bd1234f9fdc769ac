#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "elsie/picture/axis.h"

#include "text.h"
#include "timeline_parts.h"

namespace elsie::picture {
namespace {

constexpr double kLeastOfBand = 0.3;  // of a column's height, for each decider in it
constexpr double kIndent = 14.0;      // of a behaviour inside of another

Ticks time_ticks(const TimelineBlock& block) {
  return ticks_of({}, {block.span.from_s, block.span.to_s}, block.width(), 75.0);
}

void draw_frame(Canvas& canvas, const Rect& area) {
  const double left = canvas.crisp(area.x), top = canvas.crisp(area.y);
  const double right = canvas.crisp(area.right()), bottom = canvas.crisp(area.bottom());
  canvas.polygon(std::vector<Vector2>{{left, top}, {right, top}, {right, bottom}, {left, bottom}});
  canvas.stroke(kFrame.with_alpha(0.55), {.width = 0.8});
}

/// Numbers next to a panel, and their name.
void draw_scale(Canvas& canvas, const Rect& area, const Interval& range, const std::string& name) {
  const double widest = draw_y_ticks(canvas, ticks_of({}, range, area.height, 40.0),
                                     map_to(area, {0, 1}, range), area.x, kFaintText);
  TextStyle style = kBeside;
  style.ink = kText;
  canvas.text(name, {area.x - kBesidePlot - widest - 6, area.centre().y}, style);
}

/// The mean of a number over time, with its least and largest value as a band.
template <class Get>
void draw_extents(Canvas& canvas, const TimelineBlock& block, const PlaneMap& map, const Ink& ink,
                  const Pen& pen, Get get) {
  const auto y_of = [&](double value) { return map.pixel({0, value}).y; };
  std::vector<Vector2> line, band_above, band_below;
  bool varies = false;
  const auto draw = [&] {
    if (varies) {
      canvas.polyline(band_above);
      std::for_each(band_below.rbegin(), band_below.rend(),
                    [&](const Vector2& point) { canvas.line_to(point); });
      canvas.close().fill(ink.with_alpha(0.22));
    }
    canvas.polyline(line).stroke(ink, pen);
    line.clear(), band_above.clear(), band_below.clear();
    varies = false;
  };
  const auto extend = [](std::vector<Vector2>& points, double from, double to, double y) {
    // Constant parts need a point at each end only.
    if (points.size() >= 2 && points.back().y == y) {
      points.back().x = to;
      return;
    }
    points.push_back({from, y});
    points.push_back({to, y});
  };
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const Extent& extent = get(i);
    if (extent.time_s <= 0.0) {
      if (!line.empty()) draw();
      continue;
    }
    const double from = block.x_of_column(i), to = block.x_of_column(i + 1);
    varies = varies || extent.low < extent.high;
    extend(line, from, to, y_of(extent.mean));
    extend(band_above, from, to, y_of(extent.high));
    extend(band_below, from, to, y_of(extent.low));
  }
  if (!line.empty()) draw();
}

/// The area from the bottom of a panel up to a value in [0, 1] in each column.
template <class Get>
void fill_area(Canvas& canvas, const TimelineBlock& block, const Rect& area, const Ink& ink,
               Get get) {
  canvas.move_to({area.x, area.bottom()});
  double last = 0.0;
  const auto y_of = [&](double value) { return area.bottom() - area.height * value; };
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const double value = std::clamp(get(block.columns[i]), 0.0, 1.0);
    if (value == last) continue;
    canvas.line_to({block.x_of_column(i), y_of(last)});
    canvas.line_to({block.x_of_column(i), y_of(value)});
    last = value;
  }
  canvas.line_to({block.right(), y_of(last)}).line_to({block.right(), area.bottom()});
  canvas.close().fill(ink);
}

std::vector<std::size_t> outermost(const traces::TraceRobot& robot) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < robot.members.size(); ++i) {
    if (robot.members[i].parent < 0) members.push_back(i);
  }
  return members;
}

Interval weights_of(const TimelineBlock& block, const std::vector<std::size_t>& members) {
  Interval range{0.0, 1.0};
  for (const Column& column : block.columns) {
    for (const std::size_t i : members) {
      if (column.members[i].weight.time_s <= 0.0) continue;
      range.include(column.members[i].weight.low);
      range.include(column.members[i].weight.high);
    }
  }
  // Lines at the panel's border are drawn in full.
  const double margin = 0.06 * range.span();
  return {range.low < 0.0 ? range.low - margin : -margin, range.high + margin};
}

/// The times at which a user changed the priority of a behaviour in the run, and the new values.
void draw_changes(Canvas& canvas, const TimelineBlock& block, const Rect& area,
                  const std::vector<traces::PriorityFrom>& priorities) {
  const TextStyle style{.size = kTick, .bold = true, .down = Down::top};
  double taken = area.x;
  for (std::size_t i = 1; i < priorities.size(); ++i) {
    const double x = canvas.crisp(block.x_of(priorities[i].time_s));
    canvas.line({x, area.y}, {x, area.bottom()}).stroke(kText, {.width = 1.4});
    const std::string text = number_text(priorities[i].priority);
    const double width = canvas.text_width(text, style);
    const double left = x + 4 + width > area.right() ? x - 4 - width : x + 4;
    if (left < taken) continue;  // the number would overlap the one before
    canvas.text(text, {left, area.y + 3}, style);
    taken = left + width + 4;
  }
}

}  // namespace

void draw_time_grid(Canvas& canvas, const TimelineBlock& block, const Rect& area) {
  for (const double tick : time_ticks(block).at) {
    const double x = canvas.crisp(block.x_of(tick));
    canvas.line({x, area.y}, {x, area.bottom()}).stroke(kGrid, {.width = 1});
  }
}

void draw_time_axis(Canvas& canvas, const TimelineBlock& block, double y) {
  const Rect area{block.left, y, block.width(), 1.0};
  draw_x_ticks(canvas, time_ticks(block),
               map_to(area, {block.span.from_s, block.span.to_s}, {0, 1}), y);
  canvas.text("time (s)", {block.left - kBesidePlot - 14, y + 8},
              {.size = kTick, .across = Across::right, .down = Down::top});
}

void draw_deciders(Canvas& canvas, const TimelineBlock& block, const Rect& area) {
  std::size_t begun = 0;  // first of the equal columns
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const auto& here = block.columns[i].deciders;
    const bool same = i + 1 < block.columns.size() && here.size() == 1 &&
                      block.columns[i + 1].deciders.size() == 1 &&
                      here[0].decider == block.columns[i + 1].deciders[0].decider;
    if (same) continue;
    double y = area.y;
    const double x = block.x_of_column(begun), width = block.x_of_column(i + 1) - x;
    for (const DeciderTime& entry : heights_of(block.columns[i], kLeastOfBand)) {
      const double height = area.height * entry.part;
      canvas.rectangle({x, y, width, height});
      canvas.fill(block.inks.of_decider(block.robot, entry.decider));
      y += height;
    }
    begun = i + 1;
  }
  draw_frame(canvas, area);
  TextStyle style = kBeside;
  style.ink = kText;
  canvas.text("decides", {area.x - kBesidePlot, area.centre().y}, style);
}

void draw_shares(Canvas& canvas, const TimelineBlock& block, const Rect& area) {
  draw_time_grid(canvas, block, area);
  const std::vector<std::size_t> members = outermost(block.robot);
  // Each area reaches down to the bottom, the largest first, so that no paper shows between
  // neighbours.
  for (std::size_t shown = 0; shown < members.size(); ++shown) {
    fill_area(canvas, block, area, block.inks.of(block.robot, static_cast<int>(members[shown])),
              [&](const Column& column) {
                double sum = 0.0;
                for (std::size_t i = shown; i < members.size(); ++i) {
                  sum += column.members[members[i]].robot_share;
                }
                return sum;
              });
  }
  draw_frame(canvas, area);
  draw_scale(canvas, area, {0.0, 1.0}, "share");
}

void draw_weights(Canvas& canvas, const TimelineBlock& block, const Rect& area) {
  draw_time_grid(canvas, block, area);
  const std::vector<std::size_t> members = outermost(block.robot);
  const Interval range = weights_of(block, members);
  const PlaneMap map = map_to(area, {0, 1}, range);
  // Later lines are thinner, so that coinciding lines are all visible.
  for (std::size_t i = 0; i < members.size(); ++i) {
    const double thinner =
        members.size() > 1 ? static_cast<double>(i) / static_cast<double>(members.size() - 1) : 1.0;
    draw_extents(canvas, block, map, block.inks.of(block.robot, static_cast<int>(members[i])),
                 {.width = 3.6 - 2.2 * thinner}, [&](std::size_t column) -> const Extent& {
                   return block.columns[column].members[members[i]].weight;
                 });
  }
  draw_frame(canvas, area);
  draw_scale(canvas, area, range, "weight");
}

void draw_lane(Canvas& canvas, const TimelineBlock& block, std::size_t member, double mean_share,
               const Rect& area) {
  const traces::TraceMember& traced = block.robot.members[member];
  const Ink ink = block.inks.of(block.robot, static_cast<int>(member));
  draw_time_grid(canvas, block, area);
  fill_area(canvas, block, area, ink.with_alpha(kLaneAlpha),
            [&](const Column& column) { return column.members[member].robot_share; });
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const double part = block.columns[i].members[member].inhibited;
    if (part <= 0.0) continue;
    const double height = area.height * std::clamp(part, kLeastOfBand, 1.0);
    canvas.rectangle({block.x_of_column(i), area.y, block.column_width, height});
  }
  hatch(canvas, area);
  // Inside of the frame, so that an activation of 1 or 0 differs from it.
  const Rect inner{area.x, area.y + 2, area.width, area.height - 4};
  draw_extents(canvas, block, map_to(inner, {0, 1}, {0, 1}), kText, {.width = 1.3},
               [&](std::size_t column) -> const Extent& {
                 return block.columns[column].members[member].activation;
               });
  draw_frame(canvas, area);

  const double beside = area.x - kBesidePlot;
  TextStyle number = kBeside;
  number.ink = kText;
  const auto priorities = traces::priorities(block.robot, traced, block.span);
  draw_changes(canvas, block, area, priorities);
  const std::string priority = number_text(priorities.front().priority);
  canvas.text(priority, {beside, area.centre().y}, number);
  const double taken = canvas.text_width(priority, number) + kNameToPriority;

  const std::string name = traced.path.substr(traced.path.rfind('/') + 1);
  const double indent = 18.0 + kIndent * traced.depth;
  const TextStyle style{.size = kLabel, .bold = traced.depth == 0, .down = Down::middle};
  canvas.rectangle({indent, area.centre().y - 5, 10, 10}).fill(ink);
  canvas.text(canvas.fitted(name, style, beside - taken - indent - 16),
              {indent + 16, area.centre().y}, style);
  canvas.text(tick_label(100.0 * mean_share, 1.0) + " %", {area.right() + 8, area.centre().y},
              {.size = kTick, .down = Down::middle});
}

std::string name_of(const traces::TraceNumber& number) {
  const std::string unit = number.unit.empty() ? "" : " (" + number.unit + ")";
  return number.path.substr(number.path.rfind('/') + 1) + "." + number.name + unit;
}

void draw_number(Canvas& canvas, const TimelineBlock& block, const traces::TraceNumber& number,
                 const Rect& area) {
  const std::vector<Extent> columns = columns_of(number, block.span, block.columns.size());
  draw_time_grid(canvas, block, area);
  std::optional<Interval> seen;
  for (const Extent& extent : columns) {
    if (extent.time_s <= 0.0) continue;
    if (!seen) seen = {extent.low, extent.low};
    seen->include(extent.low);
    seen->include(extent.high);
  }
  if (seen) {
    const double margin = seen->span() > 0.0 ? 0.06 * seen->span() : 0.5;
    const Interval range{seen->low - margin, seen->high + margin};
    draw_extents(canvas, block, map_to(area, {0, 1}, range), kText, {.width = 1.3},
                 [&](std::size_t column) -> const Extent& { return columns[column]; });
    TextStyle beside{.size = kTick, .ink = kFaintText, .down = Down::top};
    canvas.text(tick_label(seen->high, 0.05 * range.span()), {area.right() + 8, area.y}, beside);
    beside.down = Down::baseline;
    canvas.text(tick_label(seen->low, 0.05 * range.span()), {area.right() + 8, area.bottom()},
                beside);
  }
  draw_frame(canvas, area);
  const TextStyle style{.size = kTick, .down = Down::middle};
  canvas.text(canvas.fitted(name_of(number), style, area.x - kBesidePlot - 18.0),
              {18.0, area.centre().y}, style);
}

void draw_lane_head(Canvas& canvas, const TimelineBlock& block, double y) {
  TextStyle style = kBeside;
  style.down = Down::baseline;
  canvas.text("user priority", {block.left - kBesidePlot, y}, style);
}

}  // namespace elsie::picture
