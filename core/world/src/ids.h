// Default ids of elements.
#pragma once

#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// Gives default ids to the members of lists that may have an id but have none, to any depth.
/// `spec` describes `element`. A plugin's element gets the plugin's name, the next one of that name
/// gets the name with _2, and so on. Other elements always get a number. Ids in use are skipped.
void complete_ids(Element& element, const ElementSpec& spec);

/// Gives a member a new default id if its old one has since been given to another member of the
/// list, unless something else in the world uses that id.
void yield_ids(Element& world, const ElementSpec& spec);

}  // namespace elsie::world
