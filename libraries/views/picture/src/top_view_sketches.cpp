// What plugins draw, from above: a style for each role.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "elsie/picture/hits.h"

#include "text.h"
#include "top_view_parts.h"

namespace elsie::picture {
namespace {

constexpr Ink kField = hex(0x2f6f9f);
constexpr Ink kTarget = hex(0x1b5fb0);
constexpr Ink kWish = hex(0x9c2f8a);
constexpr Ink kBelief = hex(0x5a5f6b);
constexpr Ink kMessage = hex(0x00838f);

struct RoleStyle {
  Ink ink;
  double opacity = 0.9;  // of lines
  double width = 1.1;
  std::vector<double> dash{};
};

const RoleStyle& style_of(SketchRole role) {
  static const std::array<RoleStyle, 7> styles{{{kBeam, 0.55, 0.9, {4, 3}},  // range
                                                {kBeam, 0.9, 1.1},           // hit
                                                {kField, 0.45, 1.0},
                                                {kTarget, 0.9, 1.3},
                                                {kWish, 0.9, 1.6},
                                                {kBelief, 0.9, 1.2, {3, 2}},
                                                {kMessage, 0.9, 1.5}}};
  return styles.at(static_cast<std::size_t>(role));
}

Vector2 pixel(const Layout& layout, const Vector3& place) {
  return layout.map.pixel({place.x, place.y});
}

/// The sketches of measures, with null, and those of robots, in the order in which they are drawn.
template <class Visit>
void visit_sketches(const Scene& scene, const Visit& visit) {
  for (const Sketch& sketch : scene.sketches) visit(sketch, nullptr);
  for (const DrawnRobot& robot : scene.robots) {
    for (const Sketch& sketch : robot.track.sketches) visit(sketch, &robot);
  }
}

/// Draws the lines of one sketch. Edges of a volume that coincide from above are drawn once: twice
/// the same dashes make a line without gaps.
class LinePainter {
 public:
  LinePainter(Canvas& canvas, LabelPlacer& labels) : canvas_(canvas), labels_(labels) {}

  void draw(const std::vector<Vector2>& places, SketchRole role) {
    std::vector<Vector2> run{places.front()};
    for (std::size_t i = 1; i < places.size(); ++i) {
      if (is_new(places[i - 1], places[i])) {
        run.push_back(within_reach(places[i - 1], places[i]));
      } else {
        end(run, role);
        run = {places[i]};
      }
    }
    end(run, role);
  }

 private:
  using Place = std::pair<double, double>;

  /// To a hundredth of a pixel: an upper and a lower edge differ by rounding errors.
  static Place place_of(const Vector2& at) {
    return {std::round(100.0 * at.x), std::round(100.0 * at.y)};
  }

  /// A place far outside of the picture, moved towards the one before: so a line keeps its
  /// direction within the limits of coordinates.
  static Vector2 within_reach(const Vector2& before, const Vector2& place) {
    constexpr double kMost = 2e4;  // px
    const double length = std::hypot(place.x - before.x, place.y - before.y);
    const double part = length > kMost ? kMost / length : 1.0;
    return {before.x + part * (place.x - before.x), before.y + part * (place.y - before.y)};
  }

  bool is_new(const Vector2& a, const Vector2& b) {
    const Place one = place_of(a), other = place_of(b);
    return one != other && drawn_.insert(std::minmax(one, other)).second;
  }

  void end(const std::vector<Vector2>& run, SketchRole role) {
    if (run.size() < 2) return;
    const RoleStyle& style = style_of(role);
    avoid(run);
    canvas_.polyline(run).stroke(style.ink.with_alpha(style.opacity),
                                 {.width = style.width, .dash = style.dash});
  }

  void avoid(const std::vector<Vector2>& run) {
    if (run.size() > 2) {
      for (const Vector2& place : run) labels_.avoid_spot(place);
      return;
    }
    for (const double part : {0.2, 0.4, 0.6, 0.8, 1.0}) {
      labels_.avoid_spot(
          {run[0].x + part * (run[1].x - run[0].x), run[0].y + part * (run[1].y - run[0].y)});
    }
  }

  Canvas& canvas_;
  LabelPlacer& labels_;
  std::set<std::pair<Place, Place>> drawn_;
};

void draw_lines(Canvas& canvas, const Sketch& sketch, const Layout& layout, LabelPlacer& labels) {
  const Hits hits(sketch);
  LinePainter painter(canvas, labels);
  std::vector<Vector2> places;
  for (const Sketch::Mark& mark : sketch.marks()) {
    if (mark.kind != Sketch::Kind::line) continue;
    places.clear();
    for (const Vector3& place : sketch.places(mark)) places.push_back(pixel(layout, place));
    painter.draw(places, hits.role_of(mark));
  }
}

void draw_arrow(Canvas& canvas, const Vector2& from, const Vector2& to, SketchRole role) {
  const RoleStyle& style = style_of(role);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0.0)) return;
  const double head = std::min(7.0, length);
  const Ink ink = style.ink.with_alpha(style.opacity);
  const double part = (length - 0.8 * head) / length;
  canvas.line(from, {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
  canvas.stroke(ink, {.width = style.width, .dash = style.dash});
  draw_arrow_head(canvas, to, std::atan2(to.y - from.y, to.x - from.x), head, ink);
}

void draw_target(Canvas& canvas, const Vector2& at) {
  constexpr double kRadius = 5.0, kArm = 8.0;
  for (const auto& [ink, width] : {std::pair{kPaper.with_alpha(0.9), 3.2}, {kTarget, 1.4}}) {
    canvas.line({at.x - kArm, at.y}, {at.x + kArm, at.y}).stroke(ink, {.width = width});
    canvas.line({at.x, at.y - kArm}, {at.x, at.y + kArm}).stroke(ink, {.width = width});
    canvas.circle(at, kRadius).stroke(ink, {.width = width});
  }
}

void draw_point(Canvas& canvas, const Vector2& at, SketchRole role, double dot) {
  const Ink& ink = style_of(role).ink;
  switch (role) {
    case SketchRole::hit:
      canvas.circle(at, dot + 0.8).fill(kPaper.with_alpha(0.9));
      canvas.circle(at, dot).fill(ink);
      break;
    case SketchRole::field:
      canvas.circle(at, 1.4 * dot).fill(ink.with_alpha(0.3));
      break;
    case SketchRole::target:
      draw_target(canvas, at);
      break;
    case SketchRole::belief:
      canvas.circle(at, dot + 0.8).stroke(ink, {.width = 1.2});
      break;
    case SketchRole::range:
    case SketchRole::wish:
    case SketchRole::message:
      canvas.circle(at, 0.8 * dot).fill(ink.with_alpha(0.7));
      break;
  }
}

/// Where a message meets the outline of the robot that hears it, which would hide the arrow's head.
Vector2 outside(const DrawnRobot& robot, const Layout& layout, const Vector2& from,
                const Vector2& to) {
  const Vector2 middle = layout.map.pixel({robot.track.now.x, robot.track.now.y});
  const double radius = robot_radius(robot, layout) + 1.0;
  // The first solution t of |from + t (to - from) - middle| = radius.
  const double x = from.x - middle.x, y = from.y - middle.y;
  const double way_x = to.x - from.x, way_y = to.y - from.y;
  const double a = way_x * way_x + way_y * way_y, b = x * way_x + y * way_y;
  const double c = x * x + y * y - radius * radius, root = b * b - a * c;
  if (!(c > 0.0) || !(root > 0.0) || !(a > 0.0)) return to;  // it begins inside, or passes by
  const double part = std::clamp((-b - std::sqrt(root)) / a, 0.0, 1.0);
  return {from.x + part * way_x, from.y + part * way_y};
}

void draw_points(Canvas& canvas, const Sketch& sketch, const DrawnRobot* robot,
                 const Layout& layout) {
  const double dot = std::clamp(0.035 * layout.map.scale_x, 1.7, 2.6);
  for (const Sketch::Mark& mark : sketch.marks()) {
    const auto places = sketch.places(mark);
    if (mark.kind == Sketch::Kind::points) {
      for (const Vector3& at : places) draw_point(canvas, pixel(layout, at), mark.role, dot);
    } else if (mark.kind == Sketch::Kind::arrow) {
      const Vector2 from = pixel(layout, places[0]), to = pixel(layout, places[1]);
      const bool is_heard = robot && mark.role == SketchRole::message && finite(robot->track.now);
      draw_arrow(canvas, from, is_heard ? outside(*robot, layout, from, to) : to, mark.role);
    }
  }
}

void draw_texts(Canvas& canvas, const Sketch& sketch, const Layout& layout) {
  constexpr std::size_t kMostCharacters = 40;
  for (const Sketch::Mark& mark : sketch.marks()) {
    if (mark.kind != Sketch::Kind::text) continue;
    canvas.text(clean_text(mark.text, kMostCharacters), pixel(layout, sketch.places(mark)[0]),
                {.size = 10.5,
                 .ink = readable(style_of(mark.role).ink),
                 .across = Across::centre,
                 .down = Down::middle,
                 .halo = 2.5});
  }
}

/// Whether a mark of this kind is shown by this role.
bool has(const Scene& scene, Sketch::Kind kind, SketchRole role) {
  bool found = false;
  visit_sketches(scene, [&](const Sketch& sketch, const DrawnRobot*) {
    if (found) return;
    const Hits hits(sketch);
    for (const Sketch::Mark& mark : sketch.marks()) {
      found |= mark.kind == kind && hits.role_of(mark) == role;
    }
  });
  return found;
}

bool has_any(const Scene& scene, SketchRole role) {
  return has(scene, Sketch::Kind::points, role) || has(scene, Sketch::Kind::line, role) ||
         has(scene, Sketch::Kind::arrow, role);
}

}  // namespace

void draw_sketches(Canvas& canvas, const Scene& scene, const Layout& layout, LabelPlacer& labels) {
  visit_sketches(scene, [&](const Sketch& each, const DrawnRobot*) {
    draw_lines(canvas, each, layout, labels);
  });
  visit_sketches(scene, [&](const Sketch& each, const DrawnRobot* robot) {
    draw_points(canvas, each, robot, layout);
  });
  visit_sketches(scene,
                 [&](const Sketch& each, const DrawnRobot*) { draw_texts(canvas, each, layout); });
}

void add_sketches(const Scene& scene, std::vector<LegendEntry>& entries) {
  if (scene.is_crowd()) return;
  if (has_any(scene, SketchRole::hit)) {
    entries.push_back({"hit of a sensor", 30, [](Canvas& canvas, const Vector2& at) {
                         canvas.line({at.x - 14, at.y}, {at.x + 12, at.y});
                         canvas.stroke(kBeam, {.width = 1.2});
                         canvas.circle({at.x + 12, at.y}, 2.6).fill(kBeam);
                       }});
  }
  if (has_any(scene, SketchRole::range)) {
    entries.push_back({"range of a sensor or actuator", 30, [](Canvas& canvas, const Vector2& at) {
                         canvas.line({at.x - 14, at.y}, {at.x + 14, at.y});
                         canvas.stroke(kBeam.with_alpha(0.7), {.width = 1, .dash = {4, 3}});
                       }});
  }
  if (has_any(scene, SketchRole::field)) {
    entries.push_back(
        {"where something is sensed or done", 24, [](Canvas& canvas, const Vector2& at) {
           for (const double x : {-7.0, 0.0, 7.0}) {
             canvas.circle({at.x + x, at.y}, 3.4).fill(kField.with_alpha(0.3));
           }
         }});
  }
  if (has_any(scene, SketchRole::message)) {
    entries.push_back(
        {"message heard", 30, [](Canvas& canvas, const Vector2& at) {
           draw_arrow(canvas, {at.x - 12, at.y}, {at.x + 12, at.y}, SketchRole::message);
         }});
  }
  if (has_any(scene, SketchRole::target)) {
    entries.push_back({"target of a plugin", 20, draw_target});
  }
  if (has_any(scene, SketchRole::wish)) {
    entries.push_back({"motion that a plugin wants", 30, [](Canvas& canvas, const Vector2& at) {
                         draw_arrow(canvas, {at.x - 12, at.y}, {at.x + 12, at.y}, SketchRole::wish);
                       }});
  }
  if (has_any(scene, SketchRole::belief)) {
    entries.push_back({"what a plugin believes", 30, [](Canvas& canvas, const Vector2& at) {
                         canvas.line({at.x - 13, at.y}, {at.x + 13, at.y});
                         canvas.stroke(kBelief, {.width = 1.2, .dash = {3, 2}});
                       }});
  }
}

}  // namespace elsie::picture
