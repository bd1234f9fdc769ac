// The rewards that a world declares for a robot; see elsie/learning/reward_learner.h.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/description.h"

namespace elsie::program {

/// The ids of the measures that reward this robot, in the order of the world.
std::vector<std::string> rewards_of(const world::World& world, std::size_t robot,
                                    const plugin::Host& host);

/// The numbers of these measures now, in their order; 0 where there is none.
void read_rewards(const simulation::Simulation& simulation, std::span<const std::string> ids,
                  std::span<double> rewards);

}  // namespace elsie::program
