// Reads the tree of a file of any kind into objects, as its vocabulary describes them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// An element with mistakes in its attributes, or in its inner elements that describe the same
/// object. The object has defaults instead.
struct Flawed {
  const ElementSpec* spec;
  Location where;
};

/// Reads an element without plugins. Unknown elements and attributes, missing attributes and
/// invalid values become problems; their members keep the defaults. Returns the elements with
/// mistakes, inner ones first.
std::vector<Flawed> read_object(const ElementSpec& spec, const Element& root, void* object,
                                Problems& problems);

/// Adds a problem and throws all problems if the root element is not `name` in this format, because
/// a file of another format has another vocabulary. `hints` has sentences for other root elements.
void check_root(const Element& root, const std::string& name, int format,
                const std::map<std::string, std::string>& hints, Problems& problems);

}  // namespace elsie::world
