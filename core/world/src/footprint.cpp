#include "elsie/world/footprint.h"

#include <algorithm>
#include <cmath>

#include "elsie/base/number_text.h"

namespace elsie::world {

namespace {

using base::number_text;

constexpr double kTouching = 1e-6;  // m: bodies that overlap by this much only touch
constexpr double kHair = 1e-9;      // m: parts may extend beyond a chassis by rounding

// A length for a message, rounded to a tenth of a millimetre.
std::string rounded(double metres) { return number_text(std::round(metres * 1e4) / 1e4); }

/// Whether a disc overlaps a rectangle, seen from above.
bool disc_overlaps(const Footprint& disc, const Footprint& rectangle) {
  const double c = std::cos(rectangle.heading_rad), s = std::sin(rectangle.heading_rad);
  const double dx = disc.x - rectangle.x, dy = disc.y - rectangle.y;
  // Distances from the nearest point of the rectangle.
  const double along = std::max(0.0, std::abs(c * dx + s * dy) - rectangle.half_length);
  const double across = std::max(0.0, std::abs(c * dy - s * dx) - rectangle.half_width);
  return std::hypot(along, across) < disc.half_length - kTouching;
}

bool rectangles_overlap(const Footprint& a, const Footprint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  if (std::hypot(dx, dy) >=
      std::hypot(a.half_length, a.half_width) + std::hypot(b.half_length, b.half_width)) {
    return false;
  }
  for (const double heading : {a.heading_rad, b.heading_rad}) {
    const double c = std::cos(heading), s = std::sin(heading);
    for (const auto& [ux, uy] : {std::pair(c, s), std::pair(-s, c)}) {
      if (std::abs(dx * ux + dy * uy) >= a.reach(ux, uy) + b.reach(ux, uy) - kTouching) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

double Footprint::reach(double ux, double uy) const {
  if (round) {
    return half_length;
  }
  const double c = std::cos(heading_rad), s = std::sin(heading_rad);
  return half_length * std::abs(ux * c + uy * s) + half_width * std::abs(-ux * s + uy * c);
}

Vector3 extents_of(std::span<const Part> vehicle) {
  Vector3 extents;
  const auto widen = [](double& extent, double reach) {
    if (extent == 0.0 || reach > extent + kHair) {
      extent = reach;
    }
  };
  for (const Part& part : vehicle) {
    const Vector3 reach = reach_of(part);
    const Vector3& at = part.frame.origin;
    widen(extents.x, std::abs(at.x) + reach.x);
    widen(extents.y, std::abs(at.y) + reach.y);
    widen(extents.z, at.z + reach.z);
  }
  return extents;
}

double radius_of(std::span<const Part> vehicle) {
  if (!vehicle.front().shape.is_round()) {
    return 0.0;
  }
  double radius = 0.0;
  for (const Part& part : vehicle) {
    radius = std::max(radius, farthest_of(part, part.frame.origin));
  }
  return radius;
}

Footprint footprint_of(const Shape& shape, const Frame& middle) {
  const Vector3 half = 0.5 * shape.size;
  const auto extent = [&](const Vector3& axis) {
    return half.x * std::abs(dot(middle.forward, axis)) +
           half.y * std::abs(dot(middle.left, axis)) + half.z * std::abs(dot(middle.up, axis));
  };
  const Vector3& at = middle.origin;
  const double heading = std::atan2(middle.forward.y, middle.forward.x);
  const double c = std::cos(heading), s = std::sin(heading);
  const double up = extent({0.0, 0.0, 1.0});
  return {at.x,      at.y,      heading,         extent({c, s, 0.0}), extent({-s, c, 0.0}),
          at.z - up, at.z + up, shape.is_round()};
}

Footprint footprint_of(const Box& box) {
  const Fixture fixture = fixture_of(box);
  return footprint_of(fixture.shape, fixture.frame);
}

Footprint footprint_of(std::span<const Part> vehicle, const Pose& pose, double z) {
  const Vector3 extents = extents_of(vehicle);
  const double radius = radius_of(vehicle);
  const bool round = radius > 0.0;
  return {pose.x,
          pose.y,
          pose.heading_rad,
          round ? radius : extents.x,
          round ? radius : extents.y,
          z,
          z + extents.z,
          round};
}

std::vector<Footprint> footprints_of(const BodyPlan& plan, const Pose& pose, double z) {
  std::vector<Footprint> footprints;
  for (const Frame& frame : in_line(plan)) {
    const Vector2 at = point_of(pose, {frame.origin.x, frame.origin.y});
    footprints.push_back(
        footprint_of(vehicle_of(plan, footprints.size()), {at.x, at.y, pose.heading_rad}, z));
  }
  return footprints;
}

bool overlap(const Footprint& a, const Footprint& b) {
  if (a.bottom >= b.top - kTouching || b.bottom >= a.top - kTouching) {
    return false;
  }
  if (a.round && b.round) {
    return std::hypot(b.x - a.x, b.y - a.y) < a.half_length + b.half_length - kTouching;
  }
  return a.round ? disc_overlaps(a, b) : b.round ? disc_overlaps(b, a) : rectangles_overlap(a, b);
}

std::optional<std::string> outside(const Arena& arena, const std::string& what, double x,
                                   double y) {
  const double length = 0.5 * arena.length, width = 0.5 * arena.width;
  if (std::abs(x) <= length && std::abs(y) <= width) {
    return std::nullopt;
  }
  return what + " at (" + number_text(x) + ", " + number_text(y) +
         ") is outside of the arena, which reaches from " + number_text(-length) + " to " +
         number_text(length) + " in x and from " + number_text(-width) + " to " +
         number_text(width) + " in y";
}

std::optional<std::string> outside(const Arena& arena, const std::string& what,
                                   const Footprint& footprint) {
  if (auto problem = outside(arena, what, footprint.x, footprint.y)) {
    return problem;
  }
  if (!arena.walls || footprint.bottom >= arena.wall_height) {
    return std::nullopt;
  }
  const struct {
    const char* name;
    double overhang;
  } sides[] = {{"east", footprint.x + footprint.reach(1, 0) - 0.5 * arena.length},
               {"west", -footprint.x + footprint.reach(1, 0) - 0.5 * arena.length},
               {"north", footprint.y + footprint.reach(0, 1) - 0.5 * arena.width},
               {"south", -footprint.y + footprint.reach(0, 1) - 0.5 * arena.width}};
  for (const auto& side : sides) {
    if (side.overhang > kTouching) {
      return what + " reaches " + rounded(side.overhang) + " m into the " + side.name + " wall";
    }
  }
  return std::nullopt;
}

}  // namespace elsie::world
