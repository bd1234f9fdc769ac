#include "elsie/editing/between.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"
#include "elsie/world/world_tree.h"

#include "rewriting.h"

namespace elsie::editing {
namespace {

using world::WorldTree;

/// Members of a list by their ids; empty if one has no id of its own.
std::map<std::string, const Element*> by_id(const Element& list) {
  std::map<std::string, const Element*> members;
  for (const Element& member : list.children) {
    const std::string id = member.value("id");
    if (id.empty() || !members.emplace(id, &member).second) return {};
  }
  return members;
}

bool have_same_parts(const Element& a, const Element& b) {
  return a.name == b.name &&
         std::equal(
             a.children.begin(), a.children.end(), b.children.begin(), b.children.end(),
             [](const Element& one, const Element& other) { return one.name == other.name; });
}

class Between {
 public:
  Between(WorldTree& from, WorldTree& to) : from_(from), to_(to) { differ(from.root(), to.root()); }

  std::vector<std::string> edits;

 private:
  void differ(const Element& a, const Element& b) {
    const std::string& path = from_.path(a);
    if (path.empty() && !have_same_parts(a, b)) {
      throw world::WorldError({{"", 0,
                                "no edits lead from the running world to this one; reset the run "
                                "to begin with this one"}});
    }
    if (!have_same_parts(a, b)) {
      edits.push_back(path + "=" + markup_of(pruned(b)));
      return;
    }
    differ_in_attributes(a, b, path.empty() ? "@" : path + "/@");
    for (std::size_t i = 0; i < a.children.size(); ++i) {
      const world::ElementSpec* const spec = from_.meaning(a.children[i]).spec;
      if (spec && spec->group) {
        differ_in_members(a.children[i], b.children[i], path.empty() ? "" : path + "/");
      } else {
        differ(a.children[i], b.children[i]);
      }
    }
  }

  void differ_in_attributes(const Element& a, const Element& b, const std::string& start) {
    for (const Attribute& attribute : a.attributes) {
      if (!b.find(attribute.name)) edits.push_back(start + attribute.name + "/@remove=true");
    }
    for (const Attribute& attribute : b.attributes) {
      const Attribute* const old = a.find(attribute.name);
      if (!old || old->value != attribute.value) {
        edits.push_back(start + attribute.name + "=" + attribute.value);
      }
    }
  }

  void differ_in_members(const Element& a, const Element& b, const std::string& start) {
    if (alike(a, b)) return;
    const world::ElementSpec& group = *from_.meaning(a).spec;
    const auto before = by_id(a), after = by_id(b);
    const bool is_one = group.children.front().at_most == 1;
    if (is_one && a.children.size() == 1 && b.children.size() == 1) {
      differ(a.children.front(), b.children.front());
      return;
    }
    if (before.size() != a.children.size() || after.size() != b.children.size() ||
        !keep_order(a, b, before, after)) {
      edits.push_back(start + a.name + "=" + markup_of(pruned(b)));
      return;
    }
    // Numbers in paths count removed elements, so those are removed last.
    std::size_t added = 0;
    for (std::size_t j = 0; j < b.children.size(); ++j) {
      const Element& member = b.children[j];
      if (const auto known = before.find(member.value("id")); known != before.end()) {
        differ(*known->second, member);
        continue;
      }
      const auto next =
          std::find_if(b.children.begin() + static_cast<std::ptrdiff_t>(j), b.children.end(),
                       [&](const Element& later) { return before.contains(later.value("id")); });
      const std::string number =
          next == b.children.end()
              ? ""
              : std::to_string(before.at(next->value("id")) - a.children.data() + 1 +
                               static_cast<std::ptrdiff_t>(added));
      edits.push_back(start + group.members + "[+" + number + "]=" + markup_of(pruned(member)));
      ++added;
    }
    for (const auto& [id, member] : before) {
      if (!after.contains(id)) {
        edits.push_back(start + group.members + (is_one ? "" : "[" + id + "]") + "/@remove=true");
      }
    }
  }

  /// Whether the members that are in both lists are in the same order.
  static bool keep_order(const Element& a, const Element& b,
                         const std::map<std::string, const Element*>& before,
                         const std::map<std::string, const Element*>& after) {
    const auto common = [](const Element& list, const auto& other) {
      std::vector<std::string> ids;
      for (const Element& member : list.children) {
        if (other.contains(member.value("id"))) ids.push_back(member.value("id"));
      }
      return ids;
    };
    return common(a, after) == common(b, before);
  }

  /// The element without groups and elements that have no content.
  Element pruned(const Element& element) const {
    Element copy = element;
    copy.children.clear();
    for (const Element& child : element.children) {
      Element below = pruned(child);
      if (to_.meaning(child).is_listed || !below.attributes.empty() || !below.children.empty()) {
        copy.children.push_back(std::move(below));
      }
    }
    return copy;
  }

  WorldTree& from_;
  WorldTree& to_;
};

}  // namespace

std::vector<std::string> edits_between(const world::World& from, const world::World& to) {
  WorldTree from_tree(from), to_tree(to);
  return Between(from_tree, to_tree).edits;
}

}  // namespace elsie::editing
