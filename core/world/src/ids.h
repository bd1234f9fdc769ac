// Default ids of elements.
#pragma once

#include "elsie/world/markup.h"

namespace elsie::world {

/// Gives ids to the obstacles, resources, chargers, measures, sensors, behaviours and coordinators
/// of a world that have none: the element's name, the next of that name the name with _2, and so
/// on; obstacles, resources, chargers and segments always with a number. Ids in use are skipped.
void complete_world_ids(Element& world);
/// ... and of a robot, a template, or a behaviour that holds others, to any depth.
void complete_robot_ids(Element& robot);

}  // namespace elsie::world
