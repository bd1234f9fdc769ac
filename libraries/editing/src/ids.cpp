// Default ids that the text of an edited world must contain.
#include <map>
#include <set>
#include <string>

#include "elsie/world/tree.h"

#include "own_text.h"

namespace elsie::editing {
namespace {

/// A tree whose default ids are counted anew.
Element renumbered(Element raw) {
  world::for_each_element(raw, [](Element& element) {
    std::erase_if(element.attributes, [](const Attribute& each) { return each.completed; });
  });
  world::complete_ids(raw);
  return raw;
}

class GivenIds {
 public:
  GivenIds(Element& raw, Names names) : raw_(raw), names_(names) {
    world::for_each_element(raw, [&](const Element& element) {
      for (const Attribute& attribute : element.attributes) {
        if (!attribute.completed) used_.insert(attribute.value);
      }
    });
  }

  void give() {
    // An id that is given shifts the numbers of others.
    while (give(raw_, renumbered(raw_), false, false) ||
           give(raw_, renumbered(raw_), false, true)) {
    }
  }

 private:
  /// Gives ids to those that would lose their name (`is_taken`: would get one that is used for
  /// another); returns whether there were any.
  bool give(Element& element, const Element& next, bool has_template, bool is_taken) {
    has_template |= element.name == "robot" && element.find("template");
    Attribute* const id = const_cast<Attribute*>(element.find("id"));
    bool gives = false;
    if (id && id->completed && id->value != next.value("id")) {
      gives = has_template || names_ == Names::all ||
              used_.contains(is_taken ? next.value("id") : id->value);
      id->completed = !gives;
    }
    for (std::size_t i = 0; i < element.children.size(); ++i) {
      gives |= give(element.children[i], next.children[i], has_template, is_taken);
    }
    return gives;
  }

  Element& raw_;
  const Names names_;
  std::set<std::string> used_;  // texts that may refer to a name, and other elements' names
};

}  // namespace

void give_ids(Element& raw, Names names) { GivenIds(raw, names).give(); }

}  // namespace elsie::editing
