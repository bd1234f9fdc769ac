// Default names of what a file leaves without an id.
#pragma once

#include "elsie/world/markup.h"

namespace elsie::world {

/// Gives each child without an id one of its own: its element's name, the next one that name with
/// _2, and so on. `numbered`: its element's name with its number among all elements of that name.
/// Ids that are given elsewhere in the list are passed over.
void complete_ids(Element& list, bool numbered);

/// The same for the obstacles, resources, chargers, measures, sensors, behaviours and coordinators
/// of a world.
void complete_world_ids(Element& world);
/// ... and of a robot, of a template, or of what a behaviour holds; those of behaviours go to any
/// depth.
void complete_robot_ids(Element& robot);

}  // namespace elsie::world
