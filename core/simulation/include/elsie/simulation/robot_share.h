// The share of one behaviour in a robot's command.
#pragma once

#include <algorithm>

namespace elsie::simulation {

/// The share of a behaviour in the robot's command. `share`: in the command of its own coordinator;
/// a share below 0 counts as 0. `parent_share`: the share in the robot's command of the behaviour
/// that contains this coordinator; 1 for the robot's own coordinator.
inline double share_in_robot(double share, double parent_share) {
  return std::max(0.0, share) * parent_share;
}

}  // namespace elsie::simulation
