// Layouts: the parts of a world that are drawn from a seed. <layouts> stands in a world's file; a
// running world contains the drawn robots and boxes instead.
//
// The core has the vocabulary, whose elements have no objects. What reads and draws them is the
// library plugin::part_file("layouts"), loaded for worlds that have layouts. docs/random-worlds.md
// says what they mean.
#pragma once

#include <optional>
#include <string>

#include "elsie/world/markup.h"
#include "elsie/world/reader.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

class Files;

/// <world> with <layouts> in it, which scatters what its other groups hold.
ElementSpec with_layouts(ElementSpec world);

/// Replaces the <layouts> of a world's tree, if there are any, by what they draw: ReadOptions::seed
/// is the run's. `drawn` gets the seed. Templates must have been merged. Adds a problem for
/// everything that cannot be drawn. Throws PluginError if the library cannot be loaded, which
/// exports a function of this type as `elsie_draw_layouts`.
using DrawLayouts = void(Element& world, const std::string& file, const plugin::Host& host,
                         const Files& files, const ReadOptions& options,
                         std::optional<Drawn>& drawn, Problems& problems);
DrawLayouts draw_layouts;

}  // namespace elsie::world
