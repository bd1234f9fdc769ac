// Which figures a run has, before it is made.
#pragma once

#include <cstddef>
#include <vector>

#include "elsie/api/measure.h"
#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// How many values every run has, whatever its world measures: they come first in
/// RunResult::measures.
inline constexpr std::size_t kMeasuresOfEveryRun = 6;

/// Those: success, time_s, path_length_m, collected, collisions, energy_left; over all robots.
std::vector<Quantity> measures_of_every_run();

/// What RunResult::measures of this world will hold, in that order, under the names that it has
/// there: those of every run, then the values of the world's measures, "ID.NAME" or "ID". Nothing
/// is run. Throws world::WorldError when a measure refuses its parameters or the world, or when two
/// values would have one name.
std::vector<Quantity> measure_names(const world::World& world, const plugin::Host& host);

}  // namespace elsie::simulation
