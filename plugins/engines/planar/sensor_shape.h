// Bodies as range sensors see them.
#pragma once

#include <span>
#include <vector>

#include "elsie/api/body.h"

#include "sensed_solid.h"

namespace elsie::physics {

/// A body as range sensors see it, in its own upright frame.
struct SensorShape {
  SensedSolid solid;  // with the sensor deck
  std::vector<Cylinder> wheels;
  double wheels_top = 0.0;  // m
  double reach = 0.0;       // m, from above: the radius of the circle around it

  /// `vehicle`: a chassis and the parts below it.
  static SensorShape of(std::span<const Part> vehicle);
  /// An obstacle, charger or wall.
  static SensorShape of(const Shape& shape, double bottom);
};

}  // namespace elsie::physics
