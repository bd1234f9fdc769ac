#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "elsie/world/parts.h"

#include "panel.h"
#include "text.h"
#include "top_view_parts.h"

namespace elsie::picture {
namespace {

constexpr double kSmallestResource = 13.0;  // so that its mark is visible

Rect bounds_of(const std::vector<Vector2>& corners) {
  double left = corners.front().x, right = left, top = corners.front().y, bottom = top;
  for (const Vector2& corner : corners) {
    left = std::min(left, corner.x);
    right = std::max(right, corner.x);
    top = std::min(top, corner.y);
    bottom = std::max(bottom, corner.y);
  }
  return {left, top, right - left, bottom - top};
}

// A box from above, enlarged to the smallest visible size.
std::vector<Vector2> box_outline(const Layout& layout, const world::Obstacle& box,
                                 const Pose& pose) {
  constexpr int kRound = 48;  // corners of a circle
  const double least =
      box.kind == world::ObstacleKind::resource ? kSmallestResource : layout.smallest_box;
  const double smallest = least / layout.map.scale_x;
  const Shape shape = world::fixture_of(box).shape;
  const Shape shown =
      resized(shape, std::max(shape.size.x, smallest), std::max(shape.size.y, smallest));
  return pixels(layout.map, pose, outline_of(shown, kRound));
}

void draw_way(Canvas& canvas, const Layout& layout, const world::Obstacle& box) {
  std::vector<Vector2> way{layout.map.pixel({box.x, box.y})};
  for (const Vector2& point : box.waypoints) way.push_back(layout.map.pixel(point));
  if (way.size() < 2) return;
  if (box.round_trip && way.size() > 2) way.push_back(way.front());
  canvas.polyline(way).stroke(kMovingEdge.with_alpha(0.8),
                              {.width = 1.8, .dash = {0.1, 5}, .round = true});
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Vector2& a = way[i];
    const Vector2& b = way[i + 1];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < 30.0) continue;
    const double part = 0.5 + 5.0 / length;
    const double angle = std::atan2(b.y - a.y, b.x - a.x);
    draw_arrow_head(canvas, {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)}, angle, 10,
                    kMovingEdge);
  }
}

void draw_moved(Canvas& canvas, const Layout& layout, const world::Obstacle& box, const Pose& now) {
  const Pose start = start_of(box);
  const Vector2 a = layout.map.pixel({start.x, start.y}), b = layout.map.pixel({now.x, now.y});
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const bool turned = std::abs(wrap_angle(now.heading_rad - start.heading_rad)) > 0.05;
  if (length < 2.0 && !turned) return;
  canvas.polygon(box_outline(layout, box, start));
  canvas.stroke(kDynamicEdge, {.width = 1.1, .dash = {4, 3}});
  if (length < 18.0) return;
  canvas.line(a, b).stroke(kDynamicEdge.with_alpha(0.7), {.width = 1.1});
  canvas.circle(a, 2).fill(kDynamicEdge);
}

void draw_collected(Canvas& canvas, const Layout& layout, const world::Obstacle& box,
                    const Ink& ink) {
  canvas.polygon(box_outline(layout, box, start_of(box)));
  canvas.stroke(ink, {.width = 1.4, .dash = {3, 2.5}});
}

void draw_box(Canvas& canvas, const Scene& scene, const Layout& layout, const world::Obstacle& box,
              const std::vector<Vector2>& corners) {
  const Rect bounds = bounds_of(corners);
  const auto own = [&](const Ink& otherwise) { return box.colour ? ink(*box.colour) : otherwise; };
  switch (box.kind) {
    case world::ObstacleKind::fixed:
      canvas.polygon(corners).fill_keep(own(kFixedBox));
      canvas.stroke(box.colour ? mix(ink(*box.colour), kText, 0.4) : kFixedEdge,
                    {.width = layout.smallest_box / Layout::kSmallestBox});
      return;
    case world::ObstacleKind::dynamic: {
      const Ink edge = box.colour ? mix(ink(*box.colour), kText, 0.3) : kDynamicEdge;
      canvas.polygon(corners);
      fill_hatched(canvas, bounds, box.colour ? mix(kPaper, ink(*box.colour), 0.45) : kDynamicBox,
                   edge);
      canvas.polygon(corners).stroke(edge, {.width = 1.3});
      return;
    }
    case world::ObstacleKind::moving:
      canvas.polygon(corners).fill_keep(own(kMovingBox));
      canvas.stroke(kMovingEdge, {.width = 1.3});
      return;
    case world::ObstacleKind::resource: {
      const Ink team = resource_ink(scene.world, box);
      canvas.polygon(corners).fill_keep(team);
      canvas.stroke(mix(team, kText, 0.35), {.width = 1});
      const double edge = layout.map.scale_x * std::min(box.length, box.width);
      draw_resource_mark(canvas, bounds.centre(), std::max(kSmallestResource, edge) * 0.32, kPaper);
      return;
    }
  }
}

// The robots that should reach a place.
std::string whose(const world::ReachGoal& goal) {
  if (!goal.robot.empty()) return clean_text(goal.robot, 16);
  const std::string which = goal.any ? "any robot" : "every robot";
  return goal.team.empty() ? which : which + " of " + clean_text(goal.team, 16);
}

// Calls `show` for each goal that is a place with its middle, radius in the picture, and text.
template <class Visitor>
void each_place(const Scene& scene, const Layout& layout, Visitor visit) {
  constexpr double kSmallest = 9.0;
  const auto show = [&](double x, double y, double radius, const std::string& text) {
    visit(layout.map.pixel({x, y}), std::max(kSmallest, radius * layout.map.scale_x), text);
  };
  std::unordered_map<std::string_view, const DrawnRobot*> robots;
  for (const DrawnRobot& robot : scene.robots) robots.emplace(robot.track.id, &robot);
  world::for_each_goal(scene.world.goals, [&](const world::Goal& goal) {
    if (const auto* reach = std::get_if<world::ReachGoal>(&goal)) {
      Vector2 place{reach->x, reach->y};
      if (const auto robot = robots.find(reach->of); robot != robots.end()) {
        place = point_of(robot->second->track.now, place);
      }
      show(place.x, place.y, reach->radius, "goal of " + whose(*reach));
    } else if (const auto* push = std::get_if<world::PushGoal>(&goal)) {
      show(push->x, push->y, push->radius, "goal for " + clean_text(push->obstacle, 16));
    }
  });
}

// A place, and the texts of its goals.
struct MarkedPlace {
  Vector2 at;
  double radius = 0.0;
  std::vector<std::string> texts;
};

// Goals in one place are drawn once, with one label.
std::vector<MarkedPlace> marked_places(const Scene& scene, const Layout& layout) {
  constexpr double kSame = 2.0;
  std::vector<MarkedPlace> marks;
  std::map<std::pair<double, double>, std::vector<std::size_t>> cells;  // marks, by places
  each_place(scene, layout, [&](const Vector2& at, double radius, const std::string& text) {
    const double column = std::floor(at.x / kSame), row = std::floor(at.y / kSame);
    std::size_t known = marks.size();  // the first of those that are there
    for (const double dx : {-1.0, 0.0, 1.0}) {
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const auto cell = cells.find({column + dx, row + dy});
        if (cell == cells.end()) continue;
        for (const std::size_t i : cell->second) {
          const MarkedPlace& mark = marks[i];
          if (i < known && std::hypot(mark.at.x - at.x, mark.at.y - at.y) < kSame &&
              std::abs(mark.radius - radius) < kSame) {
            known = i;
          }
        }
      }
    }
    if (known < marks.size()) {
      marks[known].texts.push_back(text);
      return;
    }
    cells[{column, row}].push_back(marks.size());
    marks.push_back({at, radius, {text}});
  });
  return marks;
}

// "goal of r1, r2", "goal of r1, r2 and 3 more" for goals in one place.
std::string joined_goals(const std::vector<std::string>& texts) {
  constexpr std::size_t kNamed = 2;
  std::string text = texts.front();
  const std::string start = "goal of ";
  for (std::size_t i = 1; i < texts.size() && i < kNamed; ++i) {
    const bool same = texts[i].starts_with(start) && text.starts_with(start);
    text += ", " + (same ? texts[i].substr(start.size()) : texts[i]);
  }
  return texts.size() <= kNamed ? text
                                : text + " and " + std::to_string(texts.size() - kNamed) + " more";
}

}  // namespace

Pose start_of(const world::Obstacle& box) { return {box.x, box.y, radians(box.heading_deg)}; }

std::vector<Vector2> pixels(const PlaneMap& map, const Pose& pose, std::vector<Vector2> corners) {
  for (Vector2& corner : corners) corner = map.pixel(point_of(pose, corner));
  return corners;
}

void draw_arrow_head(Canvas& canvas, const Vector2& tip, double angle, double length,
                     const Ink& ink) {
  const auto point = [&](double back, double aside) {
    const double c = std::cos(angle), s = std::sin(angle);
    return Vector2{tip.x - back * c - aside * s, tip.y - back * s + aside * c};
  };
  const std::array<Vector2, 4> head{tip, point(length, 0.42 * length), point(0.72 * length, 0),
                                    point(length, -0.42 * length)};
  canvas.polygon(head).fill(ink);
}

void fill_hatched(Canvas& canvas, const Rect& box, const Ink& ground, const Ink& lines) {
  if (canvas.in_page()) return canvas.fill(ground);
  canvas.fill_keep(ground);
  hatch(canvas, box, 6.0, lines.with_alpha(0.65));
}

void draw_resource_mark(Canvas& canvas, const Vector2& at, double radius, const Ink& ink) {
  const std::array<Vector2, 4> diamond{Vector2{at.x, at.y - radius}, Vector2{at.x + radius, at.y},
                                       Vector2{at.x, at.y + radius}, Vector2{at.x - radius, at.y}};
  canvas.polygon(diamond).fill(ink.with_alpha(0.92));
}

void draw_bolt(Canvas& canvas, const Vector2& at, double radius, const Ink& ink) {
  constexpr std::array<Vector2, 6> kShape{
      {{0.18, -0.95}, {-0.55, 0.15}, {-0.06, 0.15}, {-0.18, 0.95}, {0.55, -0.15}, {0.06, -0.15}}};
  std::array<Vector2, 6> bolt{};
  std::transform(kShape.begin(), kShape.end(), bolt.begin(), [&](const Vector2& p) {
    return Vector2{at.x + radius * p.x, at.y + radius * p.y};
  });
  canvas.polygon(bolt).fill(ink);
}

void draw_goals(Canvas& canvas, const Scene& scene, const Layout& layout) {
  for (const MarkedPlace& mark : marked_places(scene, layout)) {
    const Vector2& at = mark.at;
    canvas.circle(at, mark.radius).fill_keep(kGoal.with_alpha(0.08));
    canvas.stroke(kGoal, {.width = 1.8, .dash = {6, 4}});
    canvas.line({at.x - 4, at.y}, {at.x + 4, at.y}).line({at.x, at.y - 4}, {at.x, at.y + 4});
    canvas.stroke(kGoal.with_alpha(0.8), {.width = 1.2});
  }
}

void draw_goal_labels(Canvas& canvas, const Scene& scene, const Layout& layout,
                      LabelPlacer& labels) {
  const TextStyle style{.size = 12, .ink = kGoal, .halo = 2.5};
  const std::vector<MarkedPlace> marks = marked_places(scene, layout);
  constexpr std::size_t kMostLabels = 120;
  if (marks.size() > kMostLabels) {
    labels.leave_out(marks.size());
    return;
  }
  for (const MarkedPlace& mark : marks) {
    const std::string text = joined_goals(mark.texts);
    draw_label(canvas, labels, text, mark.at, mark.radius, style);
  }
}

void draw_chargers(Canvas& canvas, const Scene& scene, const Layout& layout) {
  constexpr double kSmallest = 9.0;
  for (const world::Charger& charger : scene.world.chargers) {
    const Ink colour = team_ink(scene.world, charger.team);
    const Vector2 at = layout.map.pixel({charger.x, charger.y});
    const double radius = std::max(kSmallest, charger.radius * layout.map.scale_x);
    canvas.circle(at, radius).fill_keep(colour.with_alpha(0.16));
    canvas.stroke(colour, {.width = 1.5});
    if (charger.seen_by_range_sensors) {
      const Shape box = world::fixture_of(charger).shape;
      canvas.polygon(pixels(layout.map, {charger.x, charger.y, 0.0}, outline_of(box, 4)));
      canvas.fill_keep(mix(kFloor, colour, 0.4));
      canvas.stroke(colour, {.width = 1});
    }
    draw_bolt(canvas, at, std::min(0.75 * radius, 20.0), colour);
  }
}

void draw_boxes(Canvas& canvas, const Scene& scene, const Layout& layout, LabelPlacer& labels) {
  const auto& boxes = scene.world.obstacles;
  // Objects flat on the floor are below all others.
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::optional<Pose>& now = scene.boxes[i];
    if (boxes[i].kind == world::ObstacleKind::moving) draw_way(canvas, layout, boxes[i]);
    if (boxes[i].is_dynamic() && now && finite(*now)) {
      draw_moved(canvas, layout, boxes[i], *now);
    }
    if (!now) {
      const bool resource = boxes[i].kind == world::ObstacleKind::resource;
      draw_collected(canvas, layout, boxes[i],
                     resource ? resource_ink(scene.world, boxes[i]) : kFixedEdge);
    }
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::optional<Pose>& now = scene.boxes[i];
    if (!now || !finite(*now)) continue;
    const std::vector<Vector2> corners = box_outline(layout, boxes[i], *now);
    draw_box(canvas, scene, layout, boxes[i], corners);
    labels.avoid(bounds_of(corners), 0.6);
  }
}

}  // namespace elsie::picture
