// The path of a moving obstacle.
#pragma once

#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// The position of a moving obstacle over time. It moves at constant speed from its start through
/// the waypoints, then straight to the start (a round trip) or back the same way (to and fro),
/// forever.
class WaypointPath {
 public:
  explicit WaypointPath(const world::Obstacle& obstacle);

  Vector2 position(double time_s) const;

 private:
  std::vector<Vector2> corners_;   // closed: the last equals the first
  std::vector<double> distances_;  // along the path, from the start to each corner
  double speed_;
};

}  // namespace elsie::simulation
