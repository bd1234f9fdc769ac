// What a robot senses, does and hears, as messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "elsie/simulation/simulation.h"

#include "format.h"

namespace elsie::recording {

/// The schema of a robot's messages: its sensors and actuators, with their numbers.
std::string readings_schema(const simulation::Simulation& simulation, std::size_t robot);
/// The readings of sensors, and the commands that actuators carry out.
Json readings_message(const simulation::Simulation& simulation, std::size_t robot,
                      std::uint64_t decided_ns);
/// What the robot heard before the last decision.
Json heard_message(const simulation::Simulation& simulation, std::size_t robot,
                   std::uint64_t decided_ns);

}  // namespace elsie::recording
