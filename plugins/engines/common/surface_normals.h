// The normals of bodies where rays enter them. Apart from the distances, which are the inner loop
// of every range sensor: only rays that ask for a surface come here.
//
// All functions may be asked only for rays that meet the body; a ray that misses it by rounding
// gets the normal of a surface that it nearly meets.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ray_tests.h"
#include "sensed_solid.h"

namespace elsie::physics {

/// The last surface that a ray crosses on its way into a convex body.
class Crossing {
 public:
  explicit Crossing(const Ray& ray) : ray_(ray) {}

  void cross(double at, const Vector3& normal) {
    if (at <= at_) return;
    at_ = at;
    normal_ = normal;
  }
  /// The two faces of a box across an axis.
  void cross_slab(const Vector3& axis, double half, const Vector3& from) {
    const double o = dot(axis, from), d = dot(axis, ray_.direction);
    if (d > 0.0) cross((-half - o) / d, -1.0 * axis);
    if (d < 0.0) cross((half - o) / d, axis);
  }
  /// The latest one's; against the ray if that starts within the body.
  Vector3 normal() const { return at_ < 0.0 ? -1.0 * ray_.direction : normal_; }

 private:
  const Ray& ray_;
  double at_ = -kMiss;
  Vector3 normal_;
};

inline Vector3 normal_of_box(const Ray& ray, const OrientedBox& box) {
  const Vector3 from = ray.origin - box.center;
  Crossing crossing(ray);
  crossing.cross_slab(box.axes[0], box.half.x, from);
  crossing.cross_slab(box.axes[1], box.half.y, from);
  crossing.cross_slab(box.axes[2], box.half.z, from);
  return crossing.normal();
}

inline Vector3 normal_of_prism(const Ray& ray, const OrientedBox& box, Corners outline) {
  const Vector3 from = ray.origin - box.center;
  const auto flat = [&](const Vector3& v) {
    return Vector2{dot(box.axes[0], v), dot(box.axes[1], v)};
  };
  Crossing crossing(ray);
  crossing.cross_slab(box.axes[2], box.half.z, from);
  const Vector2 origin = flat(from), direction = flat(ray.direction);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Side side = side_of(outline, i);
    const double speed = side.normal.x * direction.x + side.normal.y * direction.y;
    if (speed >= 0.0) continue;
    crossing.cross(-side.gap_to(origin) / speed,
                   side.normal.x * box.axes[0] + side.normal.y * box.axes[1]);
  }
  return crossing.normal();
}

/// Of a point at this vector from the middle of a ball or the axis of a cylinder.
inline Vector3 outwards(const Vector3& from) { return (1.0 / std::sqrt(dot(from, from))) * from; }

inline Vector3 normal_of_cylinder(const Ray& ray, const Cylinder& cylinder) {
  const Vector3 from = ray.origin - cylinder.center;
  Crossing crossing(ray);
  crossing.cross_slab(cylinder.axis, cylinder.half_length, from);
  // As in distance_to_cylinder().
  const Vector3 from_across = from - dot(cylinder.axis, from) * cylinder.axis;
  const Vector3 across = ray.direction - dot(cylinder.axis, ray.direction) * cylinder.axis;
  const double a = dot(across, across), b = dot(across, from_across);
  const double c = dot(from_across, from_across) - cylinder.radius * cylinder.radius;
  if (a >= 1e-24) {
    const double at = (-b - std::sqrt(std::max(0.0, b * b - a * c))) / a;
    crossing.cross(at, outwards(from_across + at * across));
  }
  return crossing.normal();
}

inline Vector3 normal_of_ball(const Ray& ray, const Vector3& center, double radius) {
  const Vector3 from = ray.origin - center;
  const double b = dot(ray.direction, from), c = dot(from, from) - radius * radius;
  if (c < 0.0) return -1.0 * ray.direction;
  const double at = -b - std::sqrt(std::max(0.0, b * b - c));
  return outwards(from + at * ray.direction);
}

inline Vector3 normal_of_capsule(const Ray& ray, const Cylinder& around) {
  // As in distance_to_capsule().
  Cylinder between = around;
  between.half_length = std::max(0.0, around.half_length - around.radius);
  const Vector3 away = between.half_length * around.axis;
  const Vector3 upper = around.center + away, lower = around.center - away;
  const double to_upper = distance_to_ball(ray, upper, around.radius);
  const double to_lower = distance_to_ball(ray, lower, around.radius);
  const double ends = std::min(to_upper, to_lower);
  if (between.half_length > 0.0 && distance_to_cylinder(ray, between) < ends) {
    return normal_of_cylinder(ray, between);
  }
  return normal_of_ball(ray, to_upper <= to_lower ? upper : lower, around.radius);
}

/// The normal where the ray enters the solid: a unit vector.
inline Vector3 normal_of(const Ray& ray, const SensedSolid& solid) {
  switch (solid.kind) {
    case Shape::Kind::box:
      return normal_of_box(ray, solid.box);
    case Shape::Kind::prism:
      return normal_of_prism(ray, solid.box, solid.outline);
    case Shape::Kind::cylinder:
      return normal_of_cylinder(ray, solid.round);
    default:
      return normal_of_capsule(ray, solid.round);
  }
}

/// The same for a chassis with wheels, as distance_to() meets them.
inline Vector3 normal_of(const Ray& ray, const SensedSolid& chassis,
                         const std::vector<Cylinder>& wheels, double wheels_top) {
  const Cylinder* met = nullptr;
  if (ray.direction.z < 0.0 || ray.origin.z <= wheels_top) {
    double nearest = distance_to(ray, chassis);
    for (const Cylinder& wheel : wheels) {
      const double distance = distance_to_cylinder(ray, wheel);
      if (distance >= nearest) continue;
      nearest = distance;
      met = &wheel;
    }
  }
  return met ? normal_of_cylinder(ray, *met) : normal_of(ray, chassis);
}

}  // namespace elsie::physics
