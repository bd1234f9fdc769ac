// Why a run has not succeeded, for a window that says it in words.
#pragma once

#include <vector>

#include "elsie/simulation/simulation.h"
#include "elsie/traces/standstill.h"

#include "link.h"

namespace elsie::server {

/// `stuck`: the first twenty of these robots; `stuck_count`: how many there are; `troubled_count`:
/// how many of them are asked to move, which come first; `awaited_count`: for how many of those
/// that nobody asks to move an open goal waits, which come next.
Json standstills_json(const simulation::Simulation& simulation,
                      std::vector<traces::Standstill> found);

/// The goals to reach that are open, as far as numbers say how far: of each the name of its element
/// and what is missing. Those in an <any> are left out, because none of them is needed.
Json open_goals_json(const simulation::Simulation& simulation);

/// The last event that broke a goal to keep: `name`, `robot`, `detail` and `time_s`; null if there
/// is none.
Json broken_by_json(const simulation::Simulation& simulation);

}  // namespace elsie::server
