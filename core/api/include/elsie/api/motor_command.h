// What a behaviour asks of the motors.
#pragma once

#include <cmath>

namespace elsie {

/// Angular rates of the two driven wheels, rad/s, positive forward. The motor space of every
/// behaviour and coordinator. A robot with another drive takes the two numbers as those of a
/// differential drive that moves in the same way. The simulator scales both by one factor where a
/// wheel would have to turn faster than the robot's maximum speed.
struct MotorCommand {
  double left = 0.0;   // rad/s
  double right = 0.0;  // rad/s

  friend bool operator==(const MotorCommand&, const MotorCommand&) = default;
  friend MotorCommand operator+(const MotorCommand& a, const MotorCommand& b) {
    return {a.left + b.left, a.right + b.right};
  }
  friend MotorCommand operator-(const MotorCommand& a, const MotorCommand& b) {
    return {a.left - b.left, a.right - b.right};
  }
  friend MotorCommand operator*(double s, const MotorCommand& c) {
    return {s * c.left, s * c.right};
  }
  friend MotorCommand operator/(const MotorCommand& c, double s) {
    return {c.left / s, c.right / s};
  }
  MotorCommand& operator+=(const MotorCommand& other) { return *this = *this + other; }

  bool is_finite() const { return std::isfinite(left) && std::isfinite(right); }
};

}  // namespace elsie
