// Changes the text of a file so that it says what an edited tree says.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/markup.h"

namespace elsie::editing {

using world::Attribute;
using world::Element;
using world::ElementSpan;

/// A replacement of a piece of a text.
struct Splice {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};
std::string spliced(std::string_view text, std::vector<Splice> splices);

/// The value as it is written between these quotes.
std::string quoted_value(const std::string& value, char quote);

/// The text after a change from `before`, the tree that it was read from, to `after`. An element of
/// `after` is the one of `before` with the same Element::object, which is its place in `spans`; one
/// without is new. Default ids are not written.
std::string rewritten(std::string_view text, const std::vector<ElementSpan>& spans,
                      const Element& before, const Element& after);

/// Whether two elements have equal contents. `Attribute::completed` and places do not count.
bool alike(const Element& a, const Element& b);

}  // namespace elsie::editing
