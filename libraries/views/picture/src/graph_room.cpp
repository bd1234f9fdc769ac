#include "graph_room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace elsie::picture {
namespace {

using Box = GraphLayout::Box;
using Label = GraphLayout::Label;

Box box_of(const Label& label) {
  const Vector2 half{label.size.x / 2, label.size.y / 2};
  return {
      {label.at.x - half.x, label.at.y - half.y}, {label.at.x + half.x, label.at.y + half.y}, {}};
}
bool overlap(const Box& a, const Box& b) {
  return a.from.x < b.to.x && b.from.x < a.to.x && a.from.y < b.to.y && b.from.y < a.to.y;
}
bool is_inside(const Box& inner, const Box& outer) {
  return inner.from.x >= outer.from.x && inner.to.x <= outer.to.x && inner.from.y >= outer.from.y &&
         inner.to.y <= outer.to.y;
}
/// Of a point from the nearest of two sides.
double from_sides(double at, double a, double b) {
  return std::min(std::abs(at - a), std::abs(at - b));
}

/// The box on whose rim the point is.
const Box* box_at(const GraphLayout& layout, const Vector2& point) {
  constexpr double kNear = 2.0;
  for (const Box& box : layout.boxes) {
    const Box grown{
        {box.from.x - kNear, box.from.y - kNear}, {box.to.x + kNear, box.to.y + kNear}, {}};
    const bool is_on_rim = from_sides(point.x, box.from.x, box.to.x) < kNear ||
                           from_sides(point.y, box.from.y, box.to.y) < kNear;
    if (is_on_rim && is_inside({point, point, {}}, grown)) return &box;
  }
  return nullptr;
}

/// Points on an arrow's curve.
std::vector<Vector2> points_of(const GraphLayout::Arrow& arrow) {
  constexpr int kParts = 20;  // of each Bezier curve
  std::vector<Vector2> points{arrow.curve.front()};
  for (std::size_t i = 0; i + 3 < arrow.curve.size(); i += 3) {
    const Vector2* const p = &arrow.curve[i];
    for (int k = 1; k <= kParts; ++k) {
      const double t = static_cast<double>(k) / kParts, u = 1.0 - t;
      const double a = u * u * u, b = 3 * u * u * t, c = 3 * u * t * t, d = t * t * t;
      points.push_back({a * p[0].x + b * p[1].x + c * p[2].x + d * p[3].x,
                        a * p[0].y + b * p[1].y + c * p[2].y + d * p[3].y});
    }
  }
  return points;
}

double distance(const Box& place, const Vector2& point) {
  return std::hypot(std::max({place.from.x - point.x, 0.0, point.x - place.to.x}),
                    std::max({place.from.y - point.y, 0.0, point.y - place.to.y}));
}
/// To the nearest of the points.
double distance(const Box& place, const std::vector<Vector2>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2& point : points) least = std::min(least, distance(place, point));
  return least;
}

}  // namespace

void part_arrows(GraphLayout& layout) {
  constexpr double kApart = 12.0, kCorner = 6.0;
  for (GraphLayout::Arrow& arrow : layout.arrows) {
    const Vector2 begin = arrow.curve.front();
    const auto tip_at = [&](const Vector2& point) {
      return std::find_if(layout.arrows.begin(), layout.arrows.end(), [&](const auto& other) {
        return std::hypot(other.tip.x - point.x, other.tip.y - point.y) < kApart - 1.0;
      });
    };
    const auto met = tip_at(begin);
    const Box* const box = met == layout.arrows.end() ? nullptr : box_at(layout, begin);
    if (!box) continue;
    const bool is_level =
        from_sides(begin.y, box->from.y, box->to.y) < from_sides(begin.x, box->from.x, box->to.x);
    const double Vector2::*const along = is_level ? &Vector2::x : &Vector2::y;
    // To the side on which it ends, so that the two do not cross.
    const double side = arrow.tip.*along < met->curve.front().*along ? -1.0 : 1.0;
    for (const double by : {side, -side, 2 * side, -2 * side}) {
      Vector2 moved = begin;
      const double to = moved.*along + by * kApart;
      if (to < box->from.*along + kCorner || to > box->to.*along - kCorner) continue;
      (is_level ? moved.x : moved.y) = to;
      if (tip_at(moved) != layout.arrows.end()) continue;
      arrow.curve[1] = {arrow.curve[1].x + moved.x - begin.x, arrow.curve[1].y + moved.y - begin.y};
      arrow.curve[0] = moved;
      break;
    }
  }
}

void free_labels(GraphLayout& layout) {
  constexpr double kStep = 5.0, kNear = 12.0;
  constexpr int kMost = 12;  // steps
  std::vector<Vector2> ways;
  for (int i = -kMost; i <= kMost; ++i) {
    for (int j = -kMost; j <= kMost; ++j) ways.push_back({kStep * i, kStep * j});
  }
  std::stable_sort(ways.begin(), ways.end(), [](const Vector2& a, const Vector2& b) {
    return a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y;
  });
  const Box page{{0.0, 0.0}, {layout.width, layout.height}, {}};
  std::vector<std::vector<Vector2>> lines;
  for (const GraphLayout::Arrow& arrow : layout.arrows) lines.push_back(points_of(arrow));
  for (GraphLayout::Arrow& arrow : layout.arrows) {
    if (arrow.label.text.empty()) continue;
    const std::vector<Vector2>& points =
        lines[static_cast<std::size_t>(&arrow - layout.arrows.data())];
    const auto is_at = [](const Box& place, const Vector2& point) {
      return is_inside({point, point, {}}, place);
    };
    // Inside the frames in which the arrow is, and outside all others.
    const auto is_clear_of = [&](const Box& place, const Box& box) {
      const bool holds_arrow =
          box.is_frame && is_at(box, points.front()) && is_at(box, points.back());
      return holds_arrow ? is_inside(place, box) && !overlap(place, box_of(box.label))
                         : !overlap(place, box);
    };
    const auto is_free = [&](const Label& label) {
      const Box place = box_of(label);
      return is_inside(place, page) &&
             std::all_of(layout.boxes.begin(), layout.boxes.end(),
                         [&](const Box& box) { return is_clear_of(place, box); }) &&
             std::none_of(layout.arrows.begin(), layout.arrows.end(), [&](const auto& other) {
               return &other != &arrow && !other.label.text.empty() &&
                      overlap(place, box_of(other.label));
             });
    };
    // Of an arrow that is cut off at a frame, it may be at the part that is not drawn.
    Label start = arrow.label;
    start.size = {start.size.x + 2 * kNear, start.size.y + 2 * kNear};
    if (std::none_of(points.begin(), points.end(),
                     [&](const Vector2& point) { return is_at(box_of(start), point); })) {
      start.at = points[points.size() / 2];
    }
    start.size = arrow.label.size;
    // Lines that any of the places may meet.
    const double window = 2 * kStep * kMost;
    std::vector<Vector2> own, others;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const Vector2& point : lines[i]) {
        if (distance(box_of(start), point) > window) continue;
        (&layout.arrows[i] == &arrow ? own : others).push_back(point);
      }
    }
    // Of a place that can be read: worse on a line, worst where it seems to be of another arrow.
    const auto cost = [&](const Label& label) {
      constexpr double kOnLine = 35.0, kAtOther = 60.0;  // as if it had moved so far
      const double to_own = distance(box_of(label), own);
      const double to_others = distance(box_of(label), others);
      return (std::min(to_own, to_others) > 0.0 ? 0.0 : kOnLine) +
             (to_others < to_own ? kAtOther : 0.0);
    };
    std::optional<Label> found;
    double least = std::numeric_limits<double>::infinity();
    for (const Vector2& way : ways) {
      const double far = std::hypot(way.x, way.y);
      if (far >= least) break;
      Label moved = start;
      moved.at = {moved.at.x + way.x, moved.at.y + way.y};
      if (!is_free(moved)) continue;
      if (const double whole = far + cost(moved); whole < least) {
        least = whole;
        found = moved;
      }
    }
    if (found) arrow.label = *found;
  }
}

}  // namespace elsie::picture
