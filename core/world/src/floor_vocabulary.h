// Lamps, the floor and its patches in a world file.
#pragma once

#include "elsie/world/describe.h"
#include "elsie/world/description.h"

namespace elsie::world {

ElementSpec lamp();
ElementSpec floor();
/// The group <patches>.
Describe<World> patches();

}  // namespace elsie::world
