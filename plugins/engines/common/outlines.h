// What meets the convex outlines of upright prisms. Lengths in m.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "elsie/shapes/outline.h"

namespace elsie::physics {

/// A side of an outline.
struct Side {
  Vector2 from;
  Vector2 to;
  Vector2 normal;       // unit vector, outwards
  double length = 0.0;  // m

  /// How far in front of the side a point is; negative behind it.
  double gap_to(const Vector2& point) const {
    return normal.x * (point.x - from.x) + normal.y * (point.y - from.y);
  }
  Vector2 nearest_to(const Vector2& point) const {
    const double ahead = normal.x * (point.y - from.y) - normal.y * (point.x - from.x);
    const double part = std::clamp(ahead / length, 0.0, 1.0);
    return {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
  }
};

inline Side side_of(Corners corners, std::size_t i) {
  const Vector2 &from = corners[i], &to = corners[i + 1 < corners.size() ? i + 1 : 0];
  const double x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
  return {from, to, {y / length, -x / length}, length};
}

/// The side in front of which a point is farthest or, inside, behind which it is least deep.
inline Side nearest_side(Corners corners, const Vector2& point) {
  Side nearest = side_of(corners, 0);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Side side = side_of(corners, i);
    if (side.gap_to(point) > nearest.gap_to(point)) nearest = side;
  }
  return nearest;
}

/// The point of an outline that is nearest to a point outside of it.
inline Vector2 nearest_point(Corners corners, const Vector2& point) {
  Vector2 nearest = corners[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 there = side_of(corners, i).nearest_to(point);
    const double away = std::hypot(there.x - point.x, there.y - point.y);
    if (away < least) {
      least = away;
      nearest = there;
    }
  }
  return nearest;
}

/// The distance of a point from an outline; negative inside.
inline double distance_to(Corners corners, const Vector2& point) {
  const double gap = nearest_side(corners, point).gap_to(point);
  if (gap <= 0.0) return gap;
  const Vector2 nearest = nearest_point(corners, point);
  return std::hypot(nearest.x - point.x, nearest.y - point.y);
}

/// Narrows [enter, leave], places along a ray, to those within the outline. Returns whether any
/// remain. `direction` may have any length.
inline bool clip_ray(Corners corners, const Vector2& origin, const Vector2& direction,
                     double& enter, double& leave) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Side side = side_of(corners, i);
    const double gap = side.gap_to(origin);
    const double speed = side.normal.x * direction.x + side.normal.y * direction.y;
    if (speed == 0.0) {
      if (gap > 0.0) return false;
    } else if (speed < 0.0) {
      enter = std::max(enter, -gap / speed);
    } else {
      leave = std::min(leave, -gap / speed);
    }
    if (enter > leave) return false;
  }
  return true;
}

}  // namespace elsie::physics
