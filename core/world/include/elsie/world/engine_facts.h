// Properties of robots that only the physics engine sets.
#pragma once

#include <algorithm>

#include "elsie/world/description.h"

namespace elsie::world {

/// The mass of a caster as a part of the chassis' mass: small, so that its spin has no effect.
inline constexpr double kCasterMass = 0.02;

/// The highest speed at which bodies that overlap are pushed apart; m/s.
inline constexpr double kMaxCorrectingSpeed = 0.5;

/// The radius of a caster, a ball below the chassis; m.
template <class Body>  // RobotBody or Chassis
double caster_radius(const Body& body) {
  return std::min({0.5 * body.clearance, 0.125 * body.length, body.wheel_radius});
}

/// The distance of the casters, one in front and one at the rear, from the middle of the axle; m.
template <class Body>
double half_base(const Body& body) {
  return 0.5 * body.length - 1.2 * caster_radius(body);
}

}  // namespace elsie::world
