#include "elsie/editing/between.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "elsie/world/markup.h"
#include "elsie/world/world_tree.h"
#include "elsie/world/writer.h"

#include "rewriting.h"

namespace elsie::editing {

using world::Attribute;
using world::ReadOptions;
using world::World;
using world::WorldError;
using world::WorldTree;

namespace {

using Elements = std::vector<const Element*>;
using Places = std::vector<std::optional<std::size_t>>;

constexpr std::size_t kMostCompared = 4'000'000;  // pairs of elements of two lists

Element without_id(Element element) {
  element.erase("id");
  return element;
}

/// How likely it is that two elements are the same one; 0: they are not.
int likeness(const Element& a, const Element& b, bool may_be_renamed) {
  const std::string id = a.value("id");
  if (id != b.value("id")) {
    return may_be_renamed && !id.empty() && b.find("id") && alike(without_id(a), without_id(b)) ? 1
                                                                                                : 0;
  }
  const bool is_same = id.empty() ? alike(a, b) : a.name == b.name;
  return is_same ? 4 : !id.empty() ? 3 : a.name == b.name ? 2 : 0;
}

/// The ascending index in the first list of each element of the second, if it has one: the longest
/// common subsequence, weighted by likeness.
Places matched(const Elements& a, const Elements& b, bool may_be_renamed) {
  Places places(b.size());
  std::size_t begin = 0;
  while (begin < a.size() && begin < b.size() && likeness(*a[begin], *b[begin], false) == 4) {
    places[begin] = begin;
    ++begin;
  }
  std::size_t a_end = a.size(), b_end = b.size();
  while (a_end > begin && b_end > begin && likeness(*a[a_end - 1], *b[b_end - 1], false) == 4) {
    places[--b_end] = --a_end;
  }
  const std::size_t rows = a_end - begin, columns = b_end - begin;
  if (columns > 0 && rows > kMostCompared / columns) {
    std::map<std::string, std::size_t> known;
    for (std::size_t i = begin; i < a_end; ++i) {
      known.emplace(a[i]->value("id"), i);
    }
    for (std::size_t j = begin, next = begin; j < b_end; ++j) {
      const auto found = known.find(b[j]->value("id"));
      if (found != known.end() && found->second >= next) {
        places[j] = found->second;
        next = found->second + 1;
      }
    }
    return places;
  }
  std::vector<int> best((rows + 1) * (columns + 1), 0);
  const auto at = [&](std::size_t i, std::size_t j) -> int& { return best[i * (columns + 1) + j]; };
  const auto like = [&](std::size_t i, std::size_t j) {
    return likeness(*a[begin + i], *b[begin + j], may_be_renamed);
  };
  for (std::size_t i = rows; i-- > 0;) {
    for (std::size_t j = columns; j-- > 0;) {
      const int one = like(i, j);
      at(i, j) = std::max({at(i + 1, j), at(i, j + 1), one > 0 ? one + at(i + 1, j + 1) : 0});
    }
  }
  for (std::size_t i = 0, j = 0; i < rows && j < columns;) {
    const int one = like(i, j);
    if (one > 0 && at(i, j) == one + at(i + 1, j + 1)) {
      places[begin + j++] = begin + i++;
    } else {
      at(i, j) == at(i + 1, j) ? ++i : ++j;
    }
  }
  return places;
}

/// Adds elements first, and removes elements last, starting from the end. So numbers in paths have
/// the same meaning whether or not removed elements still count.
class Between {
 public:
  Between(WorldTree& from, WorldTree& to, bool may_be_renamed)
      : from_(from), to_(to), may_be_renamed_(may_be_renamed) {
    differ(from.root(), to.root());
  }

  std::vector<std::string> edits;

 private:
  using Meaning = WorldTree::Meaning;

  static std::string joined(const std::string& path, const std::string& step) {
    return path.empty() ? step : path + "/" + step;
  }
  static bool is_use(const Meaning& meaning) { return meaning.use && !meaning.nested; }

  void differ(const Element& a, const Element& b) {
    const Meaning& meaning = from_.meaning(a);
    if (a.name != b.name || (is_use(meaning) && parts(a, from_) != parts(b, to_))) {
      edits.push_back(meaning.path + "=" + markup(b));
      return;
    }
    if (meaning.spec && meaning.spec->group) {
      differ(all(a), all(b), meaning, meaning.spec->members);
      return;
    }
    std::set<std::string> lists;
    for (const Element* holder : {&a, &b}) {
      for (const Element& child : holder->children) {
        const Meaning& below = (holder == &a ? from_ : to_).meaning(child);
        if (below.spec && !below.spec->group && below.spec->at_most > 1) {
          lists.insert(child.name);
        }
      }
    }
    for (const std::string& name : lists) {
      differ(all(a, name), all(b, name), meaning, name);
    }
    std::size_t k = 0;  // children outside of lists are in both, in the same order
    for (const Element& child : a.children) {
      if (lists.contains(child.name)) {
        continue;
      }
      while (k < b.children.size() && lists.contains(b.children[k].name)) {
        ++k;
      }
      if (k < b.children.size()) {
        differ(child, b.children[k++]);
      }
    }
    differ_in_attributes(a, b, meaning.path);
  }

  void differ_in_attributes(const Element& a, const Element& b, const std::string& path) {
    const std::string start = joined(path, "@");
    for (const Attribute& attribute : a.attributes) {
      if (!b.find(attribute.name)) {
        edits.push_back(start + attribute.name + "/@remove=true");
      }
    }
    const auto set = [&](const Attribute& attribute) {
      const Attribute* old = a.find(attribute.name);
      if (!old || old->value != attribute.value) {
        edits.push_back(start + attribute.name + "=" + attribute.value);
      }
    };
    for (const Attribute& attribute : b.attributes) {
      if (attribute.name != "id") {
        set(attribute);
      }
    }
    if (const Attribute* id = b.find("id")) {
      set(*id);  // all other paths use the old id
    }
  }

  /// Compares two lists of the same holder, whose members paths call `name`.
  void differ(const Elements& a, const Elements& b, const Meaning& holder,
              const std::string& name) {
    const auto is_only = [](const Elements& list, const WorldTree& tree) {
      return list.size() == 1 && tree.meaning(*list.front()).spec->at_most == 1;
    };
    if (is_only(a, from_) && is_only(b, to_)) {
      differ(*a.front(), *b.front());
      return;
    }
    const Places places = matched(a, b, may_be_renamed_);
    std::vector<bool> stays(a.size(), false);
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (places[j]) {
        stays[*places[j]] = true;
        differ(*a[*places[j]], *b[j]);
      }
    }
    std::vector<std::size_t> place(a.size());  // the index among all elements, including added ones
    std::size_t count = 0, next = 0;
    const auto pass_until = [&](std::size_t end) {
      for (; next < end; ++next) {
        place[next] = count++;
      }
    };
    std::set<std::string> ids;
    std::size_t last = 0;  // the end of the elements that are also in `a`
    for (std::size_t j = 0; j < b.size(); ++j) {
      last = places[j] ? j + 1 : last;
    }
    for (std::size_t j = 0; j < b.size(); ++j) {
      ids.insert(b[j]->value("id"));
      if (places[j]) {
        pass_until(*places[j] + 1);
        continue;
      }
      if (j >= last) {
        pass_until(a.size());
      }
      ++count;
      edits.push_back(joined(holder.path, name) + "[+" + (j < last ? std::to_string(count) : "") +
                      "]=" + markup(*b[j]));
    }
    pass_until(a.size());
    for (std::size_t i = a.size(); i-- > 0;) {
      if (!stays[i]) {
        const std::string id = a[i]->value("id");
        const bool is_clear = !id.empty() && !ids.contains(id);
        const bool is_one = from_.meaning(*a[i]).spec->at_most == 1;
        edits.push_back(joined(holder.path, name) +
                        (is_one ? "" : "[" + (is_clear ? id : std::to_string(place[i] + 1)) + "]") +
                        "/@remove=true");
      }
    }
  }

  static Elements all(const Element& holder, const std::string& name = "") {
    Elements found;
    for (const Element& child : holder.children) {
      if (name.empty() || child.name == name) {
        found.push_back(&child);
      }
    }
    return found;
  }

  /// The parts of an element besides lists. Elements with different parts are not the same one.
  static std::vector<std::string> parts(const Element& element, const WorldTree& tree) {
    std::vector<std::string> names;
    for (const Element& child : element.children) {
      const Meaning& meaning = tree.meaning(child);
      if (!meaning.spec || meaning.spec->group || meaning.spec->at_most <= 1) {
        names.push_back(child.name);
      }
    }
    return names;
  }

  std::string markup(const Element& element) const { return markup_of(pruned(element)); }

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
  bool may_be_renamed_;
};

}  // namespace

bool lead_to(const World& to, const World& from, const std::vector<std::string>& edits,
             const plugin::Host& host, ReadOptions options) {
  options.found = nullptr;
  options.check_plugins = false;
  options.is_running = true;  // fewer checks: `to` has been checked already
  options.overrides = edits;
  try {
    const World there = world::parse_world(world::write_world(from), from.file, host, options);
    return world::write_world(there) == write_world(to);
  } catch (const WorldError&) {
    return false;
  }
}

std::vector<std::string> edits_between(const World& from, const World& to, const plugin::Host& host,
                                       const ReadOptions& options) {
  WorldTree from_tree(from), to_tree(to);
  for (const bool may_be_renamed : {true, false}) {
    std::vector<std::string> edits = Between(from_tree, to_tree, may_be_renamed).edits;
    if (lead_to(to, from, edits, host, options)) {
      return edits;
    }
  }
  throw WorldError({{to.file, 0, "there are no edits that lead from the one world to the other"}});
}

}  // namespace elsie::editing
