// How a robot or a segment enters the scene.
#pragma once

#include <array>

#include "scene.h"
#include "shapes.h"

namespace elsie::physics {

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
