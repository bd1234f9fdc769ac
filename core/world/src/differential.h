// The drive of a robot whose world names none: two driven wheels on one axle, and two casters.
#pragma once

#include <span>
#include <vector>

#include "elsie/api/drive.h"

namespace elsie::world {

/// Adds a pair of wheels on one axle, one to either side.
void add_wheels(std::vector<Part>& parts, const Shape& wheel, double half_axle, double mass,
                const WheelJoint& joint);

/// Both wheels of a command are slowed by the same factor, so that an arc stays the arc it was.
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
