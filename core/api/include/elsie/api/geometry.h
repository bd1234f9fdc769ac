// Positions, poses and frames, in SI units: metres and radians; x east, y north, z up, heading
// counter-clockwise from +x.
#pragma once

#include <cmath>
#include <numbers>

namespace elsie {

struct Vector2 {
  double x = 0.0;  // m
  double y = 0.0;  // m

  friend bool operator==(const Vector2&, const Vector2&) = default;
};

struct Vector3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend bool operator==(const Vector3&, const Vector3&) = default;
  friend Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Vector3 operator*(double s, const Vector3& v) { return {s * v.x, s * v.y, s * v.z}; }
};

inline double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A position and heading on the floor.
struct Pose {
  double x = 0.0;            // m
  double y = 0.0;            // m
  double heading_rad = 0.0;  // in (-pi, pi]

  friend bool operator==(const Pose&, const Pose&) = default;
};

/// A right-handed frame in space: its origin, and its axes as unit vectors, in its parent frame.
struct Frame {
  Vector3 origin;
  Vector3 forward{1.0, 0.0, 0.0};
  Vector3 left{0.0, 1.0, 0.0};
  Vector3 up{0.0, 0.0, 1.0};

  /// Converts a vector from this frame to the parent frame.
  Vector3 direction(const Vector3& v) const { return v.x * forward + v.y * left + v.z * up; }
  /// Converts a point from this frame to the parent frame.
  Vector3 point(const Vector3& p) const { return origin + direction(p); }
  /// Converts a frame given in this frame to the parent frame.
  Frame frame(const Frame& inner) const {
    return {point(inner.origin), direction(inner.forward), direction(inner.left),
            direction(inner.up)};
  }
  /// A frame turned by `yaw` about z, then by `pitch` about its own y axis (positive pitch points
  /// up).
  static Frame turned(const Vector3& origin, double yaw_rad, double pitch_rad) {
    const double cy = std::cos(yaw_rad), sy = std::sin(yaw_rad);
    const double cp = std::cos(pitch_rad), sp = std::sin(pitch_rad);
    return {origin, {cy * cp, sy * cp, sp}, {-sy, cy, 0.0}, {-cy * sp, -sy * sp, cp}};
  }
};

inline constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
inline constexpr double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// The same angle in (-pi, pi].
inline double wrap_angle(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

inline double distance(const Pose& a, const Pose& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Converts a point from a pose's own frame (x ahead, y to the left) to the frame of the pose.
inline Vector2 point_of(const Pose& pose, const Vector2& point) {
  const double c = std::cos(pose.heading_rad), s = std::sin(pose.heading_rad);
  return {pose.x + c * point.x - s * point.y, pose.y + s * point.x + c * point.y};
}

/// The direction from a pose to a point, relative to the pose's heading; in (-pi, pi], positive to
/// the left.
inline double bearing(const Pose& from, double x, double y) {
  return wrap_angle(std::atan2(y - from.y, x - from.x) - from.heading_rad);
}

}  // namespace elsie
