// Solids, and a vehicle of them, as collision detection sees it.
#pragma once

#include <cstddef>
#include <vector>

#include "ode_handles.h"
#include "outlines.h"
#include "shapes.h"

namespace elsie::physics {

/// How collision detection treats a shape: kind_of(). A wheel is a cylinder on its side, a pillar
/// an upright one.
enum class SolidKind { box, wheel, pillar, ball, capsule, prism };

/// One convex part of a body. `shape` is its bounding box. The axle of a wheel lies along the
/// second axis; the box of a ball stays upright however the ball turns.
struct Solid {
  dBodyID body = nullptr;  // null: a fixed body
  dGeomID geom = nullptr;
  SolidKind kind = SolidKind::box;
  OrientedBox shape;
  Corners outline{};  // of a prism, in its frame
};

/// A chassis on wheels, perhaps with casters below it.
struct Vehicle {
  Solid chassis;
  std::vector<Solid> wheels;
  /// True if the wheels are within the outline of the chassis, so that anything higher than its
  /// bottom meets it before them.
  bool wheels_inside = false;
  std::vector<Solid> casters;
};

}  // namespace elsie::physics
