// Writing a world.
#pragma once

#include <string>

#include "elsie/world/description.h"

namespace elsie::world {

/// The world as the text of one file, with templates merged in: what is not the default is written,
/// numbers with as few digits as give the same value again. Reading the text gives an equal world,
/// except for the places where things stand in the file. To change a file that a user wrote, take
/// Document, which keeps everything else in it.
std::string write_world(const World& world);

}  // namespace elsie::world
