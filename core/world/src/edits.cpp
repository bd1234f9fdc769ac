// --set PATH=VALUE: changes the tree of a world before it is checked.
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "elsie/base/near_name.h"
#include "elsie/world/tree.h"
#include "elsie/world/world_tree.h"

#include "ids.h"
#include "path.h"
#include "refusals.h"

namespace elsie::world {
namespace {
[[noreturn]] void fail(const std::string& message) { throw std::invalid_argument(message); }

Element element_of(const std::string& text, const Location& where) {
  if (!text.starts_with('<')) {
    fail(
        "the path leads to an element; expected an attribute at its end, as in "
        "robot[r1]/@max_speed, or an element after the \"=\", as in "
        "robot[r1]/coordinator=<arbiter_suppression/>");
  }
  Element element = parse_markup(text, where.file);
  for_each_element(element, [&](Element& each) {
    each.where = where;
    each.text_line = where.line;
    for (Attribute& attribute : each.attributes) {
      attribute.where = where;
    }
  });
  return element;
}

// Where an edit set something inside the element; null if none did.
const Location* set_in(const Element& root) {
  const Location* found = nullptr;
  const auto note = [&](const Location& where) {
    if (!found && where.is_edit() && where.file != root.where.file) {
      found = &where;
    }
  };
  for_each_element(root, [&](const Element& element) {
    note(element.where);
    if (element.removed_by) note(*element.removed_by);
    for (const Attribute& attribute : element.attributes) {
      note(attribute.where);
    }
  });
  return found;
}

/// Why nothing was changed: a step of a path selects by a value that nothing has.
constexpr const char* kLeadsNowhere =
    "the path leads to nothing in this world, and the edit has no effect";

// Replaces an element. It keeps its id, unless the new element has another id or the old id was
// only its default: then ids are completed as in a file.
void replace(Element& element, const Element& given) {
  if (const Location* lost = set_in(element)) {
    fail("this replaces the element in which '" + lost->file.text().substr(6) +
         "' is set before; set that afterwards, or in the new element");
  }
  const Attribute* const old = element.find("id");
  const std::optional<Attribute> id =
      old && old->value != element.name ? std::optional(*old) : std::nullopt;
  const Location where = given.where;
  element = given;
  if (id && !element.find("id")) {
    element.set("id", id->value, where);
    element.attributes.back().completed = id->completed;
  }
}

// `remove` in an element refers to a template's member with the same id; here is no template.
void require_without_removals(const Element& given) {
  for_each_element(given, [](const Element& element) {
    if (element.find("remove")) {
      fail("there is nothing that <" + element.name +
           " remove=\"...\"> could remove; to remove an element, end its path with "
           "@remove=true");
    }
  });
}

// List members, coordinators and elements that a plugin declares can be removed. Elements that
// every world or robot has exactly once cannot.
void require_removable(const Node& node) {
  const ElementSpec& spec = *node.spec;
  const std::string tag = "<" + node.element->name + ">";
  if (spec.root) {
    fail(
        "the world itself cannot be removed; expected the path of something in it, as in "
        "robot[r1]/@remove");
  }
  if (spec.group) {
    fail(tag + " is a list and cannot be removed; to empty it, remove what stands in it: " +
         spec.members + "[*]/@remove");
  }
  const bool is_listed = spec.at_most > 1 || spec.plugins || &spec == &nested_element();
  if (!is_listed) {
    fail(tag +
         " cannot be removed: it is always there, with its defaults where nothing is set; "
         "set its attributes instead");
  }
}

void require_true_or_false(const std::vector<Node>& nodes, const std::string& value) {
  if (value != "true" && value != "false") {
    fail("remove=\"" + value + "\" of <" + (nodes.empty() ? "robot" : nodes.front().element->name) +
         ">: expected true or false");
  }
}

void mark(const std::vector<Node>& nodes, const std::string& value, const Location& where) {
  require_true_or_false(nodes, value);
  for (const Node& node : nodes) {
    require_removable(node);
  }
  for (const Node& node : nodes) {
    node.element->removed_by = value == "true" ? std::optional(where) : std::nullopt;
  }
}

// Removes an attribute from the elements that have it.
void take_out(const std::vector<Node>& nodes, const std::string& attribute,
              const std::string& value, bool is_running) {
  require_true_or_false(nodes, value);
  if (value == "false" || nodes.empty()) return;
  std::size_t found = 0;
  for (const Node& node : nodes) {
    found += completed(*node.element).find(attribute) ? 1 : 0;
    node.element->erase(attribute);
  }
  const bool has_default = is_running && nodes.front().spec->attribute(attribute);
  if (found == 0 && !has_default) {
    const Element& first = *nodes.front().element;
    fail("<" + first.name + "> does not set '" + attribute + "'" +
         base::near_or_all(attribute, names_of(first.attributes), "it sets"));
  }
}
}  // namespace

std::size_t end_of_path(std::string_view edit) {
  std::size_t from = 0;
  while (true) {
    const std::size_t found = edit.find_first_of("[=", from);
    if (found == std::string_view::npos || edit[found] == '=') return found;
    const std::size_t close = edit.find(']', found);
    if (close == std::string_view::npos) return edit.find('=');
    from = close;
  }
}

Concern concern_of(const std::string& edit) {
  try {
    const Path path = parse_path(std::string_view(edit).substr(0, end_of_path(edit)));
    const std::string last = path.steps.empty() ? "" : path.steps.back().name;
    if (last == "robot" || last == "robots") {
      return path.attribute.empty()         ? Concern::robots
             : path.attribute == "template" ? Concern::templates
             : path.attribute == "remove"   ? Concern::removed_robots
                                            : Concern::other;
    }
  } catch (const std::invalid_argument&) {
    // apply_edit() reports the reason.
  }
  return Concern::other;
}

bool is_about_layouts(const std::string& edit) {
  const std::string first = edit.substr(0, edit.find_first_of("[/="));
  const ElementSpec& layouts = *vocabulary().child("layouts");
  return first == layouts.name || first == layouts.members || layouts.child(first);
}

std::pair<std::vector<Element*>, std::string> elements_at(Element& world, const std::string& path) {
  const Path parsed = parse_path(path);
  if (parsed.attribute.empty() || parsed.from_attribute) {
    fail("the path '" + path + "' leads to no attribute; expected one at its end, as in " +
         "robot[*]/@heading_deg");
  }
  std::vector<Element*> elements;
  for (const Node& node : find_nodes(world, parsed)) {
    elements.push_back(node.element);
  }
  return {elements, parsed.attribute};
}

void apply_edit(Element& world, const std::string& edit, bool is_running, Problems& problems) {
  const Location where{"--set " + edit, 0};
  try {
    const std::size_t equals = end_of_path(edit);
    if (equals == std::string::npos) fail("expected PATH=VALUE, as in robot[r1]/@max_speed=0.3");
    const Path path = parse_path(std::string_view(edit).substr(0, equals));
    const std::string value = edit.substr(equals + 1);
    Path to = path;
    if (to.adds()) to.steps.pop_back();
    const std::vector<Node> nodes = find_nodes(world, to);
    if (nodes.empty()) problems.remark(where, kLeadsNowhere);
    if (path.attribute == "remove" && !path.from_attribute) {
      mark(nodes, value, where);
      return;
    }
    if (path.from_attribute) {
      take_out(nodes, path.attribute, value, is_running);
    } else if (path.attribute.empty()) {
      const Element given = element_of(value, where);
      if (concern_of(edit) != Concern::robots) require_without_removals(given);
      if (path.adds()) {
        add_element(nodes, path.steps.back(), given);
      } else {
        for (const Node& node : nodes) {
          replace(*node.element, given);
        }
      }
    } else {
      for (const Node& node : nodes) {
        completed(*node.element).set(path.attribute, value, where);
      }
    }
    if (path.from_attribute || path.attribute.empty() || path.attribute == "id") {
      yield_ids(world, vocabulary());  // completed are those of what stands in a new element
    }
  } catch (const WorldError& error) {
    problems.add(where, error.problems().front().message);
  } catch (const std::invalid_argument& error) {
    problems.add(where, error.what());
  }
}

void remove_overridden(Element& world) {
  std::erase_if(world.children, [](const Element& child) { return child.removed_by.has_value(); });
  for (Element& child : world.children) {
    remove_overridden(child);
  }
}

}  // namespace elsie::world
