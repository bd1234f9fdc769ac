// The shapes of bodies as queries and collision detection see them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "elsie/api/geometry.h"

namespace elsie::physics {

/// Sensors on top of a chassis look level over it. So that robots of one size see each other, range
/// sensors see a flat-topped chassis as higher by the height of such a sensor.
inline constexpr double kSensorDeck = 0.02;  // m

inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct OrientedBox {
  Vector3 center;
  std::array<Vector3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // unit vectors
  Vector3 half;                                                    // half edge lengths along axes
};

struct Cylinder {
  Vector3 center;
  Vector3 axis;  // unit vector
  double radius = 0.0;
  double half_length = 0.0;
};

/// The box around a wheel whose axle is level in the frame with this upward direction.
inline OrientedBox box_around(const Cylinder& wheel, const Vector3& up) {
  return {wheel.center,
          {cross(wheel.axis, up), wheel.axis, up},
          {wheel.radius, wheel.half_length, wheel.radius}};
}

struct Aabb {
  Vector3 lower;
  Vector3 upper;

  bool overlaps(const Aabb& other, double margin) const {
    return lower.x <= other.upper.x + margin && other.lower.x <= upper.x + margin &&
           lower.y <= other.upper.y + margin && other.lower.y <= upper.y + margin &&
           lower.z <= other.upper.z + margin && other.lower.z <= upper.z + margin;
  }
  Aabb grown(double by) const {
    return {{lower.x - by, lower.y - by, lower.z - by}, {upper.x + by, upper.y + by, upper.z + by}};
  }
};

inline Aabb bounds(const OrientedBox& box) {
  const auto& [a, b, c] = box.axes;
  const Vector3& h = box.half;
  const Vector3 e{std::abs(a.x) * h.x + std::abs(b.x) * h.y + std::abs(c.x) * h.z,
                  std::abs(a.y) * h.x + std::abs(b.y) * h.y + std::abs(c.y) * h.z,
                  std::abs(a.z) * h.x + std::abs(b.z) * h.y + std::abs(c.z) * h.z};
  return {box.center - e, box.center + e};
}

inline Aabb bounds(const Cylinder& cylinder) {
  const auto extent = [&](double along) {
    return std::abs(along) * cylinder.half_length +
           std::sqrt(std::max(0.0, 1.0 - along * along)) * cylinder.radius;
  };
  const Vector3& axis = cylinder.axis;
  const Vector3 e{extent(axis.x), extent(axis.y), extent(axis.z)};
  return {cylinder.center - e, cylinder.center + e};
}

}  // namespace elsie::physics
