// The edits that lead from one world to another.
#pragma once

#include <string>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::editing {

/// Edits that turn a running world `from` into `to`, made together. Elements are matched by their
/// ids. An attribute is set, an element is added or removed; a list whose members are in another
/// order, or have no ids and differ, is replaced. Throws WorldError if no edits lead there.
std::vector<std::string> edits_between(const world::World& from, const world::World& to);

}  // namespace elsie::editing
