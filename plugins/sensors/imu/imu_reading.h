// The reading of an inertial measurement unit.
#pragma once

#include <array>

namespace elsie {

/// Along the sensor's axes: x forward, y left, z up.
struct ImuReading {
  static constexpr const char* kind = "imu";
  std::array<double, 3> acceleration_m_s2{};  // specific force: a sensor at rest reads gravity, up
  std::array<double, 3> turning_rad_s{};      // about each axis

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("acceleration", acceleration_m_s2, "m/s2");
    visitor("turning", turning_rad_s, "rad/s");
  }
};

}  // namespace elsie
