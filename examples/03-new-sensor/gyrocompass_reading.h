// A kind of reading that Elsie does not know: the sensor that makes it and the behaviour that reads
// it share this header, and nothing else.
#pragma once

/// Which way the robot looks, as a gyrocompass has it.
struct GyrocompassReading {
  static constexpr const char* kind = "gyrocompass";
  double heading_rad = 0.0;  // counter-clockwise from east, in (-pi, pi]

  template <class Visitor>
  void visit(Visitor&& visitor) const {  // its values in recordings
    visitor("heading_rad", heading_rad);
  }
};
