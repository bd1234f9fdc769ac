// Changes the text of a file so that it says what an edited tree says.
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
  Element merged;  // with templates

  bool has(const Element& element) const {
    return element.object && *element.object < spans.size();
  }
};

/// What the text must say besides what has changed; elements are those of the edited tree.
struct Additions {
  std::set<const Element*> ids;  // elements whose completed ids must be given
  /// Members of templates that the lists must remove.
  std::map<const Element*, std::vector<Element>> removals;
  /// New members that override those of templates which the text removes by now.
  std::set<const Element*> in_place;
};

/// A replacement of a piece of a text.
struct Splice {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};
std::string spliced(std::string_view text, std::vector<Splice> splices);

/// The value as it stands between these quotes.
std::string quoted_value(const std::string& value, char quote);

/// The text in which `before`, one of its trees, has become `after`.
std::string rewritten(const WorldText& text, const Element& before, const Element& after,
                      const Additions& additions, const plugin::Host& host);

/// Whether two elements say the same.
bool alike(const Element& a, const Element& b);

}  // namespace elsie::editing
