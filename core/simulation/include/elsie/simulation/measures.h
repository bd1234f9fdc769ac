// The measured values of a run, known before the run, and what measures see of decisions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "elsie/api/measure.h"
#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// The number of values that every run has; they come first in RunResult::measures.
inline constexpr std::size_t kMeasuresOfEveryRun = 6;

/// These values: success, time_s, path_length_m, collected, collisions, energy_left; of all robots.
std::vector<Quantity> measures_of_every_run();

/// The values in RunResult::measures for this world, with the same order and names: those of every
/// run, then those of the world's measures, "ID.NAME" or "ID". Does not run the world. Throws
/// world::WorldError when a measure refuses its parameters or the world, or when two values would
/// have the same name.
std::vector<Quantity> measure_names(const world::World& world, const plugin::Host& host);

/// The share of a behaviour in the robot's command. `share`: in the command of its own coordinator;
/// a share below 0 counts as 0. `parent_share`: the share in the robot's command of the behaviour
/// that contains this coordinator; 1 for the robot's own coordinator.
inline double share_in_robot(double share, double parent_share) {
  return std::max(0.0, share) * parent_share;
}

}  // namespace elsie::simulation
