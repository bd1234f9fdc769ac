#include "scene/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elsie/picture/axis.h"
#include "elsie/picture/colours.h"
#include "elsie/render/sketch_style.h"

namespace elsie::desktop {
namespace {

constexpr Colour kGridInk{0, 0, 0};
constexpr Colour kGoalInk = picture::kGoalColour;
constexpr Colour kSensorInk{0xe0, 0x80, 0x00};

/// A closed line through points of a circle.
template <class Place>
void add_circle(std::vector<render::Stroke>& lines, int sides, const render::Stroke& pen,
                const Place& place) {
  for (int i = 0; i < sides; ++i) {
    render::Stroke line = pen;
    line.from = place(2.0 * std::numbers::pi * i / sides);
    line.to = place(2.0 * std::numbers::pi * (i + 1) / sides);
    lines.push_back(line);
  }
}

}  // namespace

double grid_step(const Stage& stage, const OrbitCamera& camera) {
  const double across = 1.2 * camera.distance;
  return picture::nice_step(std::min(std::max(stage.length(), stage.width()), across), 8);
}

std::vector<render::Stroke> grid_lines(const Stage& stage, const OrbitCamera& camera) {
  constexpr double kMostLines = 400.0;
  std::vector<render::Stroke> lines;
  const double x = 0.5 * stage.length(), y = 0.5 * stage.width();
  const double labelled = grid_step(stage, camera);
  if (x <= 0.0 || y <= 0.0 || (2.0 * (x + y)) / labelled > kMostLines) return lines;
  const double step = 0.2 * labelled;
  const auto opacity = [&](double at) {
    const double multiple = at / labelled;
    return std::abs(multiple - std::round(multiple)) < 1e-6 ? 0.22 : 0.07;
  };
  for (const double at : picture::multiples(-x, x, step).at) {
    lines.push_back({{at, -y, 0.0}, {at, y, 0.0}, kGridInk, opacity(at)});
  }
  for (const double at : picture::multiples(-y, y, step).at) {
    lines.push_back({{-x, at, 0.0}, {x, at, 0.0}, kGridInk, opacity(at)});
  }
  return lines;
}

std::vector<render::Stroke> goal_lines(const Stage& stage) {
  constexpr std::size_t kMost = 2000;
  std::vector<render::Stroke> lines;
  const std::vector<Stage::Goal> goals = stage.goals();
  const int sides = goals.size() > 100 ? 16 : 48;
  for (std::size_t i = 0; i < std::min(goals.size(), kMost); ++i) {
    const Stage::Goal& goal = goals[i];
    const double arm = std::min(0.1, 0.5 * goal.radius);
    render::Stroke pen{{}, {}, kGoalInk, 0.9, 2.0};
    add_circle(lines, sides, pen, [&](double angle) {
      return Vector3{goal.at.x + goal.radius * std::cos(angle),
                     goal.at.y + goal.radius * std::sin(angle), 0.0};
    });
    // Every third piece is a gap.
    std::size_t kept = lines.size() - static_cast<std::size_t>(sides);
    for (std::size_t k = kept, piece = 0; k < lines.size(); ++k, ++piece) {
      if (piece % 3 != 2) lines[kept++] = lines[k];
    }
    lines.resize(kept);
    for (const Vector3& way : {Vector3{arm, 0.0, 0.0}, Vector3{0.0, arm, 0.0}}) {
      const Vector3 middle{goal.at.x, goal.at.y, 0.0};
      lines.push_back({middle - way, middle + way, kGoalInk, 0.8, 1.5});
    }
  }
  return lines;
}

std::vector<render::Stroke> sketch_lines(const Stage& stage) {
  std::vector<render::Stroke> lines;
  for (const snapshots::MarkState& mark : stage.marks()) {
    if (mark.kind != Sketch::Kind::line && mark.kind != Sketch::Kind::arrow) continue;
    // Its memory is shared with a process that runs plugins: the role may be any number.
    const render::SketchStyle& style = render::style_of(mark.role);
    lines.push_back(
        {mark.begin(), mark.end(), style.colour, style.opacity, style.width, style.dash});
  }
  return lines;
}

std::vector<render::Stroke> sensor_lines(const Frame& sensor) {
  constexpr double kLength = 0.12, kRadius = 0.04;  // m
  constexpr int kSides = 16;
  std::vector<render::Stroke> lines;
  const render::Stroke pen{{}, {}, kSensorInk, 1.0, 2.0};
  const auto rim = [&](double angle) {
    return sensor.point({kLength, kRadius * std::cos(angle), kRadius * std::sin(angle)});
  };
  add_circle(lines, kSides, pen, rim);
  for (const double angle : {0.0, 0.5, 1.0, 1.5}) {
    render::Stroke side = pen;
    side.from = sensor.origin;
    side.to = rim(angle * std::numbers::pi);
    lines.push_back(side);
  }
  return lines;
}

}  // namespace elsie::desktop
