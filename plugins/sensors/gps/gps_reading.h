// The reading of a satellite navigation receiver.
#pragma once

namespace elsie {

struct GpsReading {
  static constexpr const char* kind = "gps";
  double x_m = 0.0;        // of the sensor, east
  double y_m = 0.0;        // north
  double z_m = 0.0;        // above the floor
  double speed_m_s = 0.0;  // of its robot, also for one on a segment

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("x", x_m, "m");
    visitor("y", y_m, "m");
    visitor("z", z_m, "m");
    visitor("speed", speed_m_s, "m/s");
  }
};

}  // namespace elsie
