// Driving into a direction: turn to it, and drive the faster the better it lies ahead.
#pragma once

#include <algorithm>
#include <cmath>

#include <elsie/api/motion.h>

/// With the bearing b (rad, positive to the left): forward speed * max(0, cos b), turn gain * b.
/// The robot turns in place while the direction is behind it (Aicardi et al. 1995).
inline elsie::Motion heading_for(double bearing_rad, double speed, double gain) {
  return {speed * std::max(0.0, std::cos(bearing_rad)), 0.0, gain * bearing_rad};
}

/// The same for a place that is `away_m` off: nearer than `slow_down_m` the slower the nearer.
inline elsie::Motion steer(double off_rad, double away_m, double speed, double gain,
                           double slow_down_m) {
  elsie::Motion motion = heading_for(off_rad, speed, gain);
  motion.forward *= std::min(1.0, away_m / slow_down_m);
  return motion;
}
