// Contacts of two upright prisms or cylinders, also across a gap.
//
// Nearly everything in a world stands upright: walls, boxes, and the chassis and wheels of a robot.
// Two such bodies meet in the plane. Unlike a collider for boxes in space, this one also finds
// contacts across a gap, so bodies can be stopped at the surface instead of behind it. It never
// mistakes the top of a low box for its side.
#pragma once

#include <array>
#include <vector>

#include "outlines.h"
#include "shapes.h"

namespace elsie::physics {

/// A rectangle seen from above.
struct Rectangle {
  Vector2 center;
  Vector2 along;  // unit vector; the other edge is to its left
  double half_length = 0.0;
  double half_width = 0.0;
};

/// An upright cylinder seen from above.
struct Disc {
  Vector2 center;
  double radius = 0.0;
};

/// The outline of an upright prism seen from above, turned as the prism is.
struct Polygon {
  static constexpr std::size_t kMost = 16;

  Vector2 center;
  std::array<Vector2, kMost> corners{};  // from the middle, counter-clockwise
  std::size_t count = 0;

  Corners outline() const { return {corners.data(), count}; }
};

Polygon polygon_of(const Rectangle& rectangle);
/// A regular polygon within a disc.
Polygon polygon_of(const Disc& disc);
inline const Polygon& polygon_of(const Polygon& polygon) { return polygon; }

/// The corners of the area that two polygons have in common, counter-clockwise (Sutherland and
/// Hodgman 1974); empty if there is none.
std::vector<Vector2> common_area(const Polygon& a, const Polygon& b);

struct PlanarContact {
  Vector2 point;
  double gap = 0.0;  // m, negative where they overlap
};

/// Up to two points at which rectangles and polygons meet; discs meet anything at one.
struct PlanarManifold {
  Vector2 normal;  // unit vector, from b into a
  std::array<PlanarContact, 2> points;
  int count = 0;
};

/// Points of contact with a gap of at most `margin` m (separating axes, then clipping of the facing
/// edges).
PlanarManifold meet(const Rectangle& a, const Rectangle& b, double margin);
PlanarManifold meet(const Polygon& a, const Polygon& b, double margin);
PlanarManifold meet(const Rectangle& a, const Polygon& b, double margin);
PlanarManifold meet(const Polygon& a, const Rectangle& b, double margin);
/// The same for the nearest points of a disc and another shape. A disc whose middle is inside the
/// shape is pushed out through the nearest face.
PlanarManifold meet(const Disc& a, const Rectangle& b, double margin);
PlanarManifold meet(const Rectangle& a, const Disc& b, double margin);
PlanarManifold meet(const Disc& a, const Disc& b, double margin);
PlanarManifold meet(const Disc& a, const Polygon& b, double margin);
PlanarManifold meet(const Polygon& a, const Disc& b, double margin);

}  // namespace elsie::physics
