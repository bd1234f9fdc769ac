// The picture of a simulation from above, at this instant.
#pragma once

#include <functional>
#include <string>

#include "elsie/picture/top_view.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/tracks.h"

namespace elsie::recording {

/// The world in its current state with what its plugins draw and, with `tracks`, the robots' paths
/// so far. `warn` is called with a sentence for a plugin that fails to draw; the sketches of its
/// robot are left out. The view is valid until the next step or edit.
picture::TopView view_of(const simulation::Simulation& simulation,
                         const traces::TrackRecorder* tracks,
                         const std::function<void(const std::string&)>& warn);

}  // namespace elsie::recording
