// An XML schema for world files.
#pragma once

#include <string>

#include "elsie/world/vocabulary.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::reference {

/// XSD 1.0 for worlds and robot templates, made of the core's vocabulary and of the declarations of
/// the plugins that the host has: any XML editor that is given it completes and checks names,
/// types, ranges, choices and ids. What takes more than one attribute to tell (what stands in what,
/// what a behaviour needs) is left to the reader.
std::string world_schema(const plugin::Host& host);

/// The same for files of another kind, whose vocabulary has no plugins of its own. `about` is what
/// the schema says of itself: "Experiment files of Elsie, format 1".
std::string schema_of(const world::ElementSpec& root, const std::string& about,
                      const plugin::Host& host);

}  // namespace elsie::reference
