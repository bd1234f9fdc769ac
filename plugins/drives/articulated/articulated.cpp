// Two halves on an axle each, steered by the joint between them. The front half has the chassis,
// two driven wheels, and the casters that keep it level; the rear half has the same size and rolls.
// With the joint a behind the front axle and b ahead of the rear one, and the rear half at the
// angle f to the front one, the front axle moves at v, and once the joint is still
//     w = -v sin(f) / (b + a cos(f))
// (Corke and Ridley, "Steering kinematics for a center-articulated mobile robot", 2001).
#include <array>
#include <numbers>

#include "undercarriage.h"

namespace {

class Articulated final : public elsie::Drive {
 public:
  double gap = 0.04;
  double max_steer_deg = 40.0;
  double steer_rate_deg_s = 90.0;
  double steer_torque = 0.1;

  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override {
    const double half_length = std::max(0.5 * chassis.length, chassis.wheel_radius);
    const double half_width =
        std::max(0.5 * chassis.width, chassis.half_axle + 0.5 * chassis.wheel_width);
    limit_ = elsie::radians(max_steer_deg);
    rate_ = elsie::radians(steer_rate_deg_s);
    const double touch = 2.0 * std::atan2(0.5 * gap, half_width);
    drives::require(limit_ <= touch, "its halves would touch at an angle of " +
                                         std::to_string(elsie::degrees(touch)) +
                                         " degrees; make 'gap' wider or 'max_steer_deg' smaller");
    arm_ = half_length + 0.5 * gap;
    pair_ = wheels(chassis);
    const elsie::Part front = plan.parts.front();
    const elsie::WheelJoint driven{.torque = chassis.wheel_torque};
    add_wheels(chassis, driven, "", 0, plan);
    const double ball = std::min({0.5 * chassis.clearance, 0.125 * chassis.length, pair_.radius});
    for (const bool ahead : {true, false}) {
      const double x = 0.5 * chassis.length - 1.2 * ball;
      plan.parts.push_back({ahead ? "front_caster" : "rear_caster",
                            elsie::PartRole::caster,
                            elsie::Shape::sphere(ball),
                            {.origin = {ahead ? x : -x, 0.0, ball}},
                            0.02 * chassis.mass,
                            0,
                            elsie::CasterJoint{}});
    }
    elsie::Part rear = front;
    rear.name = "rear/chassis";
    rear.vehicle = 1;
    rear.joint = elsie::HitchJoint{.behind = arm_,
                                   .ahead = arm_,
                                   .height = chassis.wheel_radius,
                                   .max_yaw_rad = limit_,
                                   .max_pitch_rad = elsie::radians(20.0),
                                   .torque = steer_torque,
                                   .yaw_rate_rad_s = rate_};
    plan.parts.push_back(rear);
    add_wheels(chassis, {}, "rear/", 1, plan);
  }

  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override {
    const double tightest = std::abs(curvature(limit_));
    double v = asked.forward;
    double angle = angle_of(now.joints);
    if (std::abs(asked.turn) > tightest * std::abs(v)) {
      // The foot of the perpendicular on the line of the tightest turn; the arm makes turns
      // comparable with speeds.
      const double lever = tightest * arm_;
      v = std::copysign((std::abs(v) + lever * arm_ * std::abs(asked.turn)) / (1.0 + lever * lever),
                        v);
      angle = std::copysign(limit_, -asked.turn * v);
    } else if (v != 0.0) {
      // Both arms are equal: w / v = -tan(f / 2) / a.
      angle = -2.0 * std::atan(arm_ * asked.turn / v);
    }
    const double from = angle_of(now.joints), most = rate_ * now.period_s;
    angle = std::clamp(std::clamp(angle, from - most, from + most), -limit_, limit_);
    elsie::WheelRates rates = pair_.wheel_rates({v, 0.0, curvature(angle) * v});
    rates =
        drives::slowed(std::array{rates.left, rates.right}, now.max_speed / pair_.radius) * rates;
    joints[0] = {rates.left};
    joints[1] = {rates.right};
    joints[2] = {0.0, angle};
    return odometry(joints);
  }
  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const override {
    const double v = 0.5 * pair_.radius * (joints[0].rate_rad_s + joints[1].rate_rad_s);
    return {v, 0.0, curvature(angle_of(joints)) * v};
  }

 private:
  static void add_wheels(const elsie::Chassis& chassis, const elsie::WheelJoint& joint,
                         const std::string& prefix, std::size_t vehicle, elsie::BodyPlan& plan) {
    for (const bool left : {true, false}) {
      plan.parts.push_back(drives::wheel(prefix + (left ? "left_wheel" : "right_wheel"), chassis,
                                         0.0, (left ? 1.0 : -1.0) * chassis.half_axle, joint));
      plan.parts.back().vehicle = vehicle;
    }
  }
  /// The curvature of the front half's path, 1/m.
  double curvature(double angle) const {
    return -std::sin(angle) / (arm_ * (1.0 + std::cos(angle)));
  }
  double angle_of(std::span<const elsie::JointSetting> joints) const {
    return joints.size() < 3 ? 0.0 : std::clamp(joints[2].angle_rad, -limit_, limit_);
  }

  double arm_ = 0.0;    // m, from either axle to the joint
  double limit_ = 0.0;  // rad
  double rate_ = 0.0;   // rad/s
  elsie::WheelPair pair_;
};

ELSIE_DRIVE(Articulated, "articulated", "Two halves, steered by the joint between them",
            elsie::parameter("gap", &Articulated::gap,
                             {.unit = "m",
                              .above = 0,
                              .max = 10,
                              .meaning = "between the halves when they stand in line"}),
            elsie::parameter("max_steer_deg", &Articulated::max_steer_deg,
                             {.unit = "deg",
                              .min = 1,
                              .max = 80,
                              .meaning = "how far the joint turns to either side"}),
            elsie::parameter(
                "steer_rate_deg_s", &Articulated::steer_rate_deg_s,
                {.unit = "deg/s", .min = 1, .max = 10000, .meaning = "how fast the joint turns"}),
            elsie::parameter("steer_torque", &Articulated::steer_torque,
                             {.unit = "N m",
                              .above = 0,
                              .max = 1e4,
                              .meaning = "what the motor of the joint can give"}));

}  // namespace
