// The scene of a world as data: what render::WorldScene has, with the body that moves each piece.
#pragma once

#include <string>

#include "elsie/world/description.h"

#include "motion.h"

namespace elsie::page {

/// The members of a scene, as JSON. It says nothing of where bodies are.
std::string scene_text(const world::World& world, Bodies& bodies);

}  // namespace elsie::page
