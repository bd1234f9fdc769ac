// A simulation as a picture from above.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "elsie/picture/top_view.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/tracks.h"

namespace elsie::program {

/// Draws the world as it is now, the robots with the beams of their range sensors, and the way they
/// went so far when `tracks` is given. Throws as picture::save_top_view().
void draw(const simulation::Simulation& simulation, const traces::TrackRecorder* tracks,
          const std::vector<std::string>& subtitles, const std::filesystem::path& file, int width,
          const picture::PathChoice& paths = {});

}  // namespace elsie::program
