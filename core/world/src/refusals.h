// Reasons why an element or attribute is not allowed at its place, as the end of a sentence.
#pragma once

#include <string>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/world/markup.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

/// The names of attributes, parameters or elements.
template <class List>
std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> names;
  for (const auto& each : list) {
    names.push_back(each.name);
  }
  return names;
}
/// The names of elements as tags: "<roam>".
template <class List>
std::vector<std::string> tags_of(const List& list) {
  std::vector<std::string> tags = names_of(list);
  for (std::string& tag : tags) {
    tag = "<" + tag + ">";
  }
  return tags;
}

/// " (line 12)", with the file or the edit if that is another one; "" for an attribute of a running
/// world, whose text nobody has seen.
std::string on_line(const Location& where, const Location& from);

/// Explains that no plugin of this kind has this name: it is of another kind, or was not found.
std::string explain_missing(const plugin::Host& host, PluginKind kind, const std::string& name);

/// Explains that the plugin with this declaration may not hold `child`.
std::string explain_child(const plugin::Host& host, const Declaration& declaration,
                          const Element& child);
/// The same of an element that a plugin declares.
std::string explain_inner(const plugin::DeclaredElement& declared, const Element& child);

}  // namespace elsie::world
