// The reading of an active infra-red proximity sensor.
#pragma once

namespace elsie {

/// How much of its own light comes back. The scale is that of the robot whose law it has.
struct InfraredReading {
  static constexpr const char* kind = "infrared";
  double value = 0.0;      // large is near
  double largest = 1.0;    // value of the law
  double max_range_m = 0;  // beyond, the law gives the value of nothing

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("value", value);
  }
};

}  // namespace elsie
