// Checks that concern more than one attribute of a world.
#pragma once

#include "elsie/world/error.h"
#include "elsie/world/markup.h"

#include "reading.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

/// `root` is the tree that the world was read from, after templates and overrides. `is_running`:
/// ReadOptions::is_running.
void check_world(const Reading& reading, const Element& root, const plugin::Host& host,
                 bool is_running, Problems& problems);

/// The part about places. Static obstacles may overlap each other and the walls, as in mazes, and
/// moving ones may pass through them; robots, dynamic boxes and resources must not overlap
/// anything.
void check_places(const Reading& reading, bool is_running, Problems& problems);

}  // namespace elsie::world
