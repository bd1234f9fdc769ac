// Reads the tree of a file into objects, by a vocabulary: for files of any kind.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// An element with mistakes in its attributes, or in the elements that describe its object further:
/// the object has defaults instead.
struct Flawed {
  const ElementSpec* spec;
  Location where;
};

/// Reads an element without plugins. Unknown elements and attributes, values that are not allowed
/// and missing ones become problems; their members keep the defaults. Returns the elements with
/// mistakes, those inside of others first.
std::vector<Flawed> read_object(const ElementSpec& spec, const Element& root, void* object,
                                Problems& problems);

/// Adds a problem and raises all of them when the root element is not `name` in this format: a file
/// of another format has another vocabulary. `hints` has a sentence for other root elements.
void check_root(const Element& root, const std::string& name, int format,
                const std::map<std::string, std::string>& hints, Problems& problems);

}  // namespace elsie::world
