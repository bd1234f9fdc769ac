#include <algorithm>
#include <cmath>
#include <numbers>

#include "text.h"
#include "top_view_parts.h"

namespace elsie::picture {
namespace {

constexpr double kBare = 2.0;  // around the arena alone
constexpr double kMargin = 18.0;
constexpr double kLeft = 62.0;    // tick labels and name of the y axis
constexpr double kFooter = 46.0;  // the same of the x axis
constexpr double kTitle = 21.0;
constexpr double kSubtitle = 14.0;
constexpr double kSubtitleLine = 20.0;
constexpr double kBesideLegend = 36.0;
constexpr double kTallest = 1.5;  // ratio of height to width when the height is free

struct Bounds {
  double left, right, bottom, top;

  void include(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    left = std::min(left, x);
    right = std::max(right, x);
    bottom = std::min(bottom, y);
    top = std::max(top, y);
  }
  void grow(double by) {
    left -= by;
    right += by;
    bottom -= by;
    top += by;
  }
};

// Thick walls around a small arena would fill the picture; beyond a part of the arena they are cut
// off.
double shown_wall(const world::Arena& arena) {
  return std::min(arena.wall_thickness, 0.015 * std::max(arena.length, arena.width));
}

// The arena with its walls; without walls, also robots outside, unless they are too far away.
Bounds shown(const Scene& scene) {
  const world::Arena& arena = scene.world.arena;
  const double half_x = arena.length / 2, half_y = arena.width / 2;
  Bounds bounds{-half_x, half_x, -half_y, half_y};
  if (arena.walls) {
    bounds.grow(shown_wall(arena));
  } else {
    const Bounds inside = bounds;
    for (const DrawnRobot& robot : scene.robots) {
      const auto include = [&](const Pose& p) {
        const Vector3& size = robot.plan.parts.front().shape.size;
        const double reach = 0.5 * std::hypot(size.x, size.y);
        bounds.include(p.x - reach, p.y - reach);
        bounds.include(p.x + reach, p.y + reach);
      };
      std::for_each(robot.track.path.begin(), robot.track.path.end(), include);
      include(robot.track.now);
      std::for_each(robot.track.segments.begin(), robot.track.segments.end(), include);
    }
    const double more_x = arena.length, more_y = arena.width;
    bounds.left = std::max(bounds.left, inside.left - more_x);
    bounds.right = std::min(bounds.right, inside.right + more_x);
    bounds.bottom = std::max(bounds.bottom, inside.bottom - more_y);
    bounds.top = std::min(bounds.top, inside.top + more_y);
  }
  bounds.grow(0.006 * std::max(arena.length, arena.width));
  return bounds;
}

double header_height(const Scene& scene) {
  return kMargin + kTitle + 4 +
         kSubtitleLine * static_cast<double>(std::max<std::size_t>(1, scene.subtitles.size())) + 6;
}

// Metres between grid lines; each or every other one has a label.
double grid_step(double scale) {
  constexpr double kClosest = 14.0, kWidest = 170.0;
  if (scale >= kClosest && scale <= kWidest) return 1.0;
  return nice_step(1000.0, static_cast<int>(std::clamp(1000.0 * scale / 60.0, 1.0, 1e8)));
}

// A bar of round length at the right edge, level with the last line of the header.
void draw_scale_bar(Canvas& canvas, const Layout& layout) {
  const double metres = nice_step(100.0 / layout.map.scale_x, 1);
  const double width = metres * layout.map.scale_x;
  const double y = layout.plot.y - 11;
  const double x = layout.width / layout.zoom - kMargin - width;
  canvas.move_to({x, y - 4}).line_to({x, y}).line_to({x + width, y}).line_to({x + width, y - 4});
  canvas.stroke(kText, {.width = 1.6});
  canvas.text(number_text(metres) + " m", {x + width / 2, y - 6},
              {.size = 12, .across = Across::centre});
}

void draw_ticks(Canvas& canvas, const Layout& layout) {
  const Rect& plot = layout.plot;
  const Vector2 low = layout.map.point({plot.x, plot.bottom()});
  const Vector2 high = layout.map.point({plot.right(), plot.y});
  const double grid = grid_step(layout.map.scale_x);
  // Labels are on grid lines, as close to each other as they fit.
  double step = grid;
  for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    step = grid * factor;
    if (step * layout.map.scale_x >= 45.0) break;
  }
  const Ticks along_x = multiples(low.x, high.x, step), along_y = multiples(low.y, high.y, step);
  for (const double at : along_x.at) {
    const double x = canvas.crisp(layout.map.pixel({at, 0}).x);
    canvas.line({x, plot.bottom()}, {x, plot.bottom() + 5}).stroke(kFrame, {.width = 1});
    canvas.text(along_x.label(at), {x, plot.bottom() + 9},
                {.size = 12, .across = Across::centre, .down = Down::top});
  }
  double widest = 0.0;
  for (const double at : along_y.at) {
    const double y = canvas.crisp(layout.map.pixel({0, at}).y);
    canvas.line({plot.x - 5, y}, {plot.x, y}).stroke(kFrame, {.width = 1});
    const TextStyle style{.size = 12, .across = Across::right, .down = Down::middle};
    widest = std::max(widest, canvas.text_width(along_y.label(at), style));
    canvas.text(along_y.label(at), {plot.x - 9, y}, style);
  }
  canvas.text("x (m)", {plot.centre().x, plot.bottom() + 27},
              {.size = 13, .across = Across::centre, .down = Down::top});
  canvas.text("y (m)", {plot.x - 16 - widest, plot.centre().y},
              {.size = 13, .across = Across::centre, .angle = -std::numbers::pi / 2});
}

}  // namespace

Layout lay_out(const Scene& scene, const std::vector<LegendEntry>& entries, const Size& size,
               double zoom) {
  Layout layout;
  layout.zoom = zoom;
  layout.width = size.width;
  const double width = size.width / layout.zoom;
  const double left = scene.bare ? kBare : kLeft;
  const double room = width - left - (scene.bare ? kBare : kMargin);
  // Measuring text needs a surface.
  const Canvas ruler(FileType::png, 1, 1, layout.zoom);
  layout.legend = lay_out_legend(ruler, entries, room);

  const Bounds bounds = shown(scene);
  const double wide = bounds.right - bounds.left, high = bounds.top - bounds.bottom;
  const double header = scene.bare ? kBare : header_height(scene);
  const double footer = scene.bare ? kBare : kFooter + kMargin;
  const double whole = size.height > 0 ? size.height / layout.zoom : kTallest * width;
  const double around = header + footer;
  const auto scale_with = [&](double legend) {
    return std::min(room / wide, std::max(whole - around - legend, 40.0) / high);
  };
  double scale = scale_with(layout.legend.height);
  // The legend fits next to a narrow arena.
  const bool beside = !scene.bare && scale * wide < 0.6 * room;
  if (beside) {
    scale = std::min(scale_with(0.0), 0.6 * room / wide);
    layout.legend =
        lay_out_legend(ruler, entries, std::min(300.0, room - scale * wide - kBesideLegend));
  }
  const double below = beside ? 0.0 : layout.legend.height;

  layout.height = size.height > 0
                      ? size.height
                      : static_cast<int>(std::ceil((around + below + scale * high) * layout.zoom));
  const double spare_x = beside ? 0.0 : (room - scale * wide) / 2;
  const double spare_y =
      size.height > 0 ? std::max(0.0, (whole - around - below - scale * high) / 2) : 0.0;
  layout.plot = {left + spare_x, header + spare_y, scale * wide, scale * high};
  layout.map = {scale, -scale, layout.plot.x - scale * bounds.left,
                layout.plot.y + scale * bounds.top};
  const auto boxes = static_cast<double>(std::max<std::size_t>(scene.world.obstacles.size(), 1));
  layout.smallest_box = std::clamp(0.2 * std::sqrt(layout.plot.width * layout.plot.height / boxes),
                                   1.0, Layout::kSmallestBox);
  const world::Arena& arena = scene.world.arena;
  const Vector2 corner = layout.map.pixel({-arena.length / 2, arena.width / 2});
  layout.arena = {corner.x, corner.y, scale * arena.length, scale * arena.width};
  layout.legend_corner = beside ? Vector2{layout.plot.right() + kBesideLegend, layout.plot.y}
                                : Vector2{kLeft, layout.plot.bottom() + kFooter + 4};
  return layout;
}

void draw_frame(Canvas& canvas, const Scene& scene, const Layout& layout) {
  const double width = layout.width / layout.zoom;
  const TextStyle title{.size = kTitle, .bold = true, .down = Down::top};
  canvas.text(canvas.fitted(scene.title, title, width - kLeft - kMargin), {kLeft, kMargin}, title);
  const TextStyle style{.size = kSubtitle, .ink = kFaintText, .down = Down::top};
  double y = kMargin + kTitle + 6;
  for (const std::string& line : scene.subtitles) {
    // The scale bar is on the right.
    canvas.text(canvas.fitted(line, style, width - kLeft - kMargin - 240), {kLeft, y}, style);
    y += kSubtitleLine;
  }
  draw_scale_bar(canvas, layout);
  draw_ticks(canvas, layout);
}

void draw_floor(Canvas& canvas, const Scene& scene, const Layout& layout) {
  // Without walls, the floor fills the plot.
  const Rect& floor = scene.world.arena.walls ? layout.arena : layout.plot;
  const auto& colour = scene.world.floor.colour;
  canvas.rectangle(floor).fill(colour ? ink(*colour) : kFloor);
  const double step = grid_step(layout.map.scale_x);
  const Vector2 low = layout.map.point({floor.x, floor.bottom()});
  const Vector2 high = layout.map.point({floor.right(), floor.y});
  const auto tone = [&](double at) {
    const bool whole = std::abs(at - std::round(at)) < 1e-9;
    const bool is_main = step < 1.0 && whole;
    if (colour) return mix(ink(*colour), hex(0x808890), is_main ? 0.35 : 0.2);
    return is_main ? hex(0xcfd4d9, "line") : hex(0xe4e7ea, "grid");
  };
  for (const double at : multiples(low.x, high.x, step).at) {
    const double x = canvas.crisp(layout.map.pixel({at, 0}).x);
    canvas.line({x, floor.y}, {x, floor.bottom()}).stroke(tone(at), {.width = 1});
  }
  for (const double at : multiples(low.y, high.y, step).at) {
    const double y = canvas.crisp(layout.map.pixel({0, at}).y);
    canvas.line({floor.x, y}, {floor.right(), y}).stroke(tone(at), {.width = 1});
  }
  draw_floor_marks(canvas, scene, layout);
}

void draw_walls(Canvas& canvas, const Scene& scene, const Layout& layout) {
  const Rect& in = layout.arena;
  if (!scene.world.arena.walls) {
    canvas.rectangle(in).stroke(kWall.with_alpha(0.6), {.width = 1.2, .dash = {8, 5}});
    return;
  }
  // To scale, but never too thin to be seen.
  const double t = std::max(2.5, shown_wall(scene.world.arena) * layout.map.scale_x);
  canvas.rectangle({in.x - t, in.y - t, in.width + 2 * t, t});
  canvas.rectangle({in.x - t, in.bottom(), in.width + 2 * t, t});
  canvas.rectangle({in.x - t, in.y, t, in.height});
  canvas.rectangle({in.right(), in.y, t, in.height});
  canvas.fill(kWall);
}

}  // namespace elsie::picture
