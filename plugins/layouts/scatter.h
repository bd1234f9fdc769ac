// Things at random places.
#pragma once

#include "bodies.h"
#include "described.h"

namespace elsie::layouts {

/// Adds the things of a <scatter> to the world, or a problem if they cannot be there.
void draw_scatter(Drawing& drawing, const Scatter& scatter, Occupied& occupied);

}  // namespace elsie::layouts
