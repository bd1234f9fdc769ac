// The poses of robots without channels of their own: for each sample one cloud of points, with
// three numbers of 64 bits for each robot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/simulation/simulation.h"

#include "format.h"

namespace elsie::recording {

/// Robots that get channels of their own when the recorder is not given any. A file has room for
/// 65,535 channels, and viewers list all of them.
constexpr std::size_t kMostWithChannels = 1000;

/// The text of the message. `robots`: places in the simulation, in the order of the points.
std::string crowd_text(std::uint64_t time_ns, const simulation::Simulation& simulation,
                       std::span<const std::size_t> robots);

/// The poses of a message. Throws Json::exception or Unexpected for one that Elsie did not write.
std::vector<Pose> crowd_poses(const Json& message);

}  // namespace elsie::recording
