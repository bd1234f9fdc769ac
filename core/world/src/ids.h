// Default ids of elements that are edited; complete_ids() is in tree.h.
#pragma once

#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// Gives a member a new default id if its old one has since been given to another member of the
/// list, unless something else in the world uses that id.
void yield_ids(Element& world, const ElementSpec& spec);

}  // namespace elsie::world
