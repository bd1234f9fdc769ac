// The drive of a robot whose world names none: two driven wheels on one axle, and two casters.
#pragma once

#include <span>

#include "elsie/api/drive.h"

namespace elsie::world {

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
