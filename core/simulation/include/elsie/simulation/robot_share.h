// What part of a robot's command comes from one of its behaviours.
#pragma once

#include <algorithm>

namespace elsie::simulation {

/// The share in the robot's command, from that in the command of the coordinator one is inside of,
/// and from the share in the robot's command of the behaviour that has this coordinator (1 for the
/// robot's own). A coordinator may give a share below 0: it counts as none.
inline double share_in_robot(double share, double parent_share) {
  return std::max(0.0, share) * parent_share;
}

}  // namespace elsie::simulation
