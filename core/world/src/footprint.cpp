#include "elsie/world/footprint.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "elsie/base/number_text.h"
#include "elsie/world/parts.h"

namespace elsie::world {

namespace {

using base::number_text;

constexpr double kTouching = 1e-6;  // m: this much overlap is none

// A length in a message: to the tenth of a millimetre.
std::string rounded(double metres) { return number_text(std::round(metres * 1e4) / 1e4); }

}  // namespace

double Footprint::reach(double ux, double uy) const {
  const double c = std::cos(heading_rad), s = std::sin(heading_rad);
  return half_length * std::abs(ux * c + uy * s) + half_width * std::abs(-ux * s + uy * c);
}

Footprint footprint_of(const Box& box) {
  return {box.x,           box.y, radians(box.heading_deg), 0.5 * box.length,
          0.5 * box.width, box.z, box.z + box.height};
}

Footprint footprint_of(const Box& box, const Frame& now) {
  const Vector3 half{0.5 * box.length, 0.5 * box.width, 0.5 * box.height};
  const Vector3 middle = now.origin + half.z * now.up;
  const auto extent = [&](const Vector3& axis) {
    return half.x * std::abs(dot(now.forward, axis)) + half.y * std::abs(dot(now.left, axis)) +
           half.z * std::abs(dot(now.up, axis));
  };
  const double heading = std::atan2(now.forward.y, now.forward.x);
  const double c = std::cos(heading), s = std::sin(heading);
  const double up = extent({0.0, 0.0, 1.0});
  return {middle.x,      middle.y,     heading, extent({c, s, 0.0}), extent({-s, c, 0.0}),
          middle.z - up, middle.z + up};
}

Footprint footprint_of(const RobotBody& body, const Pose& pose, double z) {
  return {pose.x,
          pose.y,
          pose.heading_rad,
          std::max(0.5 * body.length, body.wheel_radius),
          std::max(0.5 * body.width, body.half_axle() + 0.5 * body.wheel_width),
          z,
          z + std::max(body.top(), 2.0 * body.wheel_radius)};
}

Footprint footprint_of(const Segment& segment, const Pose& pose, double z) {
  return {pose.x,
          pose.y,
          pose.heading_rad,
          std::max(0.5 * segment.length, segment.wheel_radius),
          0.5 * segment.width,
          z,
          z + std::max(segment.top(), 2.0 * segment.wheel_radius)};
}

Footprint footprint_of(const BodyPlan& plan, std::size_t vehicle, const Pose& pose, double z) {
  Footprint footprint{pose.x, pose.y, pose.heading_rad, 0.0, 0.0, z, z};
  for (const Part& part : plan.parts) {
    if (part.vehicle != vehicle || part.role == PartRole::caster) continue;
    const Vector3 &at = part.frame.origin, &size = part.shape.size;
    const auto* wheel = std::get_if<WheelJoint>(&part.joint);
    const bool turns = part.frame.forward != Vector3{1.0, 0.0, 0.0} || (wheel && wheel->steered);
    const double along = 0.5 * (turns ? std::hypot(size.x, size.y) : size.x);
    const double across = turns ? along : 0.5 * size.y;
    footprint.half_length = std::max(footprint.half_length, std::abs(at.x) + along);
    footprint.half_width = std::max(footprint.half_width, std::abs(at.y) + across);
    footprint.top = std::max(footprint.top, z + at.z + 0.5 * size.z);
  }
  return footprint;
}

std::vector<Footprint> footprints_of(const BodyPlan& plan, const Pose& pose, double z) {
  std::vector<Footprint> footprints;
  const double c = std::cos(pose.heading_rad), s = std::sin(pose.heading_rad);
  for (const Frame& frame : in_line(plan)) {
    const double x = frame.origin.x;
    footprints.push_back(footprint_of(plan, footprints.size(),
                                      {pose.x + x * c, pose.y + x * s, pose.heading_rad}, z));
  }
  return footprints;
}

bool overlap(const Footprint& a, const Footprint& b) {
  if (a.bottom >= b.top - kTouching || b.bottom >= a.top - kTouching) {
    return false;
  }
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
