// The states of a world after its own timed edits.
#pragma once

#include <functional>
#include <string>

#include "elsie/world/reader.h"

namespace elsie::world {

/// Calls `visit` with the world after the edits of each instant in World::edits, in order of
/// time, without the effects of the run itself. Each world is checked like a file. Files that an
/// edit names are searched in the folder of the file with the edit. Throws WorldError with all
/// edits that cannot be made, each with its file and line.
void visit_edited_worlds(
    const World& world, const plugin::Host& host, const ReadOptions& options,
    const std::function<void(World)>& visit = [](const World&) {});

/// Why an edit that sets another physics/@engine is refused during a run.
inline constexpr const char* kEngineStays =
    "one engine cannot take over the bodies of another; set physics/@engine before the run";

}  // namespace elsie::world
