// Three wheels on a circle, 120 degrees apart, one of them behind the middle. Each rolls along the
// circle, and the rollers on its rim let it slide across:
//     r w_i = -vx sin a_i + vy cos a_i + R w
// for the wheel that stands at the angle a_i (Pin and Killough, "A new family of omnidirectional
// and holonomic wheeled platforms for mobile robots", 1994).
#include <numbers>

#include "rolling.h"

namespace {

class Omnidirectional final : public drives::RollingDrive {
 public:
  double radius = 0.0;

  /// The wheels of a differential drive that turns likewise: they stand on the same circle.
  elsie::WheelPair wheels(const elsie::Chassis& chassis) const override {
    return {chassis.wheel_radius, circle(chassis)};
  }

 private:
  /// The radius of the circle on which the wheels stand, m.
  double circle(const elsie::Chassis& chassis) const {
    return radius > 0.0 ? radius : std::max(chassis.half_axle, drives::sweep(chassis));
  }

  void add_wheels(const elsie::Chassis& chassis, elsie::BodyPlan& plan) const override {
    const double r = circle(chassis);
    for (int i = 0; i < 3; ++i) {
      const double at = (1.0 + 2.0 * i) / 3.0 * std::numbers::pi;
      const elsie::WheelJoint joint{.torque = chassis.wheel_torque, .rollers_rad = 0.0};
      plan.parts.push_back(drives::wheel(kNames[i], chassis, r * std::cos(at), r * std::sin(at),
                                         joint, at + 0.5 * std::numbers::pi));
    }
    drives::require_apart(plan, drives::sweep(chassis));
  }

  static constexpr const char* kNames[] = {"left_wheel", "rear_wheel", "right_wheel"};
};

ELSIE_DRIVE(
    Omnidirectional, "omnidirectional",
    "Three wheels with rollers, 120 degrees apart: moves in every direction",
    elsie::parameter("radius", &Omnidirectional::radius,
                     {.unit = "m",
                      .min = 0,
                      .max = 10,
                      .meaning = "of the circle on which the wheels stand; 0: half the axle "
                                 "of the body, or more where the wheels need it"}));

}  // namespace
