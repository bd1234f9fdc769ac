// Robots and segments as collision detection and sensors see them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "ode_handles.h"
#include "scene.h"
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

inline Solid wheel_solid(dBodyID body, dGeomID geom, const Cylinder& wheel,
                         const OrientedBox& box) {
  return {body,
          geom,
          SolidKind::wheel,
          {wheel.center, box.axes, {wheel.radius, wheel.half_length, wheel.radius}}};
}

/// Reads where ODE has the box of a robot or a segment, whose wheels follow from that.
template <class Dimensions, class State>
void read_shape(dBodyID body, const Dimensions& d, State& state, OrientedBox& box,
                std::array<Cylinder, 2>& wheels) {
  const dReal* r = dBodyGetRotation(body);
  const Vector3 center = to_vector(dBodyGetPosition(body));
  Frame& frame = state.frame;
  frame.forward = {r[0], r[4], r[8]};
  frame.left = {r[1], r[5], r[9]};
  frame.up = {r[2], r[6], r[10]};
  frame.origin = center - (d.clearance + 0.5 * d.height) * frame.up;
  state.pose = {frame.origin.x, frame.origin.y, std::atan2(frame.forward.y, frame.forward.x)};
  box = {center,
         {frame.forward, frame.left, frame.up},
         {0.5 * d.length, 0.5 * d.width, 0.5 * d.height}};
  for (std::size_t i = 0; i < 2; ++i) {
    wheels[i] = {frame.point({0.0, (i == 0 ? 1.0 : -1.0) * d.half_axle(), d.wheel_radius}),
                 frame.left, d.wheel_radius, 0.5 * d.wheel_width};
  }
}

/// Sensors at the top of the chassis look level over it. So that robots of one size see each other,
/// range sensors see a chassis that is higher by what a sensor on it would stand out.
inline constexpr double kSensorDeck = 0.02;  // m

/// A box on two wheels, and how it moves.
struct MovingVehicle {
  const Frame& frame;
  const OrientedBox& box;
  const std::array<Cylinder, 2>& wheels;
  const Vector3& velocity;  // of the box's middle
  const Vector3& turning;
};

/// Puts it where it is, for sensors and neighbours; it may come as far as its speed carries it.
void place_vehicle(Scene& scene, Scene::Id id, const MovingVehicle& vehicle, double step);

}  // namespace elsie::physics
