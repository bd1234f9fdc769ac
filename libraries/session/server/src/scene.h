// Data for drawing: shapes on bodies, and the frames of the bodies.
#pragma once

#include <string>
#include <vector>

#include "elsie/simulation/simulation.h"
#include "elsie/snapshots/snapshots.h"

#include "link.h"

namespace elsie::server {

/// The shapes of a world, each with the body that carries it. The bodies are the vehicles of all
/// robots, robot by robot, then the boxes; body -1 is the arena.
Json scene_json(const simulation::Simulation& simulation);

/// What robots shine, as shapes like those of lamps.
Json lights_json(const simulation::Simulation& simulation);

/// The names of the bodies, in the same order. A name stands for the same body in two worlds.
std::vector<std::string> body_names(const world::World& world);

/// Writes the current frames of the bodies.
void place_bodies(const simulation::Simulation& simulation,
                  std::vector<snapshots::BodyState>& bodies);

}  // namespace elsie::server
