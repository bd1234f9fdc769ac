#include "step/waypoint_path.h"

#include <algorithm>
#include <cmath>

namespace elsie::simulation {

WaypointPath::WaypointPath(const world::Obstacle& obstacle) : speed_(obstacle.speed) {
  corners_.push_back({obstacle.x, obstacle.y});
  corners_.insert(corners_.end(), obstacle.waypoints.begin(), obstacle.waypoints.end());
  if (!obstacle.round_trip) {
    for (std::size_t i = corners_.size() - 1; i-- > 1;) {
      corners_.push_back(corners_[i]);
    }
  }
  corners_.push_back(corners_.front());
  distances_.push_back(0.0);
  for (std::size_t i = 1; i < corners_.size(); ++i) {
    distances_.push_back(distances_.back() + std::hypot(corners_[i].x - corners_[i - 1].x,
                                                        corners_[i].y - corners_[i - 1].y));
  }
}

Vector2 WaypointPath::position(double time_s) const {
  const double length = distances_.back();
  if (length <= 0.0) return corners_.front();
  const double along = std::fmod(speed_ * time_s, length);
  const auto next = std::upper_bound(distances_.begin() + 1, distances_.end() - 1, along);
  const std::size_t i = static_cast<std::size_t>(next - distances_.begin());
  const double part = (along - distances_[i - 1]) / (distances_[i] - distances_[i - 1]);
  return {corners_[i - 1].x + part * (corners_[i].x - corners_[i - 1].x),
          corners_[i - 1].y + part * (corners_[i].y - corners_[i - 1].y)};
}

}  // namespace elsie::simulation
