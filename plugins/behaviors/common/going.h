// Going to a place and stopping there; shared by go_to_point, home and patrol.
#pragma once

#include <elsie/api/behavior.h>

#include "heading_for.h"

/// Part of a behaviour: what it needs for steer().
struct Going {
  double speed = 0.4;      // m/s
  double gain = 3.0;       // 1/s
  double slow_down = 0.3;  // m

  elsie::Motion towards(const elsie::Pose& here, double x, double y, double away_m) const {
    return steer(elsie::bearing(here, x, y), away_m, speed, gain, slow_down);
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
