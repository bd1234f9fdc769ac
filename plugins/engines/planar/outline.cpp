#include "outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace elsie::physics {
namespace {

// An edge of the second outline is preferred only if it separates the outlines better by this much.
constexpr double kPreference = 1e-6;  // m

Vector2 along(const Vector2& a, double s, const Vector2& v) {
  return {a.x + s * v.x, a.y + s * v.y};
}
double dot(const Vector2& a, const Vector2& b) { return a.x * b.x + a.y * b.y; }

// The quick test accepts outlines that are too far apart by this little.
constexpr double kRounding = 1e-9;  // m

struct Axis {
  double separation = -std::numeric_limits<double>::infinity();
  std::size_t edge = 0;
  Vector2 normal;
};

/// The edge of `a` beyond which `b` is the furthest, or the first edge beyond which `b` is further
/// than `reach`.
Axis best_axis(const PlacedOutline& a, std::span<const Vector2> b, double reach) {
  Axis best;
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    const Vector2& normal = a.normals[i];
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector2& corner : b) nearest = std::min(nearest, dot(normal, corner));
    nearest -= dot(normal, a.corners[i]);
    if (nearest > best.separation) best = {nearest, i, normal};
    if (nearest > reach) break;
  }
  return best;
}

std::uint32_t feature_of(std::size_t a, std::size_t b, bool of_second) {
  return static_cast<std::uint32_t>(a) << 16 | static_cast<std::uint32_t>(b) << 1 |
         static_cast<std::uint32_t>(of_second);
}

/// Where two points with a radius each meet; the normal is `otherwise` if they coincide.
Meeting meet_points(const Vector2& a, double radius_a, const Vector2& b, double radius_b,
                    const Vector2& otherwise, double margin, std::uint32_t feature) {
  Meeting met;
  const Vector2 from_b = minus(a, b);
  const double distance = std::sqrt(dot(from_b, from_b));
  const double gap = distance - radius_a - radius_b;
  if (gap > margin) return met;
  met.normal = distance > 0.0 ? Vector2{from_b.x / distance, from_b.y / distance} : otherwise;
  met.points[0] = {along(b, radius_b + 0.5 * gap, met.normal), gap, feature};
  met.count = 1;
  return met;
}

/// The point of an edge that is nearest to a place, as a part of its length.
double part_nearest(const Vector2& from, const Vector2& to, const Vector2& place) {
  const Vector2 edge = minus(to, from);
  return std::clamp(dot(minus(place, from), edge) / dot(edge, edge), 0.0, 1.0);
}

/// A polygon and a disc around `point`.
Meeting meet_disc(const PlacedOutline& polygon, const Vector2& point, double radius,
                  double margin) {
  const auto& corners = polygon.corners;
  const double reach = margin + polygon.radius + radius;
  const Axis axis = best_axis(polygon, {&point, 1}, reach);
  if (axis.separation > reach) return {};
  const Vector2& from = corners[axis.edge];
  const Vector2& to = corners[(axis.edge + 1) % corners.size()];
  const double part = part_nearest(from, to, point);
  const Vector2 on_edge = along(from, part, minus(to, from));
  const auto edge = static_cast<std::uint32_t>(axis.edge);
  if (axis.separation > 0.0 && (part <= 0.0 || part >= 1.0)) {
    return meet_points(on_edge, polygon.radius, point, radius, {}, margin, edge);
  }
  Meeting met;
  const double gap = axis.separation - polygon.radius - radius;
  met.normal = {-axis.normal.x, -axis.normal.y};
  met.points[0] = {along(point, -(radius + 0.5 * gap), axis.normal), gap, edge};
  met.count = 1;
  return met;
}

/// Where two segments are nearest to each other; they do not cross.
Meeting meet_edges(const Vector2& a, const Vector2& to_a, double radius_a, const Vector2& b,
                   const Vector2& to_b, double radius_b, double margin, std::uint32_t feature) {
  Meeting best;
  const auto consider = [&](const Vector2& on_a, const Vector2& on_b) {
    const Meeting met = meet_points(on_a, radius_a, on_b, radius_b, {1.0, 0.0}, margin, feature);
    if (met.count > 0 && (best.count == 0 || met.points[0].gap < best.points[0].gap)) best = met;
  };
  for (const Vector2& end : {a, to_a}) {
    consider(end, along(b, part_nearest(b, to_b, end), minus(to_b, b)));
  }
  for (const Vector2& end : {b, to_b}) {
    consider(along(a, part_nearest(a, to_a, end), minus(to_a, a)), end);
  }
  return best;
}

/// Two polygons; the edge of `a` with this axis is the one nearest to `b`. Normals point out of a.
Meeting clip(const PlacedOutline& a, const Axis& axis, const PlacedOutline& b, double margin,
             bool swapped) {
  const auto &ca = a.corners, &cb = b.corners;
  std::size_t facing = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cb.size(); ++i) {
    const double against = dot(b.normals[i], axis.normal);
    if (against < least) {
      least = against;
      facing = i;
    }
  }
  const std::size_t after = (facing + 1) % cb.size();
  const Vector2 from = ca[axis.edge], to = ca[(axis.edge + 1) % ca.size()];
  const Vector2 tangent{-axis.normal.y, axis.normal.x};  // from `from` to `to`
  const double length = dot(tangent, minus(to, from));
  // The facing edge, clipped to the ends of the edge.
  struct End {
    Vector2 at;
    std::size_t corner;
  };
  std::array<End, 2> ends{{{cb[facing], facing}, {cb[after], after}}};
  const double first = dot(tangent, minus(ends[0].at, from));
  const double second = dot(tangent, minus(ends[1].at, from));
  const Vector2 whole = minus(ends[1].at, ends[0].at);
  const bool passes = std::max(first, second) < 0.0 || std::min(first, second) > length;
  if (passes) {
    if (axis.separation <= 0.0 && ca.size() > 2 && cb.size() > 2) {  // rounding
      ends[1] = ends[0];
    } else {
      Meeting met = meet_edges(from, to, a.radius, ends[0].at, ends[1].at, b.radius, margin,
                               feature_of(axis.edge, facing, swapped));
      met.normal = {-met.normal.x, -met.normal.y};
      return met;
    }
  } else if (first != second) {
    const auto cut = [&](double place) {
      return along(ends[0].at, (std::clamp(place, 0.0, length) - first) / (second - first), whole);
    };
    const Vector2 cut_first = cut(first), cut_second = cut(second);
    ends[0].at = cut_first;
    ends[1].at = cut_second;
  }
  Meeting met;
  met.normal = axis.normal;
  for (const End& end : ends) {
    const double gap = dot(axis.normal, minus(end.at, from)) - a.radius - b.radius;
    if (gap > margin) continue;
    met.points[met.count++] = {along(end.at, -(b.radius + 0.5 * gap), axis.normal), gap,
                               feature_of(axis.edge, end.corner, swapped)};
  }
  return met;
}

}  // namespace

Outline Outline::polygon(std::vector<Vector2> corners, double radius, double bottom, double top) {
  Outline made{std::move(corners), {}, radius, bottom, top, 0.0, {}};
  const std::size_t count = made.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2& corner = made.corners[i];
    made.reach = std::max(made.reach, std::hypot(corner.x, corner.y) + radius);
    made.half.x = std::max(made.half.x, std::abs(corner.x) + radius);
    made.half.y = std::max(made.half.y, std::abs(corner.y) + radius);
    if (count == 1) break;
    const Vector2 edge = minus(made.corners[(i + 1) % count], corner);
    const double length = std::sqrt(dot(edge, edge));
    made.normals.push_back({edge.y / length, -edge.x / length});
  }
  return made;
}

Outline Outline::rectangle(double half_length, double half_width, double bottom, double top) {
  return polygon({{half_length, -half_width},
                  {half_length, half_width},
                  {-half_length, half_width},
                  {-half_length, -half_width}},
                 0.0, bottom, top);
}

Outline Outline::disc(double radius, double bottom, double top) {
  return polygon({{0.0, 0.0}}, radius, bottom, top);
}

Outline Outline::of(const Shape& shape, double height) {
  const Vector3& size = shape.size;
  const double bottom = height - 0.5 * size.z, top = height + 0.5 * size.z;
  if (shape.kind == Shape::Kind::prism) return polygon(shape.outline, 0.0, bottom, top);
  if (shape.is_round()) return disc(shape.radius(), bottom, top);
  if (shape.kind != Shape::Kind::capsule) {
    return rectangle(0.5 * size.x, 0.5 * size.y, bottom, top);
  }
  const double half = 0.5 * shape.length() - shape.radius();
  if (half <= 0.0) return disc(shape.radius(), bottom, top);
  const Vector2 end = shape.axis == Shape::Axis::forward ? Vector2{half, 0.0} : Vector2{0.0, half};
  return polygon({end, {-end.x, -end.y}}, shape.radius(), bottom, top);
}

bool may_meet(const Outline& a, const Direction& ahead_a, const Outline& b,
              const Direction& ahead_b, const Vector2& away, double margin) {
  const double c = std::abs(ahead_a.c * ahead_b.c + ahead_a.s * ahead_b.s);
  const double s = std::abs(ahead_a.c * ahead_b.s - ahead_a.s * ahead_b.c);
  const double wide = margin + kRounding;
  const Vector2 of_a = ahead_a.turn_back(away), of_b = ahead_b.turn_back(away);
  return std::abs(of_a.x) <= a.half.x + c * b.half.x + s * b.half.y + wide &&
         std::abs(of_a.y) <= a.half.y + s * b.half.x + c * b.half.y + wide &&
         std::abs(of_b.x) <= b.half.x + c * a.half.x + s * a.half.y + wide &&
         std::abs(of_b.y) <= b.half.y + s * a.half.x + c * a.half.y + wide;
}

PlacedOutline placed(const Outline& outline, const Vector2& middle, const Direction& ahead,
                     std::vector<Vector2>& space) {
  space.clear();
  for (const Vector2& corner : outline.corners) space.push_back(plus(middle, ahead.turn(corner)));
  for (const Vector2& normal : outline.normals) space.push_back(ahead.turn(normal));
  const std::span<const Vector2> all(space);
  const std::size_t count = outline.corners.size();
  return {all.first(count), all.subspan(count), outline.radius};
}

Meeting meet(const PlacedOutline& a, const PlacedOutline& b, double margin) {
  if (a.corners.size() == 1 && b.corners.size() == 1) {
    return meet_points(a.corners[0], a.radius, b.corners[0], b.radius, {1.0, 0.0}, margin, 0);
  }
  if (b.corners.size() == 1) return meet_disc(a, b.corners[0], b.radius, margin);
  if (a.corners.size() == 1) {
    Meeting met = meet_disc(b, a.corners[0], a.radius, margin);
    met.normal = {-met.normal.x, -met.normal.y};
    return met;
  }
  const double reach = margin + a.radius + b.radius;
  const Axis of_a = best_axis(a, b.corners, reach);
  if (of_a.separation > reach) return {};
  const Axis of_b = best_axis(b, a.corners, reach);
  if (of_b.separation > reach) return {};
  if (of_b.separation > of_a.separation + kPreference) return clip(b, of_b, a, margin, true);
  Meeting met = clip(a, of_a, b, margin, false);
  met.normal = {-met.normal.x, -met.normal.y};
  return met;
}

}  // namespace elsie::physics
