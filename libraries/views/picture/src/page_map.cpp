#include "elsie/picture/page_map.h"

#include <algorithm>
#include <cmath>

#include "elsie/picture/polyline.h"

#include "text.h"
#include "top_view_parts.h"

namespace elsie::picture {
namespace {

constexpr int kWidth = 380;
constexpr std::size_t kNamedRobots = 10;

using Pieces = std::vector<std::vector<Vector2>>;

/// A path in the picture.
struct Line {
  const MapPath* path = nullptr;
  Pieces pieces;
};

std::vector<Line> lines_of(const std::vector<MapPath>& paths, const PlaneMap& map,
                           std::size_t most_points) {
  std::vector<Line> lines;
  for (const MapPath& path : paths) {
    std::vector<Vector2> points;
    for (const Vector2& point : path.points) points.push_back(map.pixel(point));
    Line line{&path, pieces(points)};
    std::erase_if(line.pieces, [](const auto& piece) { return piece.size() < 2; });
    if (!line.pieces.empty()) lines.push_back(std::move(line));
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return a.path->kind < b.path->kind; });
  // Raises the tolerance until all lines together have few enough points.
  for (double tolerance = 0.4;; tolerance *= 1.6) {
    std::size_t count = 0;
    for (Line& line : lines) {
      for (auto& piece : line.pieces) {
        piece = simplified(piece, tolerance);
        count += piece.size();
      }
    }
    if (count <= most_points || tolerance > 20.0) return lines;
  }
}

Ink ink_of(MapPath::Kind kind) {
  switch (kind) {
    case MapPath::Kind::missed:
      return hex(0xbb1414, "bad");
    case MapPath::Kind::odd:
      return kText;
    default:
      return hex(0x1d35ab, "c");
  }
}

void draw_line(Canvas& canvas, const Line& line, double opacity) {
  const MapPath::Kind kind = line.path->kind;
  Pen pen{.width = 1.4, .dash = {}, .round = true};
  if (kind == MapPath::Kind::odd) pen.dash = {5, 3.4};
  canvas.open_mark(line.path->title);
  for (const auto& piece : line.pieces) canvas.polyline(piece);
  canvas.stroke(ink_of(kind).with_alpha(kind == MapPath::Kind::plain ? opacity : 0.85), pen);
  canvas.close_mark();
}

void draw_end(Canvas& canvas, const Line& line) {
  const Vector2& end = line.pieces.back().back();
  const Ink ink = ink_of(line.path->kind);
  if (line.path->kind == MapPath::Kind::missed) {
    constexpr double kCross = 4.5;
    canvas.line({end.x - kCross, end.y - kCross}, {end.x + kCross, end.y + kCross});
    canvas.line({end.x - kCross, end.y + kCross}, {end.x + kCross, end.y - kCross});
    canvas.stroke(ink, {.width = 2});
  } else {
    canvas.dot(end, line.path->kind == MapPath::Kind::odd ? 4.2 : 3.0, ink);
  }
}

}  // namespace

std::string page_map(const world::World& world, const std::vector<MapPath>& paths,
                     std::size_t most_points, const std::string& label) {
  TopView view{world};
  view.bare = true;
  const Scene scene = complete(view);
  const Layout layout = lay_out(scene, {}, {kWidth, 0}, 1.0);
  const std::vector<Line> lines = lines_of(paths, layout.map, most_points);
  // The more lines, the more transparent each is.
  const double opacity =
      std::clamp(3.0 / std::sqrt(std::max(1.0, static_cast<double>(lines.size()))), 0.3, 1.0);

  Canvas canvas(FileType::page, layout.width, layout.height, layout.zoom);
  LabelPlacer labels(layout.arena);
  draw_floor(canvas, scene, layout);
  draw_goals(canvas, scene, layout);
  draw_chargers(canvas, scene, layout);
  draw_walls(canvas, scene, layout);
  for (const Line& line : lines) draw_line(canvas, line, opacity);
  draw_boxes(canvas, scene, layout, labels);
  for (const Line& line : lines) draw_end(canvas, line);
  if (scene.is_crowd()) {
    draw_crowd(canvas, scene, layout);
  } else {
    draw_robots(canvas, scene, layout, labels);
  }
  draw_lamps(canvas, scene, layout);
  const TextStyle style{.size = 11, .halo = 2.0};
  for (const DrawnRobot& robot : scene.robots) {
    if (scene.robots.size() < 2 || scene.robots.size() > kNamedRobots) break;
    const Pose& now = robot.track.now;
    draw_label(canvas, labels, clean_text(robot.track.id, 14), layout.map.pixel({now.x, now.y}),
               robot_radius(robot, layout), style);
  }
  for (const Line& line : lines) {
    if (line.path->name.empty()) continue;
    draw_label(canvas, labels, line.path->name, line.pieces.back().back(), 4.0,
               {.size = 11, .bold = true, .halo = 2.0});
  }
  return canvas.finish(label);
}

}  // namespace elsie::picture
