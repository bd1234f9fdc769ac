// Writing a world.
#pragma once

#include <string>

#include "elsie/world/description.h"

namespace elsie::world {

/// The world as the text of one file, with templates merged in: what is not the default is written,
/// numbers with as few digits as give the same value again. Reading the text gives an equal world,
/// except for the places where things stand in the file. To change a file that a user wrote, take
/// Document, which keeps everything else in it.
///
/// So that the text can move to other machines, files are named as PluginUse::file_names has them:
/// as the user wrote them or, what a template names, from the folder of World::file or a data
/// directory; a plugin's default file is not named at all. The text is to be saved in that folder,
/// and read with the same data directories. A file parameter that a program has set since is
/// written as it is.
std::string write_world(const World& world);

}  // namespace elsie::world
