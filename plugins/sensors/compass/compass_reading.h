// The reading of a compass.
#pragma once

namespace elsie {

struct CompassReading {
  static constexpr const char* kind = "compass";
  double heading_rad = 0.0;  // of the sensor's forward axis, from east, counter-clockwise
  double north_rad = 0.0;    // where north is, from that axis, positive to the left

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("heading", heading_rad, "rad");
    visitor("north", north_rad, "rad");
  }
};

}  // namespace elsie
