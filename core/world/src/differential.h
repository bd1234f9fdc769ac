// The default drive of robots: two driven wheels on one axle, and two casters.
#pragma once

#include <span>
#include <vector>

#include "elsie/api/drive.h"

namespace elsie::world {

/// Adds a pair of wheels on one axle, one on each side.
void add_wheels(std::vector<Part>& parts, const Shape& wheel, double half_axle, double mass,
                const WheelJoint& joint);

/// Slows both wheels by the same factor if a command is too fast, so that the arc does not change.
class Differential final : public Drive {
 public:
  void build(const Chassis& chassis, BodyPlan& plan) override;
  Motion command(const Motion& asked, const DriveState& now,
                 std::span<JointSetting> joints) override;
  Motion odometry(std::span<const JointSetting> joints) const override;

 private:
  WheelPair pair_;
};

}  // namespace elsie::world
