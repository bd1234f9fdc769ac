// Three wheels that are all driven and all steered, always alike: the body keeps its direction, and
// the robot's heading, with its sensors, is that of the wheels.
//     x' = v cos t,  y' = v sin t,  t' = w
#include <numbers>

#include "undercarriage.h"

namespace {

class Synchro final : public elsie::Drive {
 public:
  double radius = 0.0;
  double steer_rate_deg_s = 720.0;

  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override {
    wheel_radius_ = chassis.wheel_radius;
    const double r = radius > 0.0 ? radius : std::max(chassis.half_axle, drives::sweep(chassis));
    const elsie::WheelJoint joint{.torque = chassis.wheel_torque,
                                  .steered = true,
                                  .steer_rate_rad_s = elsie::radians(steer_rate_deg_s)};
    for (int i = 0; i < 3; ++i) {
      const double at = (1.0 + 2.0 * i) / 3.0 * std::numbers::pi;
      plan.parts.push_back(
          drives::wheel(kNames[i], chassis, r * std::cos(at), r * std::sin(at), joint));
    }
    drives::require_apart(plan, drives::sweep(chassis));
  }

  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override {
    const double most = elsie::radians(steer_rate_deg_s);
    const elsie::Motion possible{std::clamp(asked.forward, -now.max_speed, now.max_speed), 0.0,
                                 std::clamp(asked.turn, -most, most)};
    const double angle = mean_angle(now.joints) + possible.turn * now.period_s;
    for (elsie::JointSetting& joint : joints) {
      joint = {possible.forward / wheel_radius_, elsie::wrap_angle(angle), possible.turn};
    }
    return possible;
  }
  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const override {
    elsie::Motion sum;
    for (const elsie::JointSetting& joint : joints) {
      sum += {wheel_radius_ * joint.rate_rad_s, 0.0, joint.turn_rad_s};
    }
    return sum / static_cast<double>(joints.size());
  }
  elsie::Turret turret(std::span<const elsie::JointSetting> joints) const override {
    return {mean_angle(joints), odometry(joints).turn};
  }

 private:
  static constexpr const char* kNames[] = {"left_wheel", "rear_wheel", "right_wheel"};

  /// The angles of the wheels differ only by rounding, but may lie on both sides of the back.
  static double mean_angle(std::span<const elsie::JointSetting> joints) {
    double sum = 0.0;
    for (const elsie::JointSetting& joint : joints) {
      sum += elsie::wrap_angle(joint.angle_rad - joints.front().angle_rad);
    }
    return joints.empty() ? 0.0
                          : elsie::wrap_angle(joints.front().angle_rad +
                                              sum / static_cast<double>(joints.size()));
  }

  double wheel_radius_ = 0.02;
};

ELSIE_DRIVE(
    Synchro, "synchro", "Three wheels that steer and drive together; the body does not turn",
    elsie::parameter("radius", &Synchro::radius,
                     {.unit = "m",
                      .min = 0,
                      .max = 10,
                      .meaning = "of the circle on which the wheels stand; 0: half the axle "
                                 "of the body, or more where the wheels need it"}),
    elsie::parameter(
        "steer_rate_deg_s", &Synchro::steer_rate_deg_s,
        {.unit = "deg/s", .min = 1, .max = 10000, .meaning = "how fast the wheels turn together"}));

}  // namespace
