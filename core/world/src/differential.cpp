#include "differential.h"

#include <algorithm>
#include <cmath>

namespace elsie::world {

void add_wheels(std::vector<Part>& parts, const Shape& wheel, double half_axle, double mass,
                const WheelJoint& joint) {
  for (const bool left : {true, false}) {
    parts.push_back({left ? "left_wheel" : "right_wheel",
                     PartRole::wheel,
                     wheel,
                     {.origin = {0.0, left ? half_axle : -half_axle, wheel.radius()}},
                     mass,
                     0,
                     joint});
  }
}

void Differential::build(const Chassis& chassis, BodyPlan& plan) {
  pair_ = wheels(chassis);
  add_wheels(plan.parts, Shape::wheel(chassis.wheel_radius, chassis.wheel_width), chassis.half_axle,
             chassis.wheel_mass, {.torque = chassis.wheel_torque});
  // Two balls, in front and at the rear. They are light, so that their spin has no effect.
  const double radius =
      std::min({0.5 * chassis.clearance, 0.125 * chassis.length, chassis.wheel_radius});
  const double half_base = 0.5 * chassis.length - 1.2 * radius;
  for (const bool front : {true, false}) {
    plan.parts.push_back({front ? "front_caster" : "rear_caster",
                          PartRole::caster,
                          Shape::sphere(radius),
                          {.origin = {(front ? 1.0 : -1.0) * half_base, 0.0, radius}},
                          0.02 * chassis.mass,
                          0,
                          CasterJoint{}});
  }
}

Motion Differential::command(const Motion& asked, const DriveState& now,
                             std::span<JointSetting> joints) {
  WheelRates rates = pair_.wheel_rates(asked);
  const double most = now.max_speed / pair_.radius;
  const double largest = std::max(std::abs(rates.left), std::abs(rates.right));
  if (largest > most) rates = (most / largest) * rates;
  joints[0] = {rates.left};
  joints[1] = {rates.right};
  return pair_.motion(rates);
}

Motion Differential::odometry(std::span<const JointSetting> joints) const {
  return pair_.motion({joints[0].rate_rad_s, joints[1].rate_rad_s});
}

ELSIE_DRIVE(Differential, "differential", "Two driven wheels on one axle, and two casters");

}  // namespace elsie::world
