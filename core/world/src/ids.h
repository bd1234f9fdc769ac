// Default names of what a file leaves without an id.
#pragma once

#include "markup.h"

namespace elsie::world {

/// Gives each child without an id one of its own: its element's name, then that with _2, _3 ...;
/// `numbered`: with _1, _2, _3 ... from the first on, counting the elements of that name.
void complete_ids(Element& list, bool numbered);

/// The same for the obstacles, resources, chargers, sensors, behaviours and coordinators of a
/// world.
void complete_world_ids(Element& world);
/// ... and of a robot or a template.
void complete_robot_ids(Element& robot);

}  // namespace elsie::world
