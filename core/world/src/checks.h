// What no single attribute can say: how the parts of a world fit together.
#pragma once

#include "elsie/world/error.h"
#include "elsie/world/markup.h"

#include "reading.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

/// `root` is the tree that the world was read from, templates and overrides included.
void check_world(const Reading& reading, const Element& root, const plugin::Host& host,
                 Problems& problems);

/// The part about places: what stands in the arena, and what in what. Static obstacles may overlap
/// one another and the walls (mazes are built so), and moving ones may pass through them; robots,
/// dynamic boxes and resources stand free.
void check_places(const Reading& reading, Problems& problems);

}  // namespace elsie::world
