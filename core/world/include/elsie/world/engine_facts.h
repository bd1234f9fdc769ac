// What the physics engine adds to the description of a robot, for whoever judges a world by it.
#pragma once

#include <algorithm>

#include "elsie/world/description.h"

namespace elsie::world {

/// A robot's caster weighs this part of its chassis: little, so that it does not matter how the
/// caster spins.
inline constexpr double kCasterMass = 0.02;

/// Bodies that were put into each other, or squeezed, come apart no faster than this; m/s.
inline constexpr double kMaxCorrectingSpeed = 0.5;

/// m, of a caster, which is a ball below the chassis.
inline double caster_radius(const RobotBody& body) {
  return std::min({0.5 * body.clearance, 0.125 * body.length, body.wheel_radius});
}

/// m, of the middles of the casters, on which a robot stands in front and at the rear, from the
/// middle of its axle.
inline double half_base(const RobotBody& body) {
  return 0.5 * body.length - 1.2 * caster_radius(body);
}

}  // namespace elsie::world
