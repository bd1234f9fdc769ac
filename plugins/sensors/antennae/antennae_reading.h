// The reading of antennae, which sense a field at places beside each other.
#pragma once

#include <cstddef>
#include <vector>

namespace elsie {

/// Tips from left to right.
struct AntennaeReading {
  static constexpr const char* kind = "antennae";
  std::vector<double> values;  // of the field at each tip, units/m2
  double first_m = 0.0;        // how far the first tip is to the left of the sensor
  double step_m = 0.0;         // from each tip to the next one, which is to the right of it

  double offset_m(std::size_t tip) const { return first_m - static_cast<double>(tip) * step_m; }

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("values", values, "units/m2");
  }
};

}  // namespace elsie
