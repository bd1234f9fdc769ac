// Checks the text of an XML file. tinyxml2 builds the tree, but says little about a text that it
// rejects, and does not find some mistakes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/markup.h"

namespace elsie::world {

/// Throws WorldError for the first mistake: bytes that are not UTF-8, control characters, a
/// document type declaration, an entity other than XML's five and character references, markup that
/// is cut off, attributes that are not separated, not quoted, given twice or more than 500,
/// elements that are not closed by their own tags or nested deeper than 50 levels, more than one
/// root element, or none. `kind` is the expected root element. Returns the elements in the order of
/// their start tags; they point into the text.
std::vector<ElementSpan> check_text(std::string_view text, const std::string& file,
                                    const std::string& kind);

}  // namespace elsie::world
