#include <algorithm>
#include <array>
#include <cmath>

#include "timeline_parts.h"

namespace elsie::picture {
namespace {

constexpr Ink kTogetherInk = hex(0xb4bac1);

/// The nth colour; after the palette, the same colours lighter and slightly turned.
Ink nth_ink(std::size_t index) {
  const std::size_t rounds = index / kSeriesInks;
  const auto round = static_cast<double>(rounds);
  const Ink base = series_ink(index);
  return round == 0.0 ? base : shifted(base, 0.13 * round, 0.3 * round);
}

/// The nth shade of a behaviour's colour, alternating between its two sides.
Ink shade(const Ink& base, std::size_t index) {
  const std::size_t level = index / 2 + 1;
  const double step = 0.42 * static_cast<double>(level);
  return shifted(base, index % 2 == 0 ? 0.10 : -0.04, index % 2 == 0 ? step : -step);
}

}  // namespace

BehaviorInks::BehaviorInks(const traces::Trace& trace) {
  std::size_t outermost = 0;
  std::map<std::string, std::size_t> shades;  // number of shades given by path
  for (const traces::TraceRobot& robot : trace.robots) {
    for (const traces::TraceMember& member : robot.members) {
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

Ink BehaviorInks::of(const traces::TraceRobot& robot, int member) const {
  return by_path_.at(robot.members[static_cast<std::size_t>(member)].path);
}

Ink BehaviorInks::of_decider(const traces::TraceRobot& robot, traces::Decider decider) const {
  if (decider >= 0) return of(robot, decider);
  return decider == traces::kTogether ? kTogetherInk : kPaper;
}

std::map<std::string, Colour> behavior_colours(const traces::Trace& trace) {
  const auto whole = [](double part) {
    return static_cast<std::uint8_t>(std::lround(255.0 * part));
  };
  const BehaviorInks inks(trace);
  std::map<std::string, Colour> colours;
  for (const auto& [path, ink] : inks.by_path()) {
    colours[path] = {whole(ink.red), whole(ink.green), whole(ink.blue)};
  }
  return colours;
}

}  // namespace elsie::picture
