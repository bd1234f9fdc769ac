// Tests whether a body reaches into the volume of a proximity sensor.
#pragma once

#include <array>

#include "elsie/api/sensor.h"

#include "outlines.h"
#include "shapes.h"

namespace elsie::physics {

/// A sensor's pyramid ready to be tested against many boxes: the sensor's base point and the four
/// corner points of its far face, which lies at distance `range_m` along the axis.
class PyramidTest {
 public:
  explicit PyramidTest(const Pyramid& pyramid);

  const Aabb& bounds() const { return bounds_; }
  /// Exact test by separating axes (Gottschalk, Lin and Manocha 1996). Touching counts.
  bool meets(const OrientedBox& box) const;
  /// Exact as well: the part of the pyramid between the planes of the cylinder's ends is a convex
  /// polygon when seen along the axis, and the cylinder is a disc.
  bool meets(const Cylinder& cylinder) const;
  /// The same for a prism in this box, whose outline is in the box's frame.
  bool meets(const OrientedBox& box, Corners outline) const;

 private:
  /// The part within this height above and below the middle of a frame, seen along its third axis.
  class Shadow shadow(const Vector3& center, const std::array<Vector3, 3>& axes,
                      double half_height) const;
  bool separated_along(const Vector3& axis, const OrientedBox& box) const;

  std::array<Vector3, 5> points_;
  std::array<Vector3, 5> normals_;
  std::array<Vector3, 6> edges_;
  Aabb bounds_;
};

}  // namespace elsie::physics
