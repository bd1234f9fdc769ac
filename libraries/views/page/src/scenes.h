// The scene of a world as data: what render::WorldScene has, with the body that moves each piece.
#pragma once

#include <string>
#include <vector>

#include "elsie/world/description.h"

#include "motion.h"

namespace elsie::page {

/// The members of a scene, as JSON. It says nothing of where bodies are. `images` gets the image of
/// the floor, if it is not there yet: scenes that differ in something else share it.
std::string scene_text(const world::World& world, Bodies& bodies, std::vector<std::string>& images);

}  // namespace elsie::page
