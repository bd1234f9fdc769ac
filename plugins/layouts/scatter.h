// Things at random places.
#pragma once

#include "bodies.h"
#include "described.h"
#include "draws.h"

namespace elsie::layouts {

/// Adds the things of a <scatter> to the world, or a problem if they cannot be there. `draws`:
/// those of the world, made before a thing is given a place.
void draw_scatter(Drawing& drawing, const Scatter& scatter, PathDraws& draws, Occupied& occupied);

}  // namespace elsie::layouts
