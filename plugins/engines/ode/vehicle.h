// A vehicle as collision detection and sensors see it.
#pragma once

#include <cstddef>
#include <vector>

#include "ode_handles.h"
#include "scene.h"
#include "shapes.h"

namespace elsie::physics {

/// A wheel is a cylinder on its side, a pillar one that stands upright.
enum class SolidKind { box, wheel, pillar, ball, capsule };

/// One convex part of a body. `shape` is the box around it; of a wheel the axle lies along its
/// second axis, and that of a ball stands upright however the ball is turned.
struct Solid {
  dBodyID body = nullptr;  // none: it stands fast
  dGeomID geom = nullptr;
  SolidKind kind = SolidKind::box;
  OrientedBox shape;
};

/// A chassis on wheels, and perhaps casters below the chassis.
struct Vehicle {
  Solid chassis;
  std::vector<Solid> wheels;
  /// Whether the wheels are within the outline of the chassis, so that what is higher than its
  /// bottom meets it before them.
  bool wheels_inside = false;
  std::vector<Solid> casters;
};

/// Sensors at the top of the chassis look level over it. So that robots of one size see each other,
/// range sensors see a chassis that is flat on top higher by what a sensor on it would stand out.
inline constexpr double kSensorDeck = 0.02;  // m

/// How a vehicle moves.
struct VehicleMotion {
  Frame frame;       // origin on the floor side
  Vector3 velocity;  // m/s, of the middle of the chassis
  Vector3 turning;   // rad/s
};

/// Puts a vehicle where it is, for sensors and neighbours: a chassis of this shape with its middle
/// there, and wheels. It may come as far as its speed carries it in a step.
void place_vehicle(Scene& scene, Scene::Id id, const Shape& shape, const Vector3& middle,
                   const std::vector<Cylinder>& wheels, const VehicleMotion& motion, double step);

}  // namespace elsie::physics
