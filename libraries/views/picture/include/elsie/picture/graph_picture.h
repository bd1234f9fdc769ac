// A coordinator's states or tree as a drawing.
#pragma once

#include <string>
#include <vector>

#include "elsie/simulation/simulation.h"

namespace elsie::picture {

/// Draws the graphs of a robot's coordinators, each in a frame if there are several, with what is
/// running, and what has succeeded or failed, in colour. Graphviz lays them out. `format`: "svg" or
/// "png". Returns the content of the file. Throws base::Error when Graphviz fails.
std::string draw_graphs(const std::vector<simulation::LitGraph>& graphs, const std::string& title,
                        const std::string& format);

}  // namespace elsie::picture
