// The space in which coordinators measure and search commands.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <elsie/api/perception.h>

/// The plane of wheel rates; for drives with a lateral channel also a third dimension, in which the
/// lateral speed is the rate of a wheel that rolls at this speed.
class CommandSpace {
 public:
  using Point = std::array<double, 3>;  // rad/s: left, right, lateral

  CommandSpace() = default;
  explicit CommandSpace(const elsie::OwnState& self)
      : wheels_(self.wheels), lateral_(self.channels.lateral) {}

  std::size_t dimensions() const { return lateral_ ? 3 : 2; }

  Point point(const elsie::Motion& motion) const {
    const elsie::WheelRates rates = wheels_.wheel_rates(motion);
    return {rates.left, rates.right, lateral_ ? motion.lateral / wheels_.radius : 0.0};
  }
  elsie::Motion motion(const Point& point) const {
    elsie::Motion motion = wheels_.motion({point[0], point[1]});
    motion.lateral = lateral_ ? point[2] * wheels_.radius : 0.0;
    return motion;
  }

  /// The largest coordinate without its sign, rad/s.
  double fastest(const elsie::Motion& motion) const {
    const Point at = point(motion);
    return std::max({std::abs(at[0]), std::abs(at[1]), std::abs(at[2])});
  }
  double dot(const elsie::Motion& a, const elsie::Motion& b) const {
    const Point p = point(a);
    const Point q = point(b);
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  }
  /// (rad/s)^2
  double distance_squared(const elsie::Motion& a, const elsie::Motion& b) const {
    return dot(a - b, a - b);
  }

  friend bool operator==(const CommandSpace&, const CommandSpace&) = default;

 private:
  elsie::WheelPair wheels_;
  bool lateral_ = false;
};
