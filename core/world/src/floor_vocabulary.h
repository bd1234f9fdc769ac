// Lamps, the floor, its patches and fields in a world file.
#pragma once

#include "elsie/world/describe.h"
#include "elsie/world/description.h"

namespace elsie::world {

ElementSpec lamp();
ElementSpec field();
ElementSpec floor();
/// The group <patches>.
Describe<World> patches();

}  // namespace elsie::world
