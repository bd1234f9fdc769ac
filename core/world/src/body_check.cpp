// What no body of a robot can be.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>

#include "elsie/world/parts.h"

namespace elsie::world {
namespace {

void require_body(bool holds, const std::string& sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

/// Whether the box around a shape is one that fits it.
bool is_sound(const Shape& shape) {
  const Vector3& size = shape.size;
  if (!is_positive(size.x) || !is_positive(size.y) || !is_positive(size.z)) return false;
  if (shape.kind == Shape::Kind::box) return true;
  const std::array sizes{size.x, size.y, size.z};
  const auto axis = static_cast<std::size_t>(shape.axis);
  const double across = sizes[(axis + 1) % 3], along = sizes[axis];
  if (sizes[(axis + 2) % 3] != across) return false;
  return shape.kind == Shape::Kind::cylinder || along == across ||
         (shape.kind == Shape::Kind::capsule && along > across);
}

void check_wheel(const WheelJoint& wheel, const Part& part) {
  require_body(part.shape.kind == Shape::Kind::cylinder && part.shape.axis == Shape::Axis::left,
               "A wheel must be a cylinder about the left axis of its frame.");
  const bool is_driven = wheel.torque != 0.0;
  require_body(
      std::isfinite(wheel.torque) && wheel.torque >= 0.0 &&
          (is_driven ? is_positive(part.mass) : part.mass == 0.0),
      "All lengths, masses and the torque of a robot's body must be positive and finite; a wheel "
      "without a motor has no mass of its own.");
  require_body(
      !wheel.steered || (is_positive(wheel.max_steer_rad) && is_positive(wheel.steer_rate_rad_s)),
      "A steered wheel must be able to turn, at a rate that is positive and finite.");
  require_body(!wheel.rollers_rad || std::abs(std::cos(*wheel.rollers_rad)) > 1e-3,
               "The rollers of a wheel must not stand across the direction in which it rolls.");
}

void check_hitch(const HitchJoint& hitch) {
  require_body(
      is_positive(hitch.ahead) && std::isfinite(hitch.behind) && std::isfinite(hitch.height) &&
          hitch.behind >= 0.0 && hitch.height >= 0.0,
      "The joint of a segment must be ahead of its axle, not ahead of the middle of the body "
      "in front, and not below the floor.");
  require_body(hitch.max_yaw_rad > 0.0 && hitch.max_yaw_rad < std::numbers::pi &&
                   hitch.max_pitch_rad > 0.0 && hitch.max_pitch_rad < 0.5 * std::numbers::pi,
               "The joint of a segment must turn by less than 180 degrees to either side, and bend "
               "by less than 90.");
  require_body(std::isfinite(hitch.torque) && hitch.torque >= 0.0 &&
                   (hitch.torque == 0.0 || is_positive(hitch.yaw_rate_rad_s)),
               "The motor of a segment's joint must turn at a rate that is positive and finite.");
}

/// Whether two wheels of a vehicle that point straight ahead are in each other.
bool are_in_each_other(const Part& a, const Part& b) {
  const Vector3 apart = a.frame.origin - b.frame.origin;
  const Vector3 sizes = 0.5 * (a.shape.size + b.shape.size);
  return std::abs(apart.x) < sizes.x && std::abs(apart.y) < sizes.y && std::abs(apart.z) < sizes.z;
}

void check_wheels(const BodyPlan& plan) {
  const auto is_wheel = [](const Part& part) {
    return part.role == PartRole::wheel && part.frame.forward == Vector3{1.0, 0.0, 0.0};
  };
  for (auto a = plan.parts.begin(); a != plan.parts.end(); ++a) {
    if (!is_wheel(*a)) continue;
    const auto hits = [&](const Part& b) {
      return b.vehicle == a->vehicle && is_wheel(b) && are_in_each_other(*a, b);
    };
    require_body(
        std::none_of(a + 1, plan.parts.end(), hits),
        "A vehicle must be wide enough for its wheels: two of them are inside each other.");
  }
}

}  // namespace

void check(const BodyPlan& plan) {
  require_body(!plan.parts.empty(), "A robot's body needs a chassis.");
  const std::string positive =
      "All lengths, masses and the torque of a robot's body must be positive and finite.";
  std::size_t vehicles = 0;
  for (const Part& part : plan.parts) {
    const Vector3 &at = part.frame.origin, &size = part.shape.size;
    require_body(is_sound(part.shape) && std::isfinite(dot(at, at)) &&
                     (at.z > 0.0 || part.role != PartRole::wheel) && std::isfinite(part.mass) &&
                     part.mass >= 0.0,
                 positive);
    const bool is_first = part.vehicle == vehicles;
    if (is_first) ++vehicles;
    require_body(part.vehicle + 1 == vehicles && is_first == (part.role == PartRole::chassis),
                 "The parts of a body must stand vehicle by vehicle, each with its chassis first.");
    if (is_first) {
      require_body(is_positive(part.mass) && at.x == 0.0 && at.y == 0.0 && at.z > 0.5 * size.z,
                   positive);
      require_body(std::holds_alternative<HitchJoint>(part.joint) == (vehicles > 1),
                   "Each vehicle but the first hangs on a joint.");
    }
    require_body(is_first || !std::holds_alternative<FixedJoint>(part.joint),
                 "Only the chassis of a vehicle is fixed; its other parts are wheels and casters.");
    if (const auto* wheel = std::get_if<WheelJoint>(&part.joint)) check_wheel(*wheel, part);
    if (const auto* hitch = std::get_if<HitchJoint>(&part.joint)) check_hitch(*hitch);
    require_body(!std::holds_alternative<CasterJoint>(part.joint) ||
                     (part.shape.kind == Shape::Kind::sphere && is_positive(part.mass)),
                 "A caster must be a ball with a mass that is positive and finite.");
    constexpr double kRounding = 1e-9;  // m
    require_body(at.z - reach_of(part).z >= -kRounding,
                 "The part '" + part.name + "' of a robot's body is below the floor.");
  }
  check_wheels(plan);
}

}  // namespace elsie::world
