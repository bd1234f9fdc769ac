// The motion of a body, commanded or measured.
#pragma once

#include <cmath>

namespace elsie {

/// The motion of a body in its own plane: the command of behaviours and coordinators, for any
/// drive. A command that the drive cannot make is projected onto the motions that it can make.
struct Motion {
  double forward = 0.0;  // m/s, along the heading
  double lateral = 0.0;  // m/s, to the left
  double turn = 0.0;     // rad/s, counter-clockwise

  friend bool operator==(const Motion&, const Motion&) = default;
  friend Motion operator+(const Motion& a, const Motion& b) {
    return {a.forward + b.forward, a.lateral + b.lateral, a.turn + b.turn};
  }
  friend Motion operator-(const Motion& a, const Motion& b) {
    return {a.forward - b.forward, a.lateral - b.lateral, a.turn - b.turn};
  }
  friend Motion operator*(double s, const Motion& m) {
    return {s * m.forward, s * m.lateral, s * m.turn};
  }
  friend Motion operator/(const Motion& m, double s) {
    return {m.forward / s, m.lateral / s, m.turn / s};
  }
  Motion& operator+=(const Motion& other) { return *this = *this + other; }

  bool is_finite() const {
    return std::isfinite(forward) && std::isfinite(lateral) && std::isfinite(turn);
  }
};

/// The rates of the two wheels of a differential drive, rad/s, positive forward; many behaviours in
/// the literature use them. WheelPair converts them to a motion and back.
struct WheelRates {
  double left = 0.0;   // rad/s
  double right = 0.0;  // rad/s

  friend bool operator==(const WheelRates&, const WheelRates&) = default;
  friend WheelRates operator+(const WheelRates& a, const WheelRates& b) {
    return {a.left + b.left, a.right + b.right};
  }
  friend WheelRates operator-(const WheelRates& a, const WheelRates& b) {
    return {a.left - b.left, a.right - b.right};
  }
  friend WheelRates operator*(double s, const WheelRates& w) { return {s * w.left, s * w.right}; }
  friend WheelRates operator/(const WheelRates& w, double s) { return {w.left / s, w.right / s}; }
  WheelRates& operator+=(const WheelRates& other) { return *this = *this + other; }
};

/// Two wheels on an axle. For another drive: the wheels of an equivalent differential drive.
struct WheelPair {
  double radius = 0.02;      // m
  double half_axle = 0.045;  // m, half the distance between the wheels

  /// Forward kinematics: forward = r (right + left) / 2, turn = r (right - left) / (2 R).
  Motion motion(const WheelRates& rates) const {
    return {0.5 * radius * (rates.left + rates.right), 0.0,
            0.5 * radius * (rates.right - rates.left) / half_axle};
  }
  /// Inverse kinematics; ignores the lateral speed.
  WheelRates wheel_rates(const Motion& motion) const {
    return {(motion.forward - half_axle * motion.turn) / radius,
            (motion.forward + half_axle * motion.turn) / radius};
  }
  /// The squared distance between two motions, (rad/s)^2, in the plane of wheel rates. Lateral
  /// speed is a third dimension: the rate of a wheel that rolls at that speed.
  double distance_squared(const Motion& a, const Motion& b) const {
    const Motion difference = a - b;
    const WheelRates rates = wheel_rates(difference);
    const double lateral = difference.lateral / radius;
    return rates.left * rates.left + rates.right * rates.right + lateral * lateral;
  }

  friend bool operator==(const WheelPair&, const WheelPair&) = default;
};

/// The channels of motion that a drive has.
struct Channels {
  bool forward = true;
  bool lateral = false;
  bool turn = true;

  friend bool operator==(const Channels&, const Channels&) = default;
};

}  // namespace elsie
