// Intersections of rays with bodies. Inline: they are the inner loop of every range sensor.
//
// A body is met where the ray enters it; a ray that starts inside meets it at distance 0. Surfaces
// belong to the body.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "outlines.h"
#include "shapes.h"

namespace elsie::physics {

inline constexpr double kMiss = std::numeric_limits<double>::infinity();

struct Ray {
  Vector3 origin;
  Vector3 direction;  // unit vector
  Vector3 inverse;    // 1 / direction, infinite where that is zero

  Ray(const Vector3& from, const Vector3& along)
      : origin(from), direction(along), inverse{1.0 / along.x, 1.0 / along.y, 1.0 / along.z} {}
};

/// True if the ray passes through the bounds within `range`. Bounds are a little larger than the
/// body, so that rounding never hides it.
inline bool meets_bounds(const Ray& ray, const Aabb& box, double range) {
  double enter = 0.0, leave = range;
  const auto clip = [&](double lower, double upper, double origin, double inverse) {
    const double a = (lower - origin) * inverse, b = (upper - origin) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  clip(box.lower.x, box.upper.x, ray.origin.x, ray.inverse.x);
  clip(box.lower.y, box.upper.y, ray.origin.y, ray.inverse.y);
  clip(box.lower.z, box.upper.z, ray.origin.z, ray.inverse.z);
  return enter <= leave;
}

/// Distance at which the ray enters the box (slab method, Kay and Kajiya 1986), or kMiss.
inline double distance_to_box(const Ray& ray, const OrientedBox& box) {
  const Vector3 from = ray.origin - box.center;
  double enter = 0.0, leave = kMiss;
  const auto clip = [&](const Vector3& axis, double half) {
    const double o = dot(axis, from), d = dot(axis, ray.direction);
    if (d == 0.0) return std::abs(o) <= half;
    const double a = (-half - o) / d, b = (half - o) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
    return enter <= leave;
  };
  const bool hit = clip(box.axes[0], box.half.x) && clip(box.axes[1], box.half.y) &&
                   clip(box.axes[2], box.half.z);
  return hit ? enter : kMiss;
}

/// Distance at which the ray enters the cylinder, or kMiss.
inline double distance_to_cylinder(const Ray& ray, const Cylinder& cylinder) {
  const Vector3 from = ray.origin - cylinder.center;
  const double o = dot(cylinder.axis, from), d = dot(cylinder.axis, ray.direction);
  double enter = 0.0, leave = kMiss;
  if (d == 0.0) {
    if (std::abs(o) > cylinder.half_length) return kMiss;
  } else {
    const double a = (-cylinder.half_length - o) / d, b = (cylinder.half_length - o) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::max(a, b);
  }
  // Across the axis: |from + t direction|^2 = radius^2.
  const Vector3 from_across = from - o * cylinder.axis;
  const Vector3 across = ray.direction - d * cylinder.axis;
  const double a = dot(across, across);
  const double b = dot(across, from_across);
  const double c = dot(from_across, from_across) - cylinder.radius * cylinder.radius;
  if (a < 1e-24) {
    if (c > 0.0) return kMiss;
  } else {
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) return kMiss;
    const double root = std::sqrt(discriminant);
    enter = std::max(enter, (-b - root) / a);
    leave = std::min(leave, (-b + root) / a);
  }
  return enter <= leave ? enter : kMiss;
}

/// Distance at which the ray enters the prism in this box, whose outline is in the box's frame, or
/// kMiss.
inline double distance_to_prism(const Ray& ray, const OrientedBox& box, Corners outline) {
  const Vector3 from = ray.origin - box.center;
  const auto along = [&](std::size_t axis, const Vector3& v) { return dot(box.axes[axis], v); };
  const double o = along(2, from), d = along(2, ray.direction);
  double enter = 0.0, leave = kMiss;
  if (d == 0.0) {
    if (std::abs(o) > box.half.z) return kMiss;
  } else {
    const double a = (-box.half.z - o) / d, b = (box.half.z - o) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::max(a, b);
  }
  const bool hit = clip_ray(outline, {along(0, from), along(1, from)},
                            {along(0, ray.direction), along(1, ray.direction)}, enter, leave);
  return hit && enter <= leave ? enter : kMiss;
}

/// Distance at which the ray enters the ball, or kMiss.
inline double distance_to_ball(const Ray& ray, const Vector3& center, double radius) {
  const Vector3 from = ray.origin - center;
  const double b = dot(ray.direction, from), c = dot(from, from) - radius * radius;
  if (c <= 0.0) return 0.0;
  const double discriminant = b * b - c;
  return b > 0.0 || discriminant < 0.0 ? kMiss : std::max(0.0, -b - std::sqrt(discriminant));
}

/// Distance at which the ray enters the capsule within this cylinder, or kMiss. If the cylinder is
/// as long as it is wide, the capsule is a ball.
inline double distance_to_capsule(const Ray& ray, const Cylinder& around) {
  Cylinder between = around;  // the two balls
  between.half_length = std::max(0.0, around.half_length - around.radius);
  const Vector3 away = between.half_length * around.axis;
  const double ends = std::min(distance_to_ball(ray, around.center + away, around.radius),
                               distance_to_ball(ray, around.center - away, around.radius));
  return between.half_length > 0.0 ? std::min(ends, distance_to_cylinder(ray, between)) : ends;
}

}  // namespace elsie::physics
