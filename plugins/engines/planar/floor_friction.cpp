#include "floor_friction.h"

#include <cmath>

namespace elsie::physics {

FloorFriction::FloorFriction(const Inertia& inertia, double lever, const world::Physics& physics)
    : inertia_(inertia),
      force_(physics.step * physics.friction * inertia.mass * std::abs(physics.gravity)),
      torque_(lever * force_) {}

Twist FloorFriction::solve(const Twist& free) const {
  const double speed = std::hypot(free.x, free.y);
  if (speed == 0.0 && free.turn == 0.0) return free;
  const double by_force = inertia_.mass * speed / force_;
  const double by_torque = inertia_.about_center * std::abs(free.turn) / torque_;
  if (by_force * by_force + by_torque * by_torque <= 1.0) return {};
  // The impulse on the ellipsoid that takes the most energy.
  const double x = force_ * speed, t = torque_ * free.turn;
  const double scale = std::hypot(x, t);
  if (!(scale > 0.0)) return free;
  const double braked = force_ * x / scale / inertia_.mass;
  const double turned = torque_ * std::abs(t) / scale / inertia_.about_center;
  const double factor = speed > braked ? 1.0 - braked / speed : 0.0;
  const double turn = std::max(0.0, std::abs(free.turn) - turned);
  return {factor * free.x, factor * free.y, std::copysign(turn, free.turn)};
}

}  // namespace elsie::physics
