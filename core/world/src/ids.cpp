#include "ids.h"

#include <map>
#include <set>
#include <string>

namespace elsie::world {
namespace {

// `numbered`: ids always have a number, that among all elements of the name.
void number(Element& list, bool numbered) {
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
    if (named) {
      continue;
    }
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

void complete_ids(Element& element, const ElementSpec& spec) {
  for (const ElementSpec& group : spec.below()) {
    Element* list = group.group ? element.child(group.name) : nullptr;
    if (!list) {
      continue;
    }
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
