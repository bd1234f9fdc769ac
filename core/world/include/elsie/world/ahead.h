// What a world becomes by its own edits.
#pragma once

#include <vector>

#include "elsie/world/reader.h"

namespace elsie::world {

/// The world after the edits of each instant in World::changes, in order of time, as far as it does
/// not depend on what the run brings. Each is checked as a file is; files that an edit names are
/// searched beside the file with the edit. Throws WorldError with all edits that cannot be made,
/// each with its file and line.
std::vector<World> worlds_ahead(const World& world, const plugin::Host& host,
                                const ReadOptions& options);

/// A message about the text that a running world is written as, without the lines of that text,
/// which nobody has seen. `file` is the text's name.
std::string without_lines(std::string message, const std::string& file);

}  // namespace elsie::world
