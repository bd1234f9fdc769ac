#include <algorithm>
#include <array>
#include <numbers>

#include "timeline_parts.h"

namespace elsie::picture {
namespace {

constexpr Ink kTogetherInk = hex(0xb4bac1);

/// The nth colour; past the palette, the same ones lighter and turned a little.
Ink nth_ink(std::size_t index) {
  const auto round = static_cast<double>(index / kSeriesInks);
  const Ink base = series_ink(index);
  return round == 0.0 ? base : shifted(base, 0.13 * round, 0.3 * round);
}

/// The nth shade of a behaviour's colour, to either side of it in turn.
Ink shade(const Ink& base, std::size_t index) {
  const double step = 0.42 * static_cast<double>(index / 2 + 1);
  return shifted(base, index % 2 == 0 ? 0.10 : -0.04, index % 2 == 0 ? step : -step);
}

std::vector<Vector2> corners(const Vector2& at, int count, double radius, double first_angle) {
  std::vector<Vector2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = first_angle + 2.0 * std::numbers::pi * i / count;
    points.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
  }
  return points;
}

}  // namespace

BehaviorInks::BehaviorInks(const simulation::Trace& trace) {
  std::size_t outermost = 0;
  std::map<std::string, std::size_t> shades;  // how many a path has given
  for (const simulation::TraceRobot& robot : trace.robots) {
    for (const simulation::TraceMember& member : robot.members) {
      if (by_path_.contains(member.path)) continue;
      if (member.parent < 0) {
        by_path_[member.path] = nth_ink(outermost++);
      } else {
        const std::string& parent = robot.members[static_cast<std::size_t>(member.parent)].path;
        by_path_[member.path] = shade(by_path_[parent], shades[parent]++);
      }
    }
  }
}

Ink BehaviorInks::of(const simulation::TraceRobot& robot, int member) const {
  return by_path_.at(robot.members[static_cast<std::size_t>(member)].path);
}

Ink BehaviorInks::of_decider(const simulation::TraceRobot& robot,
                             simulation::Decider decider) const {
  if (decider >= 0) return of(robot, decider);
  return decider == simulation::kTogether ? kTogetherInk : kPaper;
}

EventSymbols::EventSymbols(const simulation::Trace& trace, const std::vector<std::size_t>& robots,
                           const simulation::TimeSpan& span) {
  for (const std::size_t r : robots) {
    for (const simulation::TraceEvent& event : trace.robots[r].events) {
      if (event.time_s < span.from_s || event.time_s > span.to_s) continue;
      if (std::find(names_.begin(), names_.end(), event.name) == names_.end()) {
        names_.push_back(event.name);
      }
    }
  }
}

void EventSymbols::draw(Canvas& canvas, const std::string& name, const Vector2& at) const {
  const auto place =
      static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
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
  // The second round through the shapes is hollow.
  canvas.fill_keep(place / 5 % 2 == 0 ? kText : kPaper);
  canvas.stroke(kText, {.width = 1.2});
}

}  // namespace elsie::picture
