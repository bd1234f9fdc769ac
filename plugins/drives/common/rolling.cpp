#include "rolling.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/QR>

namespace drives {

void RollingDrive::build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) {
  add_wheels(chassis, plan);
  std::vector<Eigen::RowVector3d> rows;
  for (const Part& part : plan.parts) {
    const auto* joint = std::get_if<WheelJoint>(&part.joint);
    if (!joint) continue;
    radius_ = part.shape.radius();
    const double g = joint->rollers_rad.value_or(0.0);
    const double heading = std::atan2(part.frame.forward.y, part.frame.forward.x) + g;
    const double c = std::cos(heading), s = std::sin(heading);
    const elsie::Vector3& p = part.frame.origin;
    rows.emplace_back(Eigen::RowVector3d(c, s, s * p.x - c * p.y) / (radius_ * std::cos(g)));
  }
  rates_of_motion_.resize(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rates_of_motion_.row(static_cast<Eigen::Index>(i)) = rows[i];
  }
  motion_of_rates_ = rates_of_motion_.completeOrthogonalDecomposition().pseudoInverse();
}

elsie::Motion RollingDrive::command(const elsie::Motion& asked, const elsie::DriveState& now,
                                    std::span<elsie::JointSetting> joints) {
  const Eigen::VectorXd rates =
      rates_of_motion_ * Eigen::Vector3d(asked.forward, asked.lateral, asked.turn);
  const double factor = slowed(rates, now.max_speed / radius_);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    joints[i] = {factor * rates(static_cast<Eigen::Index>(i))};
  }
  return factor * asked;
}

elsie::Motion RollingDrive::odometry(std::span<const elsie::JointSetting> joints) const {
  Eigen::VectorXd rates(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    rates(static_cast<Eigen::Index>(i)) = joints[i].rate_rad_s;
  }
  const Eigen::Vector3d motion = motion_of_rates_ * rates;
  return {motion.x(), motion.y(), motion.z()};
}

}  // namespace drives
