// What there is to draw: shapes on bodies, and where the bodies are.
#pragma once

#include <string>
#include <vector>

#include "elsie/simulation/simulation.h"
#include "elsie/snapshots/snapshots.h"

#include "link.h"

namespace elsie::server {

/// The shapes of a world, each with the body that carries it, and what cameras see of it. Bodies
/// are the vehicles of all robots, each robot's in a row, then the boxes; body -1 is the arena.
Json scene_json(const simulation::Simulation& simulation);

/// The bodies by name, in the same order: those of two worlds that have one name are one.
std::vector<std::string> body_names(const world::World& world);

/// Where the bodies are now.
void place_bodies(const simulation::Simulation& simulation,
                  std::vector<snapshots::BodyState>& bodies);
/// The rays of all range sensors, and the edges of the volumes that proximity sensors watch.
void list_beams(const simulation::Simulation& simulation, std::vector<snapshots::BeamState>& beams);

}  // namespace elsie::server
