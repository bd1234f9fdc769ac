// An arena of 10 m x 10 m with walls, 20 boxes, and robots with 8 beams of 1 m that steer by crisp
// avoidance (a Braitenberg vehicle) at 100 Hz: the world of several benchmarks.
#pragma once

#include <array>

#include "elsie/world/description.h"

namespace elsie::bench {

inline constexpr std::array<double, 8> kBeamAzimuths_deg = {12, -12, 40, -40, 80, -80, 130, -130};

/// Robots r0, r1, ... on a grid with the boxes between them; their batteries hardly empty, and the
/// run hardly ends.
world::World arena_of_robots(int robots);

}  // namespace elsie::bench
