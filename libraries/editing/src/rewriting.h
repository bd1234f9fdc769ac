// Changes the text of a file so that it matches an edited tree.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/world/markup.h"

namespace elsie::editing {

using world::Element;
using world::ElementSpan;

/// The text of a world and the trees that were read from it. Element::object is the number of an
/// element's start tag in the text or, for an element of a template, a larger number.
struct WorldText {
  std::string text;
  std::vector<ElementSpan> spans;
  Element raw;     // with complete ids
  Element merged;  // with the content of templates

  bool has(const Element& element) const {
    return element.object && *element.object < spans.size();
  }
};

/// Additions to the text that go beyond the edit. The elements are those of the edited tree.
struct Additions {
  std::set<const Element*> ids;  // elements whose default ids must be written
  /// The members of templates that each list must remove.
  std::map<const Element*, std::vector<Element>> removals;
  /// New members that override members of templates which the text removes so far.
  std::set<const Element*> in_place;
};

/// A replacement of a piece of a text.
struct Splice {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};
std::string spliced(std::string_view text, std::vector<Splice> splices);

/// The value as it is written between these quotes.
std::string quoted_value(const std::string& value, char quote);

/// The text after a change from `before`, one of its trees, to `after`.
std::string rewritten(const WorldText& text, const Element& before, const Element& after,
                      const Additions& additions, const plugin::Host& host);

/// Whether two elements have equal contents.
bool alike(const Element& a, const Element& b);

}  // namespace elsie::editing
