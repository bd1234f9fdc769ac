#include "elsie/world/footprint.h"

#include <algorithm>
#include <cmath>

#include "elsie/base/number_text.h"

namespace elsie::world {

namespace {

using base::number_text;

constexpr double kTouching = 1e-6;  // m: bodies that overlap by this much only touch
constexpr double kUpright = 0.995;  // up to about 6 degrees
constexpr double kHair = 1e-9;      // m: parts may extend beyond a chassis by rounding

// A length for a message, rounded to a tenth of a millimetre.
std::string rounded(double metres) { return number_text(std::round(metres * 1e4) / 1e4); }

/// The corners of a rectangle or an outline, counter-clockwise, from its middle.
std::vector<Vector2> corners_of(const Footprint& area) {
  const double x = area.half_length, y = area.half_width;
  std::vector<Vector2> corners = area.outline;
  if (corners.empty()) corners = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
  for (Vector2& corner : corners) corner = point_of({0.0, 0.0, area.heading_rad}, corner);
  return corners;
}

/// Whether a side of `a`, or the direction from a corner of it to a disc, separates the two.
bool separates(const Footprint& a, const Footprint& b) {
  const std::vector<Vector2> corners = corners_of(a);
  const double dx = b.x - a.x, dy = b.y - a.y;
  const auto is_apart = [&](double ux, double uy) {
    const double length = std::hypot(ux, uy);
    return length > 0.0 && (dx * ux + dy * uy) / length >= a.reach(ux / length, uy / length) +
                                                               b.reach(-ux / length, -uy / length) -
                                                               kTouching;
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 &from = corners[i], &to = corners[(i + 1) % corners.size()];
    if (is_apart(to.y - from.y, from.x - to.x)) return true;
    if (b.round && is_apart(dx - from.x, dy - from.y)) return true;
  }
  return false;
}

}  // namespace

double Footprint::reach(double ux, double uy) const {
  if (round) return half_length;
  if (!outline.empty()) {
    const std::vector<Vector2> corners = corners_of(*this);
    double most = 0.0;
    for (const Vector2& corner : corners) most = std::max(most, corner.x * ux + corner.y * uy);
    return most + margin;
  }
  const double c = std::cos(heading_rad), s = std::sin(heading_rad);
  return half_length * std::abs(ux * c + uy * s) + half_width * std::abs(-ux * s + uy * c);
}

Footprint Footprint::grown(double by) const {
  Footprint area = *this;
  area.half_length = std::max(0.0, half_length + by);
  area.half_width = std::max(0.0, half_width + by);
  area.margin += by;
  return area;
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
  if (!vehicle.front().shape.is_round()) return 0.0;
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
  Footprint area{at.x,      at.y,      heading,         extent({c, s, 0.0}), extent({-s, c, 0.0}),
                 at.z - up, at.z + up, shape.is_round()};
  if (middle.up.z > kUpright) area.outline = shape.outline;
  return area;
}

Footprint footprint_of(const Obstacle& obstacle) {
  const Fixture fixture = fixture_of(obstacle);
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
  if (a.bottom >= b.top - kTouching || b.bottom >= a.top - kTouching) return false;
  const auto radius = [](const Footprint& area) {
    return area.round ? area.half_length : std::hypot(area.half_length, area.half_width);
  };
  return std::hypot(b.x - a.x, b.y - a.y) < radius(a) + radius(b) - kTouching &&
         (a.round || !separates(a, b)) && (b.round || !separates(b, a));
}

std::optional<std::string> outside(const Arena& arena, const std::string& what, double x,
                                   double y) {
  const double length = 0.5 * arena.length, width = 0.5 * arena.width;
  if (std::abs(x) <= length && std::abs(y) <= width) return std::nullopt;
  return what + " at (" + number_text(x) + ", " + number_text(y) +
         ") is outside of the arena, which reaches from " + number_text(-length) + " to " +
         number_text(length) + " in x and from " + number_text(-width) + " to " +
         number_text(width) + " in y";
}

std::optional<std::string> outside(const Arena& arena, const std::string& what,
                                   const Footprint& footprint) {
  if (auto problem = outside(arena, what, footprint.x, footprint.y)) return problem;
  if (!arena.walls || footprint.bottom >= arena.wall_height) return std::nullopt;
  const struct {
    const char* name;
    double overhang;
  } sides[] = {{"east", footprint.x + footprint.reach(1, 0) - 0.5 * arena.length},
               {"west", -footprint.x + footprint.reach(-1, 0) - 0.5 * arena.length},
               {"north", footprint.y + footprint.reach(0, 1) - 0.5 * arena.width},
               {"south", -footprint.y + footprint.reach(0, -1) - 0.5 * arena.width}};
  for (const auto& side : sides) {
    if (side.overhang > kTouching) {
      return what + " reaches " + rounded(side.overhang) + " m into the " + side.name + " wall";
    }
  }
  return std::nullopt;
}

}  // namespace elsie::world
