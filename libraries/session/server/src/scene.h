// Data for drawing: shapes on bodies, and the frames of the bodies.
#pragma once

#include <string>
#include <vector>

#include "elsie/simulation/simulation.h"
#include "elsie/snapshots/snapshots.h"

#include "link.h"

namespace elsie::server {

/// The shapes of a world, each with the body that carries it, and the views of cameras. The bodies
/// are the vehicles of all robots, robot by robot, then the boxes; body -1 is the arena.
Json scene_json(const simulation::Simulation& simulation);

/// The names of the bodies, in the same order. A name stands for the same body in two worlds.
std::vector<std::string> body_names(const world::World& world);

/// Writes the current frames of the bodies.
void place_bodies(const simulation::Simulation& simulation,
                  std::vector<snapshots::BodyState>& bodies);
/// Lists the rays of all range sensors, and the edges of the volumes that proximity sensors watch.
void list_beams(const simulation::Simulation& simulation, std::vector<snapshots::BeamState>& beams);

}  // namespace elsie::server
