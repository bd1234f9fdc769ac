// The pictures of sensors, for whoever shows or saves them.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "elsie/api/image.h"
#include "elsie/simulation/simulation.h"

namespace elsie::recording {

/// Calls `visit` for each picture of a sensor's current reading, with its name there, and with that
/// of its camera as "raw", if the reading lists none of that name. Empty pictures are left out.
/// Throws simulation::PluginFault.
void visit_pictures(const simulation::Simulation& simulation, std::size_t robot, std::size_t sensor,
                    const std::function<void(std::string_view name, const Image& image)>& visit);

}  // namespace elsie::recording
