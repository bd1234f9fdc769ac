// The edits that undo others.
#pragma once

#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/world/markup.h"

namespace elsie::editing {

/// The edits that lead from a tree `after` back to `before`, to be made in this order. `after` is
/// the result of an edit of `before`: Element::object says which elements they share. Paths lead
/// through `now`, which is `after` as it was read from its text.
std::vector<std::string> undoing(const world::Element& before, const world::Element& after,
                                 const world::Element& now, const plugin::Host& host);

}  // namespace elsie::editing
