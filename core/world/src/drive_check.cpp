#include "elsie/world/drive_check.h"

#include <cmath>

#include "elsie/base/number_text.h"

namespace elsie::world {
namespace {

using base::number_text;

std::string text(double value) { return number_text(value, 6); }

bool is_near(double a, double b) { return std::abs(a - b) <= 1e-6 * (1.0 + std::abs(a)); }

}  // namespace

std::string motion_text(const Motion& motion) {
  return "(" + text(motion.forward) + " m/s, " + text(motion.lateral) + " m/s, " +
         text(motion.turn) + " rad/s)";
}

bool is_near(const Motion& a, const Motion& b) {
  return is_near(a.forward, b.forward) && is_near(a.lateral, b.lateral) && is_near(a.turn, b.turn);
}

DriveCheck::DriveCheck(const BodyPlan& plan) {
  for (const Part& part : plan.parts) {
    if (!can_be_set(part.joint)) continue;
    if (const auto* wheel = std::get_if<WheelJoint>(&part.joint)) {
      limits_.push_back({part.shape.radius(), wheel->steered ? wheel->max_steer_rad : 0.0});
    } else if (const auto* hitch = std::get_if<HitchJoint>(&part.joint)) {
      limits_.push_back({0.0, hitch->max_yaw_rad});
    }
  }
}

std::string DriveCheck::problem(const Drive& drive, const Motion& possible, double max_speed,
                                std::span<const JointSetting> joints) const {
  bool is_finite = possible.is_finite();
  for (const JointSetting& joint : joints) {
    is_finite = is_finite && std::isfinite(joint.rate_rad_s + joint.angle_rad + joint.turn_rad_s);
  }
  if (!is_finite) return "command() gives numbers that are not finite";
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const double rim = std::abs(joints[i].rate_rad_s) * limits_[i].radius;
    if (rim > max_speed * (1.0 + kRounding)) {
      return "a wheel rolls at " + text(rim) + " m/s, and the most is " + text(max_speed) + " m/s";
    }
    if (std::abs(joints[i].angle_rad) > limits_[i].angle_rad + kRounding) {
      return "a joint is turned to " + text(joints[i].angle_rad) + " rad, and its limit is " +
             text(limits_[i].angle_rad) + " rad";
    }
  }
  const Motion odometry = drive.odometry(joints);
  return odometry.is_finite() && is_near(odometry, possible)
             ? ""
             : "odometry() of the joints that command() set is " + motion_text(odometry) +
                   ", and command() returned " + motion_text(possible);
}

}  // namespace elsie::world
