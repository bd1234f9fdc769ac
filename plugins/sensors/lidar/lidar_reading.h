// The reading of a lidar.
#pragma once

#include <cstddef>
#include <vector>

namespace elsie {

/// Distances along a fan of rays, from left to right.
struct LidarReading {
  static constexpr const char* kind = "lidar";
  std::vector<double> ranges_m;  // max_range_m where nothing was hit
  double max_range_m = 0.0;
  double first_rad = 0.0;  // azimuth of the first ray, from the sensor's forward axis, to the left
  double step_rad = 0.0;   // from each ray to the next one, which is to the right of it

  double azimuth_rad(std::size_t ray) const {
    return first_rad - static_cast<double>(ray) * step_rad;
  }

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("ranges", ranges_m, "m");
  }
};

}  // namespace elsie
