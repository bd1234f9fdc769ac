// Writes a world as XML.
#pragma once

#include <string>

#include "elsie/world/description.h"

namespace elsie::world {

/// The world as the text of one file, with templates merged in. Values that differ from the default
/// are written, numbers with the fewest digits that give the same value. Reading the text gives an
/// equal world except for locations.
///
/// Files have the names of PluginUse::file_names, so that the text can move to other machines: the
/// user's names or, for those in a template, names from the folder of World::file or a data
/// directory; a plugin's default file is not named. The text must be saved in that folder and read
/// with the same data directories. A file parameter that a program has changed is written as it is.
std::string write_world(const World& world);

}  // namespace elsie::world
