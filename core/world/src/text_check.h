// Finds what is wrong with the text of an XML file, which tinyxml2 refuses with few words or reads
// as something else; and the places of the elements.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/markup.h"

namespace elsie::world {

/// Whether tinyxml2 either reads this text as XML demands or refuses it. If not, the text may still
/// be right: check_text() decides. tinyxml2 alone accepts `< a>`, `</a b="1">`, `a="1"b="2"`, "<"
/// in values, unknown entities and end tags after the root, and takes a time that grows with the
/// square of an element's attributes. A plain text has no entities, and all its values stand in
/// double quotes: their number up to a character tells whether that character is in a value.
bool is_plain(std::string_view text);

/// Throws WorldError for the first mistake: characters, markup that is cut off, a document type
/// declaration, unknown entities, attributes that are not separated, not quoted, given twice or
/// more than 500, elements that are not closed by their own tags or nested deeper than 50 levels,
/// more than one root element, or none. `kind` is the expected root element. Returns the elements
/// in the order of their start tags; they point into the text.
std::vector<ElementSpan> check_text(std::string_view text, const std::string& file,
                                    const std::string& kind);

}  // namespace elsie::world
