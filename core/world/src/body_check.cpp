// Checks whether a robot's body is possible.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>

#include "elsie/world/footprint.h"
#include "elsie/world/parts.h"

namespace elsie::world {
namespace {

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

void require(bool holds, const Part& part, const char* what_it_must) {
  if (!holds) refuse("The part '" + part.name + "' of a robot's body " + what_it_must);
}

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

/// Whether the axes of a frame have length 1 and are at right angles.
bool is_sound(const Frame& frame) {
  constexpr double kRounding = 1e-6;
  const std::array axes{frame.forward, frame.left, frame.up};
  for (std::size_t a = 0; a < axes.size(); ++a) {
    for (std::size_t b = a; b < axes.size(); ++b) {
      // Written in this order, the comparison also rejects NaN.
      if (!(std::abs(dot(axes[a], axes[b]) - (a == b ? 1.0 : 0.0)) < kRounding)) return false;
    }
  }
  return std::isfinite(dot(frame.origin, frame.origin));
}

void check_wheel(const WheelJoint& wheel, const Part& part) {
  require(part.shape.kind == Shape::Kind::cylinder && part.shape.axis == Shape::Axis::left, part,
          "is a wheel, and must be a cylinder about the left axis of its frame.");
  require(std::isfinite(wheel.torque) && wheel.torque >= 0.0, part,
          "must have a torque that is finite and not negative.");
  require(wheel.torque != 0.0 ? is_positive(part.mass) : part.mass == 0.0, part,
          "must have a mass that is positive and finite if it has a motor, and none of its own "
          "if it has not.");
  require(!wheel.steered ||
              (is_positive(wheel.max_steer_rad) && wheel.max_steer_rad <= std::numbers::pi + 1e-9),
          part, "is steered, and must have a limit to either side, above 0 and up to pi.");
  require(!wheel.steered || is_positive(wheel.steer_rate_rad_s), part,
          "is steered, and must turn at a rate that is positive and finite.");
  require(!wheel.rollers_rad || std::abs(std::cos(*wheel.rollers_rad)) > 1e-3, part,
          "must not have rollers across the direction in which it rolls.");
}

void check_hitch(const HitchJoint& hitch, const Part& part) {
  require(is_positive(hitch.ahead) && std::isfinite(hitch.behind) && std::isfinite(hitch.height) &&
              hitch.behind >= 0.0 && hitch.height >= 0.0,
          part,
          "must hang on a joint that is ahead of its axle, not ahead of the middle of the body in "
          "front, and not below the floor.");
  require(hitch.max_yaw_rad > 0.0 && hitch.max_yaw_rad < std::numbers::pi &&
              hitch.max_pitch_rad > 0.0 && hitch.max_pitch_rad < 0.5 * std::numbers::pi,
          part,
          "must hang on a joint that turns by less than 180 degrees to either side, and bends by "
          "less than 90.");
  require(std::isfinite(hitch.torque) && hitch.torque >= 0.0 &&
              (hitch.torque == 0.0 || is_positive(hitch.yaw_rate_rad_s)),
          part,
          "must hang on a joint whose motor, if it has one, turns at a rate that is positive and "
          "finite.");
}

/// Checks that names are unique, and that wheels at their mounted angles do not overlap.
void check_pairs(const BodyPlan& plan) {
  const auto is_wheel = [](const Part& part) { return part.role == PartRole::wheel; };
  for (auto a = plan.parts.begin(); a != plan.parts.end(); ++a) {
    for (auto b = a + 1; b != plan.parts.end() && b->vehicle == a->vehicle; ++b) {
      if (a->name == b->name) refuse("Two parts of a robot's body are called '" + a->name + "'.");
      if (is_wheel(*a) && is_wheel(*b) &&
          overlap(footprint_of(a->shape, a->frame), footprint_of(b->shape, b->frame))) {
        refuse("A vehicle must be wide enough for its wheels: '" + a->name + "' and '" + b->name +
               "' are inside each other.");
      }
    }
  }
}

}  // namespace

void check(const BodyPlan& plan) {
  if (plan.parts.empty()) refuse("A robot's body needs a chassis.");
  std::size_t vehicles = 0;
  for (const Part& part : plan.parts) {
    const Vector3 &at = part.frame.origin, &size = part.shape.size;
    require(part.shape.kind != Shape::Kind::prism, part,
            "is a prism; only obstacles can be prisms.");
    require(is_sound(part.shape) && std::isfinite(part.mass) && part.mass >= 0.0, part,
            "must have lengths and a mass that are positive and finite.");
    require(is_sound(part.frame), part, "must have a frame of three unit vectors at right angles.");
    const bool is_first = part.vehicle == vehicles;
    if (is_first) ++vehicles;
    require(part.vehicle + 1 == vehicles && is_first == (part.role == PartRole::chassis), part,
            "is out of order: parts stand vehicle by vehicle, each with its chassis first.");
    if (is_first) {
      require(is_positive(part.mass) && at.x == 0.0 && at.y == 0.0 && at.z > 0.5 * size.z, part,
              "is a chassis, and must have a mass and stand above the origin, clear of the floor.");
      require(std::holds_alternative<HitchJoint>(part.joint) == (vehicles > 1), part,
              "must hang on a joint, as each chassis but the first does.");
    }
    require(is_first || !std::holds_alternative<FixedJoint>(part.joint), part,
            "must be a wheel or a caster: only the chassis of a vehicle is fixed.");
    if (const auto* wheel = std::get_if<WheelJoint>(&part.joint)) check_wheel(*wheel, part);
    if (const auto* hitch = std::get_if<HitchJoint>(&part.joint)) check_hitch(*hitch, part);
    require(!std::holds_alternative<CasterJoint>(part.joint) ||
                (part.shape.kind == Shape::Kind::sphere && is_positive(part.mass)),
            part, "is a caster, and must be a ball with a mass that is positive and finite.");
    constexpr double kRounding = 1e-9;  // m
    const double bottom = at.z - reach_of(part).z;
    require(bottom >= -kRounding, part, "is below the floor.");
    require(is_first || bottom <= kRounding, part, "is in the air: it must touch the floor.");
  }
  check_pairs(plan);
}

}  // namespace elsie::world
