// The part of the vocabulary about robots.
#pragma once

#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// <robot>; see also template_vocabulary() and coordination_vocabulary().
ElementSpec robot_element();

}  // namespace elsie::world
