// The reading of a depth camera.
#pragma once

#include <vector>

#include "elsie/api/image.h"

namespace elsie {

/// Distances along the rays of the pixels' middles, rows from the top, each from left to right.
struct DepthReading {
  static constexpr const char* kind = "depth";
  std::vector<double> depths_m;  // max_range_m where nothing was hit
  int width = 0;                 // px
  int height = 0;                // px
  double max_range_m = 0.0;
  double horizontal_fov_rad = 0.0;
  Image picture;  // grey: white is near, black is max_range_m

  double depth_m(int column, int row) const {
    return depths_m[static_cast<std::size_t>(row * width + column)];
  }

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("depths", depths_m, "m");
    visitor("picture", picture);
  }
};

}  // namespace elsie
