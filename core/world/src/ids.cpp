#include "ids.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "elsie/world/tree.h"

namespace elsie::world {
namespace {

// `numbered`: ids always end in a number, which counts all elements of the same name.
void number(Element& list, bool numbered) {
  if (std::all_of(list.children.begin(), list.children.end(),
                  [](const Element& child) { return child.find("id"); })) {
    return;
  }
  std::set<std::string> taken;
  for (const Element& child : list.children) {
    if (const Attribute* id = child.find("id")) {
      taken.insert(id->value);
    }
  }
  std::map<std::string, int> count;
  for (Element& child : list.children) {
    const bool named = child.find("id") != nullptr;
    int number = named && !numbered ? 0 : ++count[child.name];
    if (named) continue;
    const auto name = [&] {
      return number == 1 && !numbered ? child.name : child.name + "_" + std::to_string(number);
    };
    while (!taken.insert(name()).second) {
      ++number;
    }
    child.set("id", name(), child.where);
    child.attributes.back().completed = true;
  }
}

}  // namespace

void yield_ids(Element& world, const ElementSpec& spec) {
  std::map<std::string, int> count;  // the number of uses of each completed id, besides these
  for_each_element(world, [&](const Element& element) {
    const Attribute* id = element.find("id");
    if (id && id->completed) count.try_emplace(id->value);
  });
  if (count.empty()) return complete_ids(world, spec);
  for_each_element(world, [&](const Element& element) {
    for (const Attribute& attribute : element.attributes) {
      const auto known = count.find(attribute.value);
      if (known != count.end() && !attribute.completed) ++known->second;
    }
  });
  for_each_element(world, [&](Element& list) {
    for (Element& child : list.children) {
      const Attribute* id = child.find("id");
      const auto is_given_it = [&](const Element& other) {
        const Attribute* given = other.find("id");
        return given && !given->completed && given->value == id->value;
      };
      if (id && id->completed && count[id->value] == 1 &&
          std::any_of(list.children.begin(), list.children.end(), is_given_it)) {
        child.erase("id");
      }
    }
  });
  complete_ids(world, spec);
}

void complete_ids(Element& element, const ElementSpec& spec) {
  for (const ElementSpec& group : spec.below()) {
    Element* list = element.child(group.name);
    if (list && !group.group && !group.plugins) complete_ids(*list, group);  // as in <scatter>
    if (!list || !group.group) continue;
    const ElementSpec& member = group.children.front();
    if (const AttributeSpec* id = member.attribute("id"); id && !id->required) {
      number(*list, !member.plugins);
    }
    for (Element& child : list->children) {
      complete_ids(child, member);
    }
  }
}

}  // namespace elsie::world
