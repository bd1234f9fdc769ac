// The steering of wheels.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elsie/api/body.h"
#include "elsie/api/geometry.h"

namespace elsie::physics {

/// Turns a wheel in a step, as its steering motor does whatever the wheel touches: sets the angle
/// and the rate of `now`. Returns whether the angle has changed.
inline bool steer(JointSetting& now, const JointSetting& wanted, double most_rad, double rate_rad_s,
                  double step) {
  const bool all_round = most_rad >= std::numbers::pi;
  // The shorter way, or as far as it turns.
  const double target = all_round ? now.angle_rad + wrap_angle(wanted.angle_rad - now.angle_rad)
                                  : std::clamp(wanted.angle_rad, -most_rad, most_rad);
  const double asked = std::abs(wanted.turn_rad_s);
  const double most = step * (asked == 0.0 ? rate_rad_s : std::min(asked, rate_rad_s));
  const double off = target - now.angle_rad;
  const double angle = std::abs(off) <= most ? target : now.angle_rad + std::copysign(most, off);
  now.turn_rad_s = (angle - now.angle_rad) / step;
  if (angle == now.angle_rad) return false;
  now.angle_rad = all_round ? wrap_angle(angle) : angle;
  return true;
}

}  // namespace elsie::physics
