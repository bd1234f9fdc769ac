// The reading of an odometer.
#pragma once

namespace elsie {

/// What the encoders of the wheels tell, as the two wheels of the equivalent differential drive.
struct OdometerReading {
  static constexpr const char* kind = "odometer";
  double left_m = 0.0;   // path of the left wheel since the start of the run
  double right_m = 0.0;  // path of the right wheel
  // Since the last update, in the robot's frame, if no wheel slips:
  double forward_m = 0.0;
  double lateral_m = 0.0;
  double turn_rad = 0.0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("left", left_m, "m");
    visitor("right", right_m, "m");
    visitor("forward", forward_m, "m");
    visitor("lateral", lateral_m, "m");
    visitor("turn", turn_rad, "rad");
  }
};

}  // namespace elsie
