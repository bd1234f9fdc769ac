#include "pyramid_test.h"

#include <algorithm>
#include <cmath>

namespace elsie::physics {
namespace {

Vector3 normalized(const Vector3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0.0 ? (1.0 / length) * v : v;
}

}  // namespace

PyramidTest::PyramidTest(const Pyramid& pyramid) {
  const Frame& frame = pyramid.frame;
  const double across = std::tan(0.5 * pyramid.horizontal_fov_rad);
  const double upward = std::tan(0.5 * pyramid.vertical_fov_rad);
  // Directions to the corners, round the axis.
  const std::array<Vector3, 4> corners{
      frame.direction({1.0, across, upward}), frame.direction({1.0, -across, upward}),
      frame.direction({1.0, -across, -upward}), frame.direction({1.0, across, -upward})};
  points_[0] = frame.origin;
  for (std::size_t i = 0; i < 4; ++i) {
    points_[i + 1] = frame.origin + pyramid.range_m * corners[i];
    normals_[i] = normalized(cross(corners[i], corners[(i + 1) % 4]));
    edges_[i] = normalized(corners[i]);
  }
  normals_[4] = frame.forward;
  edges_[4] = frame.left;
  edges_[5] = frame.up;

  bounds_ = {points_[0], points_[0]};
  for (const Vector3& p : points_) {
    bounds_.lower = {std::min(bounds_.lower.x, p.x), std::min(bounds_.lower.y, p.y),
                     std::min(bounds_.lower.z, p.z)};
    bounds_.upper = {std::max(bounds_.upper.x, p.x), std::max(bounds_.upper.y, p.y),
                     std::max(bounds_.upper.z, p.z)};
  }
}

bool PyramidTest::separated_along(const Vector3& axis, const OrientedBox& box) const {
  double least = dot(axis, points_[0] - box.center), most = least;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double along = dot(axis, points_[i] - box.center);
    least = std::min(least, along);
    most = std::max(most, along);
  }
  const double extent = box.half.x * std::abs(dot(axis, box.axes[0])) +
                        box.half.y * std::abs(dot(axis, box.axes[1])) +
                        box.half.z * std::abs(dot(axis, box.axes[2]));
  return least > extent || most < -extent;
}

bool PyramidTest::meets(const OrientedBox& box) const {
  for (const Vector3& normal : normals_) {
    if (separated_along(normal, box)) return false;
  }
  for (const Vector3& axis : box.axes) {
    if (separated_along(axis, box)) return false;
  }
  for (const Vector3& edge : edges_) {
    for (const Vector3& axis : box.axes) {
      const Vector3 both = cross(edge, axis);
      // Parallel edges span no plane; the faces have been tried.
      if (dot(both, both) > 1e-12 && separated_along(both, box)) return false;
    }
  }
  return true;
}

}  // namespace elsie::physics
