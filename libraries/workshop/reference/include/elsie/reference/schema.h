// An XML schema for world files.
#pragma once

#include <string>

#include "elsie/world/vocabulary.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::reference {

/// XSD 1.0 for worlds and robot templates, made from the core's vocabulary and the declarations of
/// the host's plugins: XML editors use it to complete and check names, types, ranges, choices and
/// ids. Conditions on several attributes (positions, what a behaviour needs) are left to the
/// reader.
std::string world_schema(const plugin::Host& host);

/// The same for another kind of file, whose vocabulary has no plugins. `about` is the schema's
/// description of itself: "Experiment files of Elsie, format 1".
std::string schema_of(const world::ElementSpec& root, const std::string& about,
                      const plugin::Host& host);

}  // namespace elsie::reference
