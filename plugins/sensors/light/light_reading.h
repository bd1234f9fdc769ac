// The reading of one or several light cells.
#pragma once

#include <cstddef>
#include <vector>

namespace elsie {

/// Cells from left to right, as the rays of a lidar.
struct LightReading {
  static constexpr const char* kind = "light";
  std::vector<double> values;  // of each cell; what they mean is said by its law
  double largest = 1.0;        // value
  bool dark_is_large = false;  // a large value is dark
  double first_rad = 0.0;      // azimuth of the first cell from the sensor's forward axis
  double step_rad = 0.0;       // from each cell to the next one, which is to the right of it

  double azimuth_rad(std::size_t cell) const {
    return first_rad - static_cast<double>(cell) * step_rad;
  }

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("values", values);
  }
};

}  // namespace elsie
