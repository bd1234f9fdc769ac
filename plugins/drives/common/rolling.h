// Drives whose wheels all have motors and fixed directions: the rate of each is linear in the
// motion of the body.
#pragma once

#include <span>

#include <Eigen/Core>

#include "undercarriage.h"

namespace drives {

/// A drive that moves in every direction, by its Jacobian.
///
/// A wheel at p rolls in the direction e, and its rollers lie along d at the angle g from e. It is
/// free across d, so it only fixes d . (v + w x p) = r rate cos g, one row of the matrix (Muir and
/// Neuman, "Kinematic modeling of wheeled mobile robots", 1987). Tyres count as g = 0. Their grip
/// across the rolling direction is not part of this law: there they slide.
class RollingDrive : public elsie::Drive {
 public:
  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override;
  elsie::Channels channels() const override { return {true, true, true}; }
  /// Sets the rates for a motion and returns it, slowed as a whole where a rim would be too fast.
  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override;
  /// The motion that fits measured rates best (least squares).
  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const override;

 private:
  virtual void add_wheels(const elsie::Chassis& chassis, elsie::BodyPlan& plan) const = 0;

  double radius_ = 0.02;
  Eigen::Matrix<double, Eigen::Dynamic, 3> rates_of_motion_;
  Eigen::Matrix<double, 3, Eigen::Dynamic> motion_of_rates_;
};

}  // namespace drives
