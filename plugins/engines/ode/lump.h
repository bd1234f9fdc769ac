// The mass of a vehicle as one rigid body.
#pragma once

#include <array>
#include <span>

#include "elsie/api/body.h"

namespace elsie::physics {

/// All parts of a vehicle together, without the inertia of wheels with motors about their axles:
/// that belongs to the wheels.
struct Lump {
  double mass = 0.0;  // kg
  Vector3 center;     // m, from the middle of the chassis, in the vehicle's frame
  std::array<Vector3, 3> inverse_inertia{};  // 1/(kg m2), rows, about the center
};

/// `parts` are those of one vehicle, the chassis first, its steering straight ahead.
Lump lump_of(std::span<const Part> parts);

}  // namespace elsie::physics
