#include "drawn.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "elsie/world/tree.h"
#include "elsie/world/vocabulary.h"

namespace elsie::editing {

using world::Attribute;
using world::Element;

namespace {

// The paths of all attributes that are drawn, each with the layout that draws it.
std::vector<std::pair<std::string, const Element*>> drawn_paths(const Element& layouts) {
  const auto& groups = world::vocabulary().children;
  const auto is_thing = [&](const Element& child) {
    return std::any_of(groups.begin(), groups.end(),
                       [&](const auto& group) { return group.group && group.child(child.name); });
  };
  std::vector<std::pair<std::string, const Element*>> paths;
  for (const Element& layout : layouts.children) {
    if (layout.name == "draw") paths.emplace_back(layout.value("path"), &layout);
    for (const Element& draw : layout.children) {
      const auto thing = std::find_if(layout.children.begin(), layout.children.end(), is_thing);
      if (draw.name != "draw" || thing == layout.children.end()) continue;
      paths.emplace_back(
          "scatter[" + layout.value("id") + "]/" + thing->name + "/" + draw.value("path"), &layout);
    }
  }
  return paths;
}

}  // namespace

const Element* layout_that_draws(Element& tree, const std::string& edit) {
  const Element* const layouts = tree.child("layouts");
  if (!layouts || edit.substr(0, world::end_of_path(edit)).find('@') == std::string::npos) {
    return nullptr;
  }
  for (const auto& [path, layout] : drawn_paths(*layouts)) {
    try {
      const auto [elements, attribute] = world::elements_at(tree, path);
      for (const Element* const element : elements) {
        const Attribute* const set = element->find(attribute);
        if (set && set->where.file == "--set " + edit) return layout;
      }
    } catch (const std::invalid_argument&) {
      // The path leads only to what is drawn.
    }
  }
  return nullptr;
}

const Element* layout_that_made_edited(const Element& tree, const Element& drawn,
                                       const std::string& edit) {
  const Element* const layouts = tree.child("layouts");
  if (!layouts) {
    return nullptr;
  }
  const std::string by_edit = "--set " + edit;
  for (const Element& list : drawn.children) {
    for (const Element& member : list.children) {
      bool is_edited = false;
      world::for_each_element(member, [&](const Element& element) {
        is_edited |= element.removed_by || element.where.file == by_edit ||
                     std::any_of(element.attributes.begin(), element.attributes.end(),
                                 [&](const Attribute& each) { return each.where.file == by_edit; });
      });
      for (const Element& layout : layouts->children) {
        // What a layout draws has the layout's `object`.
        if (is_edited && layout.object && layout.object == member.object) return &layout;
      }
    }
  }
  return nullptr;
}

}  // namespace elsie::editing
