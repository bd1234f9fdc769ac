#include "prism_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace elsie::physics {
namespace {

// A face of b is taken only if it is better than one of a by this much, so that rounding does not
// make the contact jump between them.
constexpr double kPreference = 1e-7;  // m

double dot(const Vector2& a, const Vector2& b) { return a.x * b.x + a.y * b.y; }
Vector2 left_of(const Vector2& v) { return {-v.y, v.x}; }

struct Face {
  double gap = 0.0;
  Vector2 normal;         // outward
  double distance = 0.0;  // of the face from the middle
  double half_edge = 0.0;
};

double reach_along(const Rectangle& r, const Vector2& axis) {
  return r.half_length * std::abs(dot(r.along, axis)) +
         r.half_width * std::abs(dot(left_of(r.along), axis));
}

/// The face of `r` that separates it best from `other`.
Face best_face(const Rectangle& r, const Rectangle& other) {
  const Vector2 between{other.center.x - r.center.x, other.center.y - r.center.y};
  const auto face = [&](const Vector2& axis, double distance, double half_edge) {
    const double side = dot(between, axis) < 0.0 ? -1.0 : 1.0;
    return Face{std::abs(dot(between, axis)) - distance - reach_along(other, axis),
                {side * axis.x, side * axis.y},
                distance,
                half_edge};
  };
  const Face front = face(r.along, r.half_length, r.half_width);
  const Face flank = face(left_of(r.along), r.half_width, r.half_length);
  return flank.gap > front.gap ? flank : front;
}

/// The side of `polygon` that separates it best from `other`, and the gap.
std::pair<Side, double> best_side(const Polygon& polygon, const Polygon& other) {
  const Vector2 between{other.center.x - polygon.center.x, other.center.y - polygon.center.y};
  std::pair<Side, double> best{{}, -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Side side = side_of(polygon.outline(), i);
    double gap = std::numeric_limits<double>::infinity();
    for (const Vector2& corner : other.outline()) {
      gap = std::min(gap, side.gap_to({between.x + corner.x, between.y + corner.y}));
    }
    if (gap > best.second) best = {side, gap};
  }
  return best;
}

PlanarManifold reversed(PlanarManifold manifold) {
  manifold.normal = {-manifold.normal.x, -manifold.normal.y};
  return manifold;
}

}  // namespace

Polygon polygon_of(const Rectangle& r) {
  Polygon polygon{r.center, {}, 4};
  const Vector2 side = left_of(r.along);
  constexpr int kCorners[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = kCorners[i][0] * r.half_length, y = kCorners[i][1] * r.half_width;
    polygon.corners[i] = {x * r.along.x + y * side.x, x * r.along.y + y * side.y};
  }
  return polygon;
}

Polygon polygon_of(const Disc& disc) {
  constexpr std::size_t kCorners = 12;
  Polygon polygon{disc.center, {}, kCorners};
  for (std::size_t i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kCorners;
    polygon.corners[i] = {disc.radius * std::cos(angle), disc.radius * std::sin(angle)};
  }
  return polygon;
}

std::vector<Vector2> common_area(const Polygon& a, const Polygon& b) {
  std::vector<Vector2> left(a.outline().begin(), a.outline().end()), kept;
  for (Vector2& corner : left) corner = {a.center.x + corner.x, a.center.y + corner.y};
  for (std::size_t i = 0; i < b.count; ++i) {
    const Side side = side_of(b.outline(), i);
    const auto gap_of = [&](const Vector2& p) {
      return side.gap_to({p.x - b.center.x, p.y - b.center.y});
    };
    kept.clear();
    for (std::size_t k = 0; k < left.size(); ++k) {
      const Vector2 &from = left[k], &to = left[(k + 1) % left.size()];
      const double gap = gap_of(from), next = gap_of(to);
      if (gap <= 0.0) kept.push_back(from);
      if (gap * next < 0.0) {
        const double part = gap / (gap - next);
        kept.push_back({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
      }
    }
    left.swap(kept);
  }
  return left;
}

PlanarManifold meet(const Rectangle& a, const Rectangle& b, double margin) {
  const Face of_a = best_face(a, b);
  if (of_a.gap > margin) return {};
  const Face of_b = best_face(b, a);
  if (of_b.gap > margin) return {};
  const bool face_of_b = of_b.gap > of_a.gap + kPreference;
  const Face& face = face_of_b ? of_b : of_a;
  const Rectangle& standing = face_of_b ? b : a;
  const Rectangle& coming = face_of_b ? a : b;

  // The edge of the other rectangle that faces this face most directly.
  const Vector2 side = left_of(coming.along);
  const double to_front = dot(coming.along, face.normal), to_side = dot(side, face.normal);
  const bool by_front = std::abs(to_front) > std::abs(to_side);
  const Vector2 out = by_front ? coming.along : side;
  const double out_by = (by_front ? coming.half_length : coming.half_width) *
                        ((by_front ? to_front : to_side) > 0.0 ? -1.0 : 1.0);
  const Vector2 edge = by_front ? side : coming.along;
  const double half_edge = by_front ? coming.half_width : coming.half_length;
  const Vector2 middle{coming.center.x - standing.center.x + out_by * out.x,
                       coming.center.y - standing.center.y + out_by * out.y};

  // Both as functions of the place s in [-half_edge, half_edge] on that edge; keep the part that
  // lies in front of the face.
  const Vector2 tangent = left_of(face.normal);
  const double place = dot(middle, tangent), per_s = dot(edge, tangent);
  double from = -half_edge, to = half_edge;
  if (per_s != 0.0) {
    const double s0 = (-face.half_edge - place) / per_s, s1 = (face.half_edge - place) / per_s;
    from = std::max(from, std::min(s0, s1));
    to = std::min(to, std::max(s0, s1));
  } else if (std::abs(place) > face.half_edge) {
    return {};
  }
  if (from > to) return {};

  PlanarManifold manifold;
  const double sign = face_of_b ? 1.0 : -1.0;
  manifold.normal = {sign * face.normal.x, sign * face.normal.y};
  const auto add = [&](double s) {
    const Vector2 point{middle.x + s * edge.x, middle.y + s * edge.y};
    const double gap = dot(point, face.normal) - face.distance;
    if (gap > margin) return;
    manifold.points[static_cast<std::size_t>(manifold.count++)] = {
        {standing.center.x + point.x - 0.5 * gap * face.normal.x,
         standing.center.y + point.y - 0.5 * gap * face.normal.y},
        gap};
  };
  add(from);
  if (to - from > 1e-6) add(to);
  return manifold;
}

PlanarManifold meet(const Polygon& a, const Polygon& b, double margin) {
  const auto [of_a, gap_of_a] = best_side(a, b);
  if (gap_of_a > margin) return {};
  const auto [of_b, gap_of_b] = best_side(b, a);
  if (gap_of_b > margin) return {};
  const bool face_of_b = gap_of_b > gap_of_a + kPreference;
  const Side& face = face_of_b ? of_b : of_a;
  const Polygon& standing = face_of_b ? b : a;
  const Polygon& coming = face_of_b ? a : b;

  // The side of the other polygon that faces this one most directly.
  Side edge = side_of(coming.outline(), 0);
  for (std::size_t i = 1; i < coming.count; ++i) {
    const Side side = side_of(coming.outline(), i);
    if (dot(side.normal, face.normal) < dot(edge.normal, face.normal)) edge = side;
  }
  // The part of it that lies in front of the face.
  const Vector2 tangent = left_of(face.normal);
  const Vector2 offset{coming.center.x - standing.center.x - face.from.x,
                       coming.center.y - standing.center.y - face.from.y};
  const Vector2 from{offset.x + edge.from.x, offset.y + edge.from.y};
  const Vector2 along{edge.to.x - edge.from.x, edge.to.y - edge.from.y};
  const double place = dot(from, tangent), per_part = dot(along, tangent);
  double first = 0.0, last = 1.0;
  if (per_part != 0.0) {
    const double s0 = -place / per_part, s1 = (face.length - place) / per_part;
    first = std::max(first, std::min(s0, s1));
    last = std::min(last, std::max(s0, s1));
  } else if (place < 0.0 || place > face.length) {
    return {};
  }
  if (first > last) return {};

  PlanarManifold manifold;
  const double sign = face_of_b ? 1.0 : -1.0;
  manifold.normal = {sign * face.normal.x, sign * face.normal.y};
  const auto add = [&](double part) {
    const Vector2 point{from.x + part * along.x, from.y + part * along.y};
    const double gap = dot(point, face.normal);
    if (gap > margin) return;
    manifold.points[static_cast<std::size_t>(manifold.count++)] = {
        {standing.center.x + face.from.x + point.x - 0.5 * gap * face.normal.x,
         standing.center.y + face.from.y + point.y - 0.5 * gap * face.normal.y},
        gap};
  };
  add(first);
  if ((last - first) * edge.length > 1e-6) add(last);
  return manifold;
}

PlanarManifold meet(const Rectangle& a, const Polygon& b, double margin) {
  return meet(polygon_of(a), b, margin);
}

PlanarManifold meet(const Polygon& a, const Rectangle& b, double margin) {
  return meet(a, polygon_of(b), margin);
}

PlanarManifold meet(const Disc& a, const Polygon& b, double margin) {
  const Vector2 middle{a.center.x - b.center.x, a.center.y - b.center.y};
  const Side side = nearest_side(b.outline(), middle);
  double distance = side.gap_to(middle);
  Vector2 nearest = side.nearest_to(middle), out = side.normal;
  if (distance > 0.0) {
    nearest = nearest_point(b.outline(), middle);
    const Vector2 away{middle.x - nearest.x, middle.y - nearest.y};
    distance = std::hypot(away.x, away.y);
    out = {away.x / distance, away.y / distance};
  }
  const double gap = distance - a.radius;
  if (gap > margin) return {};
  PlanarManifold manifold;
  manifold.normal = out;
  manifold.points[0] = {
      {b.center.x + nearest.x + 0.5 * gap * out.x, b.center.y + nearest.y + 0.5 * gap * out.y},
      gap};
  manifold.count = 1;
  return manifold;
}

PlanarManifold meet(const Polygon& a, const Disc& b, double margin) {
  return reversed(meet(b, a, margin));
}

PlanarManifold meet(const Disc& a, const Rectangle& b, double margin) {
  const Vector2 between{a.center.x - b.center.x, a.center.y - b.center.y};
  const Vector2 side = left_of(b.along);
  // In the rectangle's frame: the middle of the disc, and the nearest point of the rectangle.
  const Vector2 middle{dot(between, b.along), dot(between, side)};
  Vector2 nearest{std::clamp(middle.x, -b.half_length, b.half_length),
                  std::clamp(middle.y, -b.half_width, b.half_width)};
  Vector2 out{middle.x - nearest.x, middle.y - nearest.y};
  double distance = std::hypot(out.x, out.y);
  if (distance > 0.0) {
    out = {out.x / distance, out.y / distance};
  } else {
    const double to_front = b.half_length - std::abs(middle.x);
    const double to_flank = b.half_width - std::abs(middle.y);
    if (to_front < to_flank) {
      out = {std::copysign(1.0, middle.x), 0.0};
      nearest.x = out.x * b.half_length;
      distance = -to_front;
    } else {
      out = {0.0, std::copysign(1.0, middle.y)};
      nearest.y = out.y * b.half_width;
      distance = -to_flank;
    }
  }
  const double gap = distance - a.radius;
  if (gap > margin) return {};
  const Vector2 at{nearest.x + 0.5 * gap * out.x, nearest.y + 0.5 * gap * out.y};
  PlanarManifold manifold;
  manifold.normal = {out.x * b.along.x + out.y * side.x, out.x * b.along.y + out.y * side.y};
  manifold.points[0] = {{b.center.x + at.x * b.along.x + at.y * side.x,
                         b.center.y + at.x * b.along.y + at.y * side.y},
                        gap};
  manifold.count = 1;
  return manifold;
}

PlanarManifold meet(const Rectangle& a, const Disc& b, double margin) {
  return reversed(meet(b, a, margin));
}

PlanarManifold meet(const Disc& a, const Disc& b, double margin) {
  const Vector2 between{a.center.x - b.center.x, a.center.y - b.center.y};
  const double distance = std::hypot(between.x, between.y);
  const double gap = distance - a.radius - b.radius;
  if (gap > margin) return {};
  PlanarManifold manifold;
  manifold.normal =
      distance > 0.0 ? Vector2{between.x / distance, between.y / distance} : Vector2{1.0, 0.0};
  const double from_b = b.radius + 0.5 * gap;
  manifold.points[0] = {
      {b.center.x + from_b * manifold.normal.x, b.center.y + from_b * manifold.normal.y}, gap};
  manifold.count = 1;
  return manifold;
}

}  // namespace elsie::physics
