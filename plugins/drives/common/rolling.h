// Drives whose wheels all have motors and fixed directions: the rate of each is linear in the
// motion of the body.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Dense>

#include "undercarriage.h"

namespace drives {

/// The Jacobian of such a drive, and what follows from it.
///
/// A wheel at p rolls in the direction e, and its rollers lie along d at the angle g from e. It is
/// free across d, so it only fixes d . (v + w x p) = r rate cos g, one row of the matrix (Muir and
/// Neuman, "Kinematic modeling of wheeled mobile robots", 1987). Tyres count as g = 0. Their grip
/// across the rolling direction is not part of this law: there they slide.
class Rolling {
 public:
  /// Takes the wheels of a body.
  void take(const BodyPlan& plan) {
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

  /// Sets the rates for a motion and returns it, slowed as a whole where a rim would be too fast.
  elsie::Motion command(const elsie::Motion& asked, double max_speed,
                        std::span<elsie::JointSetting> joints) const {
    const Eigen::VectorXd rates =
        rates_of_motion_ * Eigen::Vector3d(asked.forward, asked.lateral, asked.turn);
    const double factor = slowed(rates, max_speed / radius_);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      joints[i] = {factor * rates(static_cast<Eigen::Index>(i))};
    }
    return factor * asked;
  }

  /// The motion that fits measured rates best (least squares).
  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const {
    Eigen::VectorXd rates(static_cast<Eigen::Index>(joints.size()));
    for (std::size_t i = 0; i < joints.size(); ++i) {
      rates(static_cast<Eigen::Index>(i)) = joints[i].rate_rad_s;
    }
    const Eigen::Vector3d motion = motion_of_rates_ * rates;
    return {motion.x(), motion.y(), motion.z()};
  }

 private:
  double radius_ = 0.02;
  Eigen::Matrix<double, Eigen::Dynamic, 3> rates_of_motion_;
  Eigen::Matrix<double, 3, Eigen::Dynamic> motion_of_rates_;
};

}  // namespace drives
