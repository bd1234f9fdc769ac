// An arena of 10 m x 10 m with walls, 20 boxes, and robots with 8 beams of 1 m that steer by crisp
// avoidance (a Braitenberg vehicle) at 100 Hz: the world of several benchmarks.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/motion.h"
#include "elsie/world/description.h"

namespace elsie::bench {

inline constexpr std::array<double, 8> kBeamAzimuths_deg = {12, -12, 40, -40, 80, -80, 130, -130};
inline constexpr double kBeamRange_m = 1.0;

/// Robots r0, r1, ... on a grid with the boxes between them; their batteries hardly empty, and the
/// run hardly ends. From 101 robots on, arena and boxes grow with their number.
world::World arena_of_robots(int robots);
std::vector<Pose> poses_of(const world::World& arena);

/// Wheel rates from the distances of the eight beams; `kBeamRange_m` means no hit.
using Rule = std::function<WheelRates(const double* ranges_m)>;

/// What the behaviour `braitenberg` does with these beams, limited to the robot's speed.
WheelRates steer(const double* ranges_m);

}  // namespace elsie::bench
