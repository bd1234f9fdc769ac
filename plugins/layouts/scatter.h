// Things at random places.
#pragma once

#include "bodies.h"

namespace elsie::layouts {

/// Reads what a <scatter> says, and adds its things to the world. Adds a problem if they cannot be
/// there.
void draw_scatter(Drawing& drawing, const world::Scatter& scatter, const Element& element,
                  Occupied& occupied);

}  // namespace elsie::layouts
