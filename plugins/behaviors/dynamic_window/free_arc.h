// Driving on an arc: where it leads, and how far a disc gets before it touches a point.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include <elsie/api/geometry.h>
#include <elsie/api/motion.h>

/// Where a robot is after a time with this motion, from the origin.
inline elsie::Pose after_arc(const elsie::Motion& motion, double time_s) {
  const double turned = motion.turn * time_s, way = motion.forward * time_s;
  if (std::abs(turned) < 1e-6) return {way, 0.0, turned};
  return {way * std::sin(turned) / turned, way * (1.0 - std::cos(turned)) / turned, turned};
}

/// The length of the way (m) from the origin along the arc of this curvature (1/m, positive to the
/// left), until a disc of radius `radius_m` touches the point; infinity if it never does. With r
/// the radius of the arc, D the distance of the point from its middle and f its angle along it:
///
///   straight   x - sqrt(R^2 - y^2)
///   arc        r (f - acos((r^2 + D^2 - R^2) / (2 r D)))
///
/// A point in the disc stops it if the way leads towards the point, and not if it leads away.
inline double free_arc(const elsie::Vector2& point, double curvature, double radius_m) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  constexpr double kStraight = 1e-6;  // 1/m
  const bool is_inside = point.x * point.x + point.y * point.y < radius_m * radius_m;
  if (std::abs(curvature) < kStraight) {
    if (std::abs(point.y) >= radius_m || point.x <= 0.0) return kNever;
    return is_inside ? 0.0 : point.x - std::sqrt(radius_m * radius_m - point.y * point.y);
  }
  const double r = 1.0 / std::abs(curvature);
  const double aside = std::copysign(1.0, curvature) * point.y - r;
  const double squared = point.x * point.x + aside * aside;
  // Compared as squares: most points are far from the arc.
  const double inner = r - radius_m, outer = r + radius_m;
  if (squared >= outer * outer || (inner > 0.0 && squared <= inner * inner)) return kNever;
  const double angle = std::atan2(point.x, -aside);
  if (is_inside && angle > 0.0) return 0.0;
  const double off = std::sqrt(squared);
  const double cosine = (squared + r * r - radius_m * radius_m) / (2.0 * r * off);
  if (!(cosine >= -1.0)) return is_inside ? kNever : 0.0;  // in the disc, all along the way
  const double way = angle - std::acos(std::fmin(1.0, cosine));
  return r * (way < 0.0 ? way + 2.0 * std::numbers::pi : way);
}
