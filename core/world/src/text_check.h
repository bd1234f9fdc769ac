// What is wrong with the text of an XML file. tinyxml2 builds the tree, but says little about a
// text that it refuses, and lets some mistakes pass.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/markup.h"

namespace elsie::world {

/// Where an element stands in a text; all places are counted in bytes.
struct ElementSpan {
  struct Attribute {
    std::size_t begin = 0;  // of its name
    std::size_t name_end = 0;
    std::size_t value = 0;  // between the quotes
    std::size_t end = 0;    // after the closing quote
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t begin = 0;     // of its start tag
  std::size_t name_end = 0;  // of the name in that tag
  std::size_t open_end = 0;  // of that tag
  std::size_t close = 0;     // of its end tag, unless it is empty
  std::size_t end = 0;       // of the element
  bool empty = false;        // <roam/>
  std::size_t parent = kNone;
  std::vector<Attribute> attributes{};
};

/// Throws WorldError for the first mistake: bytes that are not UTF-8, control characters, a
/// document type declaration, an entity other than XML's five and character references, markup that
/// is cut off, attributes that are not separated, not quoted, given twice or more than 500,
/// elements that are not closed by their own tags or nested deeper than 50 levels, more than one
/// root element, or none. `kind` is the root element that the file should have. Returns the
/// elements in the order of their start tags; they point into the text.
std::vector<ElementSpan> check_text(std::string_view text, const std::string& file,
                                    const std::string& kind);

/// parse_markup() with the places of all elements, in the order of their start tags.
Element parse_markup(std::string_view text, const std::string& file, const std::string& kind,
                     std::vector<ElementSpan>& spans);

}  // namespace elsie::world
