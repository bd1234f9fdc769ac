// The axes around a plot.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "elsie/files/clean_text.h"

#include "panel.h"
#include "text.h"

namespace elsie::picture {

Interval interval_of(const Axis& axis, const Interval& otherwise) {
  Interval result{axis.low.value_or(otherwise.low), axis.high.value_or(otherwise.high)};
  if (result.low < result.high) return result;
  // Only one limit was given, and the data are beyond it.
  const double span = std::max(1.0, std::abs(result.low) * 0.1);
  if (axis.low) return {result.low, result.low + span};
  return {result.high - span, result.high};
}

PlaneMap map_to(const Rect& plot, const Interval& x, const Interval& y) {
  PlaneMap map;
  map.scale_x = plot.width / x.span();
  map.scale_y = -plot.height / y.span();
  map.origin_x = plot.x - map.scale_x * x.low;
  map.origin_y = plot.bottom() - map.scale_y * y.low;
  return map;
}

Ticks ticks_of(const Axis& axis, const Interval& range, double length, double room) {
  const auto about = [&](double every) { return std::max(2, static_cast<int>(length / every)); };
  if (!axis.names.empty()) {
    Ticks ticks;
    for (const Tick& name : axis.names) {
      ticks.at.push_back(name.at);
      ticks.names.push_back(name.text);
    }
    return ticks;
  }
  if (!axis.logarithmic) return nice_ticks(range.low, range.high, about(room));
  const int powers = static_cast<int>(range.span());
  Ticks ticks = nice_ticks(range.low, range.high, std::clamp(powers, 1, about(room / 2)));
  std::erase_if(ticks.at, [](double tick) { return tick != std::round(tick); });
  ticks.powers = true;
  return ticks;
}

double y_labels_width(const Canvas& canvas, const Axis& axis, const Interval& range,
                      double height) {
  const Ticks ticks = ticks_of(axis, range, height);
  double widest = 0.0;
  for (const double tick : ticks.at) {
    widest = std::max(widest, canvas.text_width(ticks.label(tick), {.size = kTick}));
  }
  return widest;
}

namespace {

// The room of a name on an x axis: the distance to its neighbour.
double room_of_name(const Axis& axis, const Interval& range, double width) {
  double nearest = range.span();
  for (std::size_t i = 1; i < axis.names.size(); ++i) {
    nearest = std::min(nearest, axis.names[i].at - axis.names[i - 1].at);
  }
  return width * nearest / range.span() - 6.0;
}

// A name in two rows, cut at the blank or after the underscore that is nearest to its middle.
std::pair<std::string, std::string> folded(const std::string& name) {
  std::size_t cut = std::string::npos;
  const auto off = [&](std::size_t at) {
    return std::abs(static_cast<double>(at) - 0.5 * static_cast<double>(name.size()));
  };
  for (std::size_t at = name.find_first_of(" _"); at != std::string::npos;
       at = name.find_first_of(" _", at + 1)) {
    if (cut == std::string::npos || off(at) < off(cut)) cut = at;
  }
  if (cut == std::string::npos) return {name, ""};
  return {name.substr(0, name[cut] == ' ' ? cut : cut + 1), name.substr(cut + 1)};
}

// A name in at most two rows of this width. What has no room is left out once: in the middle of the
// only row, or between both.
std::pair<std::string, std::string> rows_of(const Canvas& canvas, const std::string& name,
                                            const TextStyle& style, double room) {
  const auto fits = [&](const std::string& text) { return canvas.text_width(text, style) <= room; };
  if (fits(name)) return {name, ""};
  auto [first, second] = folded(name);
  if (second.empty()) return {canvas.fitted(first, style, room), ""};
  if (fits(first) && fits(second)) return {first, second};
  const std::string ellipsis(files::kEllipsis);
  first = canvas.fitted(first + ellipsis, style, room);
  second = canvas.fitted(ellipsis + second, style, room);
  if (second.starts_with(ellipsis)) second.erase(0, ellipsis.size());
  return {first, second};
}

void draw_names(Canvas& canvas, const Axis& axis, const PlaneMap& map, double y, double room) {
  const TextStyle style{.size = kTick, .across = Across::centre, .down = Down::top};
  for (const Tick& name : axis.names) {
    const double x = canvas.crisp(map.pixel({name.at, 0}).x);
    canvas.line({x, canvas.crisp(y)}, {x, canvas.crisp(y) + 4}).stroke(kFrame, {.width = 1});
    const auto [first, second] = rows_of(canvas, name.text, style, room);
    canvas.text(first, {x, y + 8}, style);
    canvas.text(second, {x, y + 8 + kFold}, style);
  }
}

}  // namespace

bool folds(const Canvas& canvas, const Axis& axis, const Interval& range, double width) {
  const double room = room_of_name(axis, range, width);
  return std::any_of(axis.names.begin(), axis.names.end(), [&](const Tick& name) {
    return canvas.text_width(name.text, {.size = kTick}) > room &&
           !folded(name.text).second.empty();
  });
}

void draw_x_ticks(Canvas& canvas, const Ticks& ticks, const PlaneMap& map, double y) {
  for (const double tick : ticks.at) {
    const double x = canvas.crisp(map.pixel({tick, 0}).x);
    canvas.line({x, canvas.crisp(y)}, {x, canvas.crisp(y) + 4}).stroke(kFrame, {.width = 1});
    canvas.text(ticks.label(tick), {x, y + 8},
                {.size = kTick, .across = Across::centre, .down = Down::top});
  }
}

double draw_y_ticks(Canvas& canvas, const Ticks& ticks, const PlaneMap& map, double x,
                    const Ink& ink) {
  const TextStyle style{.size = kTick, .ink = ink, .across = Across::right, .down = Down::middle};
  double widest = 0.0;
  for (const double tick : ticks.at) {
    const double y = canvas.crisp(map.pixel({0, tick}).y);
    canvas.line({canvas.crisp(x) - 4, y}, {canvas.crisp(x), y}).stroke(kFrame, {.width = 1});
    canvas.text(ticks.label(tick), {x - 8, y}, style);
    widest = std::max(widest, canvas.text_width(ticks.label(tick), style));
  }
  return widest;
}

void draw_axes(Canvas& canvas, const Rect& plot, const Axis& x, const Interval& x_range,
               const Axis& y, const Interval& y_range, bool grid) {
  const PlaneMap map = map_to(plot, x_range, y_range);
  const Ticks across = ticks_of(x, x_range, plot.width, 80.0);
  const Ticks up = ticks_of(y, y_range, plot.height);
  const double left = canvas.crisp(plot.x), bottom = canvas.crisp(plot.bottom());
  const auto x_of = [&](double tick) { return canvas.crisp(map.pixel({tick, 0}).x); };
  const auto y_of = [&](double tick) { return canvas.crisp(map.pixel({0, tick}).y); };
  if (grid) {
    for (const double tick : across.at) {
      canvas.line({x_of(tick), plot.y}, {x_of(tick), plot.bottom()});
    }
    for (const double tick : up.at) canvas.line({plot.x, y_of(tick)}, {plot.right(), y_of(tick)});
    canvas.stroke(kGrid, {.width = 1});
  }
  const bool fold = folds(canvas, x, x_range, plot.width);
  if (x.names.empty()) {
    draw_x_ticks(canvas, across, map, plot.bottom());
  } else {
    draw_names(canvas, x, map, plot.bottom(), room_of_name(x, x_range, plot.width));
  }
  const double widest = draw_y_ticks(canvas, up, map, plot.x, kText);
  canvas.move_to({left, plot.y}).line_to({left, bottom}).line_to({plot.right(), bottom});
  canvas.stroke(kFrame, {.width = 1});

  const TextStyle below{.size = kLabel, .across = Across::centre, .down = Down::top};
  canvas.text(canvas.fitted(with_unit(x.label, x.unit), below, plot.width),
              {plot.centre().x, plot.bottom() + 27 + (fold ? kFold : 0.0)}, below);
  const TextStyle beside{.size = kLabel, .across = Across::centre, .angle = -std::numbers::pi / 2};
  canvas.text(canvas.fitted(with_unit(y.label, y.unit), beside, plot.height),
              {plot.x - 16 - widest, plot.centre().y}, beside);
}

}  // namespace elsie::picture
