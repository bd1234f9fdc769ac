// The part of a world that a picture shows.
#pragma once

#include <string>
#include <string_view>

#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

namespace elsie::picture {

/// Reads the world of a text without sensors, behaviours, coordinators, measures, rules, changes,
/// limits, and goals about time and events. The rest needs no plugin; a robot whose drive is not
/// among `drives` gets the default one; an image of the floor whose file is missing is left out.
/// `file` is the text's name in messages. Throws world::WorldError with all mistakes in the parts
/// that are shown.
world::World bodies_of(std::string_view text, const std::string& file, const plugin::Host& drives);

}  // namespace elsie::picture
