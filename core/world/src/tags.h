// What is wrong with the tags of an XML text. tinyxml2 reads every file, but says little about one
// that it refuses, and lets some mistakes pass.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace elsie::world {

inline constexpr std::size_t kDeepest = 50;  // levels: all later steps use recursion
inline constexpr std::size_t kMostAttributes =
    500;  // of an element: each is compared with the rest

/// Throws WorldError for the first mistake: a document type declaration, an entity other than XML's
/// five and character references, markup that is cut off, attributes that are not separated, not
/// quoted, given twice or too many, elements that are not closed by their own tags or nested too
/// deeply, more than one root element. `kind` is the root element that the file should have.
void check_tags(std::string_view text, const std::string& file, const std::string& kind);

}  // namespace elsie::world
