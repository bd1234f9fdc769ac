// Robots that are too many for rings, names and sketches: dots on thin paths.
#include <algorithm>
#include <array>
#include <cmath>

#include "top_view_parts.h"

namespace elsie::picture {
namespace {

/// Sizes in the picture, from the side of the square that each robot has for itself.
struct Sizes {
  explicit Sizes(double side)
      : dot(std::clamp(0.13 * side, 0.7, 4.5)),
        path(std::clamp(0.045 * side, 0.35, 1.3)),
        touch(std::clamp(0.11 * side, 0.5, 3.5)) {}

  double dot;    // radius
  double path;   // width
  double touch;  // half the length of an arm
};

Sizes sizes_of(const Scene& scene, const Layout& layout) {
  return Sizes(
      std::sqrt(layout.plot.width * layout.plot.height / static_cast<double>(scene.robots.size())));
}

void draw_dot(Canvas& canvas, const Vector2& at, double heading_rad, double radius,
              const Ink& ink) {
  constexpr double kLegible = 2.0;
  canvas.circle(at, radius).fill(ink);
  if (radius < kLegible) return;
  const double reach = 2.4 * radius;  // y points down in the picture
  const Vector2 tip{at.x + reach * std::cos(heading_rad), at.y - reach * std::sin(heading_rad)};
  canvas.line(at, tip).stroke(ink, {.width = 0.5 * radius});
}

void draw_cross(Canvas& canvas, const Vector2& at, double arm) {
  canvas.line({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm});
  canvas.line({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm});
  canvas.stroke(kTouch, {.width = std::clamp(0.4 * arm, 0.4, 1.2)});
}

Ink dot_ink(const Ink& robot) { return mix(robot, kText, 0.3); }
Ink path_ink(const Ink& robot) { return mix(robot, kFloor, 0.45); }

void draw_path(Canvas& canvas, const DrawnRobot& robot, const Layout& layout, double width) {
  std::vector<Vector2> points;
  const auto end_line = [&] {
    if (points.size() > 1) canvas.polyline(points).stroke(path_ink(robot.ink), {.width = width});
    points.clear();
  };
  for (const PathStep& step : visible_steps(layout, robot.track, 0.7)) {
    if (!step.driven) end_line();
    points.push_back(step.at);
  }
  end_line();
}

}  // namespace

void draw_crowd(Canvas& canvas, const Scene& scene, const Layout& layout) {
  const Sizes sizes = sizes_of(scene, layout);
  for (const DrawnRobot& robot : scene.robots) draw_path(canvas, robot, layout, sizes.path);
  for (const DrawnRobot& robot : scene.robots) {
    for (const Pose& segment : robot.track.segments) {
      if (!finite(segment)) continue;
      canvas.circle(layout.map.pixel({segment.x, segment.y}), 0.7 * sizes.dot);
      canvas.fill(path_ink(robot.ink));
    }
    const Pose& now = robot.track.now;
    if (!finite(now)) continue;
    draw_dot(canvas, layout.map.pixel({now.x, now.y}), now.heading_rad, sizes.dot,
             dot_ink(robot.ink));
  }
  for (const DrawnRobot& robot : scene.robots) {
    for (const Vector2& touch : robot.track.touches) {
      draw_cross(canvas, layout.map.pixel(touch), sizes.touch);
    }
  }
}

void draw_crowd_symbol(Canvas& canvas, const Vector2& at, const Ink& ink) {
  draw_dot(canvas, at, 0.0, 4.0, dot_ink(ink));
}
void draw_crowd_path_symbol(Canvas& canvas, const Vector2& at, const Ink& ink) {
  canvas.line({at.x - 13, at.y}, {at.x + 13, at.y}).stroke(path_ink(ink), {.width = 1.3});
}
void draw_crowd_touch_symbol(Canvas& canvas, const Vector2& at) { draw_cross(canvas, at, 3.5); }

}  // namespace elsie::picture
