// Computes the edits that undo others.
#pragma once

#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/world/markup.h"

namespace elsie::editing {

/// The edits that lead from a tree `after` back to `before`, in this order. `after` is the result
/// of an edit of `before`; elements that they share have the same Element::object. Paths refer to
/// `now`, which is `after` as it was read from its text.
std::vector<std::string> undoing(const world::Element& before, const world::Element& after,
                                 const world::Element& now, const plugin::Host& host);

}  // namespace elsie::editing
