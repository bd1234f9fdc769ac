// Shared by several drives: wheels as parts, and limits of rim speeds.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/api/drive.h"

namespace drives {

using elsie::BodyPlan;
using elsie::Chassis;
using elsie::Part;
using elsie::WheelJoint;

inline void require(bool holds, const std::string& sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

/// A wheel below a chassis, its middle at (x, y) and turned by `heading_rad` to the left.
inline Part wheel(const std::string& name, const Chassis& chassis, double x, double y,
                  const WheelJoint& joint, double heading_rad = 0.0) {
  const elsie::Vector3 place{x, y, chassis.wheel_radius};
  return {name,
          elsie::PartRole::wheel,
          elsie::Shape::wheel(chassis.wheel_radius, chassis.wheel_width),
          heading_rad == 0.0 ? elsie::Frame{.origin = place}
                             : elsie::Frame::turned(place, heading_rad, 0.0),
          joint.torque > 0.0 ? chassis.wheel_mass : 0.0,
          0,
          joint};
}

/// Returns `given`, or else the length of the chassis, but at least so much that wheels do not
/// overlap. Axles below the ends of a chassis keep it from rearing up when it starts and stops.
/// Throws if front and rear wheels would be inside each other.
inline double wheelbase_or_default(double given, const Chassis& chassis) {
  if (given == 0.0) return std::max(chassis.length, 2.5 * chassis.wheel_radius);
  require(given >= 2.0 * chassis.wheel_radius,
          "its front and rear wheels would be inside each other: its wheelbase is " +
              std::to_string(given) + " m, the diameter of a wheel " +
              std::to_string(2.0 * chassis.wheel_radius) +
              " m; make it longer, or 0 for the length of the chassis");
  return given;
}

/// Throws if two wheels are nearer to each other than `least`, m.
inline void require_apart(const BodyPlan& plan, double least) {
  for (std::size_t a = 0; a < plan.parts.size(); ++a) {
    for (std::size_t b = a + 1; b < plan.parts.size(); ++b) {
      const Part &one = plan.parts[a], &other = plan.parts[b];
      if (one.role != elsie::PartRole::wheel || other.role != elsie::PartRole::wheel) continue;
      const elsie::Vector3 apart = one.frame.origin - other.frame.origin;
      require(std::hypot(apart.x, apart.y) >= least,
              "its wheels '" + one.name + "' and '" + other.name +
                  "' would be inside each other; move them apart or make them smaller");
    }
  }
}

/// The diameter of the circle that a wheel needs to point in any direction, m.
inline double sweep(const Chassis& chassis) {
  return std::hypot(2.0 * chassis.wheel_radius, chassis.wheel_width);
}

/// The factor, at most 1, that brings the fastest of these rates down to the limit.
template <class Rates>
double slowed(const Rates& rates, double most) {
  double largest = 0.0;
  for (const double rate : rates) largest = std::max(largest, std::abs(rate));
  return largest > most ? most / largest : 1.0;
}

}  // namespace drives
