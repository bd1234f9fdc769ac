// Draws a simulation from above.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "elsie/picture/top_view.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/tracks.h"

namespace elsie::program {

/// Draws the world in its current state with what its plugins draw and, with `tracks`, the robots'
/// paths so far; `bare`: see picture::TopView. Warns of a plugin that fails to draw, and leaves out
/// the sketches of its robot. Throws as picture::save_top_view().
void draw(const simulation::Simulation& simulation, const traces::TrackRecorder* tracks,
          const std::vector<std::string>& subtitles, const std::filesystem::path& file, int width,
          const picture::PathChoice& paths = {}, bool bare = false);

}  // namespace elsie::program
