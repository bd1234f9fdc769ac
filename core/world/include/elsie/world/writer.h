// Writes a world as XML.
#pragma once

#include <string>

#include "elsie/world/description.h"

namespace elsie::world {

/// The world as the text of one file, with templates merged in. Only values that differ from their
/// defaults are written; numbers have the fewest digits that give the same value. Reading the text
/// gives an equal world, except for locations.
///
/// Files have the names in PluginUse::file_names, so that the text can move to other machines: the
/// user's names or, for files of a template, names relative to the folder of World::file or a data
/// directory. A plugin's default file is not named. The text must be saved in that folder and read
/// with the same data directories. A file parameter set by a program is written unchanged.
std::string write_world(const World& world);

}  // namespace elsie::world
