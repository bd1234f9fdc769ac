// A vehicle as collision detection and sensors see it.
#pragma once

#include <cstddef>
#include <vector>

#include "ode_handles.h"
#include "outlines.h"
#include "scene.h"
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

/// How a vehicle moves.
struct VehicleMotion {
  Frame frame;       // origin on the floor side
  Vector3 velocity;  // m/s, of the middle of the chassis
  Vector3 turning;   // rad/s
};

/// Puts a vehicle into the scene, for sensors and neighbours: a chassis of this shape with its
/// middle there, and wheels. Its reach is how far its speed carries it in a step. See
/// Scene::place_robot().
bool place_vehicle(Scene& scene, Scene::Id id, const Shape& shape, const Vector3& middle,
                   const std::vector<Cylinder>& wheels, const VehicleMotion& motion, double step);

}  // namespace elsie::physics
