// The way of a moving obstacle.
#pragma once

#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// Where a moving box is at a time: at constant speed from its start through the waypoints, and
/// then straight back to the start (a round trip) or the same way back (to and fro), for ever.
class BoxPath {
 public:
  explicit BoxPath(const world::Box& box);

  Vector2 position(double time_s) const;

 private:
  std::vector<Vector2> corners_;   // closed: the last is the first again
  std::vector<double> distances_;  // along the way, from the start to each corner
  double speed_;
};

}  // namespace elsie::simulation
