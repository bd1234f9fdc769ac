// A simulation as a picture from above.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "elsie/picture/top_view.h"
#include "elsie/simulation/simulation.h"
#include "elsie/simulation/tracks.h"

/// Draws the world as it is now, the robots with the beams of their range sensors, and the way they
/// went so far when `tracks` is given. Throws as picture::save_top_view().
void draw(const elsie::simulation::Simulation& simulation,
          const elsie::simulation::TrackRecorder* tracks, const std::vector<std::string>& subtitles,
          const std::filesystem::path& file, int width,
          const elsie::picture::PathChoice& paths = {});
