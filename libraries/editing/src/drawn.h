// Which layout draws what an edit changes.
#pragma once

#include <string>

#include "elsie/world/markup.h"

namespace elsie::editing {

/// The layout whose <draw> draws an attribute which the edit has set; null if there is none.
/// `tree`: after the edit. The search may add empty elements to it.
const world::Element* layout_that_draws(world::Element& tree, const std::string& edit);

/// The layout that has drawn an element which the edit has changed; null if there is none. `tree`:
/// with the layouts; `drawn`: with what they draw, after the edit.
const world::Element* layout_that_made_edited(const world::Element& tree,
                                              const world::Element& drawn, const std::string& edit);

}  // namespace elsie::editing
