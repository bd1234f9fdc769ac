#include <algorithm>
#include <cmath>
#include <numbers>

#include "timeline_parts.h"

namespace elsie::picture {
namespace {

constexpr std::size_t kMostLines = 80;  // more would hide the panels

std::vector<Vector2> corners(const Vector2& at, int count, double radius, double first_angle) {
  std::vector<Vector2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = first_angle + 2.0 * std::numbers::pi * i / count;
    points.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
  }
  return points;
}

/// Adds the nth shape to the path; they repeat after five.
void trace_shape(Canvas& canvas, std::size_t place, const Vector2& at) {
  constexpr double kUp = -std::numbers::pi / 2, kRadius = 5.2;
  switch (place % 5) {
    case 0:
      canvas.polygon(corners(at, 3, kRadius + 0.8, kUp));
      break;
    case 1:
      canvas.circle(at, kRadius - 0.8);
      break;
    case 2:
      canvas.polygon(corners(at, 4, kRadius, kUp));
      break;
    case 3:
      canvas.polygon(corners(at, 4, kRadius, kUp / 2));
      break;
    default:
      canvas.polygon(corners(at, 3, kRadius + 0.8, -kUp));
      break;
  }
}

}  // namespace

EventSymbols::EventSymbols(const traces::Trace& trace, const std::vector<std::size_t>& robots,
                           const traces::TimeSpan& span) {
  for (const std::size_t r : robots) {
    for (const EventKind& kind : event_kinds(trace.robots[r], span)) {
      if (std::find(names_.begin(), names_.end(), kind.name) == names_.end()) {
        names_.push_back(kind.name);
      }
    }
  }
}

std::size_t EventSymbols::place_of(const std::string& name) const {
  return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
}

void EventSymbols::draw(Canvas& canvas, const std::string& name, const Vector2& at) const {
  const std::size_t place = place_of(name);
  trace_shape(canvas, place, at);
  // After all shapes, they repeat hollow.
  canvas.fill_keep(place / 5 % 2 == 0 ? kText : kPaper);
  canvas.stroke(kText, {.width = 1.2});
}

void EventSymbols::draw_rim(Canvas& canvas, const std::string& name, const Vector2& at) const {
  trace_shape(canvas, place_of(name), at);
  canvas.stroke(kPaper, {.width = 4.0});
}

std::vector<EventKind> event_kinds(const traces::TraceRobot& robot, const traces::TimeSpan& span) {
  std::vector<EventKind> kinds;
  for (const traces::TraceEvent& event : robot.events) {
    if (event.time_s < span.from_s || event.time_s > span.to_s) continue;
    auto kind = std::find_if(kinds.begin(), kinds.end(),
                             [&](const EventKind& known) { return known.name == event.name; });
    if (kind == kinds.end()) kind = kinds.insert(kinds.end(), {event.name, {}});
    kind->times_s.push_back(event.time_s);
  }
  return kinds;
}

void draw_events(Canvas& canvas, const TimelineBlock& block, const std::vector<EventKind>& kinds,
                 const EventSymbols& symbols, bool in_rows, double y, double row, double bottom) {
  if (kinds.empty()) return;
  struct Placed {
    const EventKind* kind;
    double y;
  };
  std::vector<Placed> rarest_first;
  for (const EventKind& kind : kinds) {
    rarest_first.push_back({&kind, y});
    if (in_rows) y += row;
  }
  TextStyle style = kBeside;
  style.ink = kText;
  if (in_rows) {
    for (const Placed& placed : rarest_first) {
      const double room = block.left - kBesidePlot - kPageMargin;
      canvas.text(canvas.fitted(placed.kind->name, style, room),
                  {block.left - kBesidePlot, placed.y}, style);
      canvas.text(std::to_string(placed.kind->times_s.size()) + " x",
                  {block.right() + 12, placed.y}, {.size = kTick, .down = Down::middle});
    }
  } else {
    canvas.text("events", {block.left - kBesidePlot, y}, style);
  }
  std::stable_sort(rarest_first.begin(), rarest_first.end(), [](const Placed& a, const Placed& b) {
    return a.kind->times_s.size() < b.kind->times_s.size();
  });
  std::size_t lines = 0;
  for (const Placed& placed : rarest_first) {
    lines += placed.kind->times_s.size();
    if (lines > kMostLines) break;
    for (const double time_s : placed.kind->times_s) {
      const double x = canvas.crisp(block.x_of(time_s));
      // From below, so that the dashes of coinciding lines coincide, too.
      canvas.line({x, bottom}, {x, placed.y})
          .stroke(kText.with_alpha(0.45), {.width = 0.8, .dash = {3, 3}});
    }
  }
  std::for_each(rarest_first.rbegin(), rarest_first.rend(), [&](const Placed& placed) {
    const std::string& name = placed.kind->name;
    const auto each = [&](auto draw) {
      for (const double time_s : placed.kind->times_s) {
        (symbols.*draw)(canvas, name, {block.x_of(time_s), placed.y});
      }
    };
    each(&EventSymbols::draw_rim);
    each(&EventSymbols::draw);
  });
}

}  // namespace elsie::picture
