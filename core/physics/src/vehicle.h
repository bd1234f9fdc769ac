// What collision detection knows of the things in the world.
#pragma once

#include <array>

#include "ode_handles.h"
#include "shapes.h"

namespace elsie::physics {

enum class SolidKind { box, wheel };

/// One convex part of a body. Of a wheel `shape` is the box around it, with the axle along its
/// second axis.
struct Solid {
  dBodyID body = nullptr;  // none: it stands fast
  dGeomID geom = nullptr;
  SolidKind kind = SolidKind::box;
  OrientedBox shape;
};

/// A robot or a segment: a box on two wheels, and perhaps casters below the box.
struct Vehicle {
  Solid box;
  std::array<Solid, 2> wheels;
  /// Whether the wheels are within the outline of the box, so that what is higher than the bottom
  /// of the box meets it before them.
  bool wheels_in_box = false;
  std::array<Solid, 2> casters;
  std::size_t caster_count = 0;
};

}  // namespace elsie::physics
