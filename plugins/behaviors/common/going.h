// Going to a place and stopping there; shared by go_to_point, home and patrol.
#pragma once

#include <algorithm>

#include <elsie/api/behavior.h>

#include "heading_for.h"

/// heading_for(), and nearer than `slow_down` the slower the nearer.
class Going : public elsie::Behavior {
 public:
  double speed = 0.4;      // m/s
  double gain = 3.0;       // 1/s
  double slow_down = 0.3;  // m

 protected:
  elsie::Motion towards(const elsie::Pose& here, double x, double y, double away_m) const {
    elsie::Motion motion = heading_for(elsie::bearing(here, x, y), speed, gain);
    motion.forward *= std::min(1.0, away_m / slow_down);
    return motion;
  }
};

// Their parameters.

inline auto speed_of_going() {
  return elsie::parameter(
      "speed", &Going::speed,
      {.unit = "m/s", .min = 0, .max = 50, .meaning = "speed when the place lies straight ahead"});
}
inline auto gain_of_going() {
  return elsie::parameter("gain", &Going::gain,
                          {.unit = "1/s",
                           .min = 0,
                           .max = 100,
                           .meaning = "turn rate for each radian off the direction"});
}
inline auto slow_down_of_going() {
  return elsie::parameter(
      "slow_down", &Going::slow_down,
      {.unit = "m", .above = 0, .meaning = "nearer than this it drives more slowly"});
}
