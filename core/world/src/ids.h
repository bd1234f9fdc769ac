// Default ids of elements.
#pragma once

#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// Gives ids to the members of lists that may have one and have none, to any depth. `spec`: the
/// element's. A plugin's element gets its name, the next of that name the name with _2, and so on;
/// other elements always get a number. Ids in use are skipped.
void complete_ids(Element& element, const ElementSpec& spec);

/// Names a member by its place anew when another one of its list was given its id since, unless
/// something else in the world uses that id.
void yield_ids(Element& world, const ElementSpec& spec);

}  // namespace elsie::world
