#include "undo.h"

#include <algorithm>
#include <optional>
#include <set>

#include "meaning.h"

namespace elsie::editing {

namespace {

class Undoing {
 public:
  explicit Undoing(const plugin::Host& host) : host_(host) {}

  void undo(const Element& before, const Element& after, const Element& now,
            const std::string& path, const Meaning& meaning) {
    undo_attributes(before, after, now, path);
    undo_children(before, after, now, path, meaning);
  }

  std::vector<std::string> edits;

 private:
  void add(const std::string& path, const std::string& end) { edits.push_back(path + end); }

  void undo_attributes(const Element& before, const Element& after, const Element& now,
                       const std::string& path) {
    const std::string start = path.empty() ? "@" : path + "/@";
    for (const Attribute& old : before.attributes) {
      const Attribute* attribute = after.find(old.name);
      if ((!attribute || attribute->value != old.value) && !old.completed) {
        add(start, old.name + "=" + old.value);
      }
    }
    for (const Attribute& attribute : after.attributes) {
      const Attribute* old = before.find(attribute.name);
      const bool is_new = !old || (old->completed && old->value != attribute.value);
      if (is_new && !attribute.completed && now.find(attribute.name)) {
        add(start, attribute.name + "/@remove=true");
      }
    }
  }

  // The element without default ids, which the reader adds.
  static Element as_given(Element element) {
    std::erase_if(element.attributes, [](const Attribute& each) { return each.completed; });
    for (Element& child : element.children) {
      child = as_given(std::move(child));
    }
    return element;
  }

  static bool is_list(const Meaning& meaning) { return meaning.spec() && meaning.spec()->group; }

  // The path of a child of `holder`, or of a new child before `number` others.
  std::string path_of(const Element& holder, const std::string& path, const Meaning& meaning,
                      std::size_t child, bool adds = false) const {
    const Element& element = holder.children[child];
    const Meaning below = meaning.child(element, host_);
    if (is_list(below)) {
      // Its members are named as if they were children of its holder, unless it has attributes.
      return below.spec()->attributes.empty() ? path
                                              : (path.empty() ? "" : path + "/") + element.name;
    }
    const bool single = !is_list(meaning) && below.spec() && below.spec()->at_most == 1;
    const std::string name = is_list(meaning) ? meaning.spec()->members : element.name;
    const std::string start = path.empty() ? "" : path + "/";
    if (single) {
      return start + name;
    }
    const auto counts = [&](const Element& other) {
      return is_list(meaning) || other.name == element.name;
    };
    const auto end = holder.children.begin() + static_cast<long>(child);
    const auto number = 1 + std::count_if(holder.children.begin(), end, counts);
    const Attribute* id = adds ? nullptr : element.find("id");
    const bool is_named = id && !id->completed;
    if (!adds && is_list(meaning) && below.spec() && below.spec()->at_most == 1) {
      return start + name;  // the one coordinator
    }
    return start + name + "[" + (adds ? "+" : "") +
           (is_named ? id->value : std::to_string(number)) + "]";
  }

  void undo_children(const Element& before, const Element& after, const Element& now,
                     const std::string& path, const Meaning& meaning) {
    std::set<std::size_t> kept;
    for (const Element& child : after.children) {
      if (child.object) {
        kept.insert(*child.object);
      }
    }
    const auto is_gone = [&](std::size_t i) {
      return i < before.children.size() && !kept.contains(*before.children[i].object);
    };
    if (loses_order(before, kept, meaning)) {
      add(path, "=" + markup_of(as_given(before)));
      return;
    }
    std::vector<std::size_t> added;
    std::vector<std::size_t> removed;
    std::size_t old = 0;
    for (std::size_t i = 0; i < after.children.size(); ++i) {
      const Element& child = after.children[i];
      if (!child.object) {
        if (is_gone(old)) {
          const Attribute* id = child.find("id");
          const Element& replaced = before.children[old++];
          const Attribute* old_id = replaced.find("id");
          add(path_of(now, path, meaning, i), "=" + markup_of(as_given(replaced)));
          if (id && !id->completed && old_id && old_id->completed) {  // the element kept its name
            add(path_of(now, path, meaning, i), "/@id/@remove=true");
          }
        } else {
          added.push_back(i);
        }
        continue;
      }
      while (is_gone(old)) {
        removed.push_back(old++);
      }
      undo(before.children[old++], child, now.children[i], path_of(now, path, meaning, i),
           meaning.child(child, host_));
    }
    while (is_gone(old)) {
      removed.push_back(old++);
    }
    for (auto i = added.rbegin(); i != added.rend(); ++i) {
      take_out(after.children[*i], now.children[*i], path_of(now, path, meaning, *i),
               meaning.child(after.children[*i], host_), is_list(meaning));
    }
    for (const std::size_t i : removed) {
      add(path_of(before, path, meaning, i, true), "=" + markup_of(as_given(before.children[i])));
    }
  }

  // Whether a removed element that a plugin declares was before one with another name. Its number
  // only gives its position among those with its own name.
  bool loses_order(const Element& before, const std::set<std::size_t>& kept,
                   const Meaning& meaning) const {
    if (!meaning.is_use()) {
      return false;
    }
    for (std::size_t i = 0; i + 1 < before.children.size(); ++i) {
      if (!kept.contains(*before.children[i].object) &&
          before.children[i].name != before.children[i + 1].name) {
        return true;
      }
    }
    return false;
  }

  // Removes an element that an edit has added.
  void take_out(const Element& element, const Element& now, const std::string& path,
                const Meaning& meaning, bool is_member) {
    if (is_list(meaning)) {
      for (std::size_t i = element.children.size(); i-- > 0;) {
        take_out(element.children[i], now.children[i], path_of(now, path, meaning, i),
                 meaning.child(element.children[i], host_), true);
      }
    } else if (is_member || meaning.is_declared() ||
               (meaning.spec() && meaning.spec()->at_most > 1)) {
      add(path, "/@remove=true");
    } else {
      for (const Attribute& attribute : element.attributes) {
        add(path, "/@" + attribute.name + "/@remove=true");
      }
    }
  }

  const plugin::Host& host_;
};

}  // namespace

std::vector<std::string> undoing(const Element& before, const Element& after, const Element& now,
                                 const plugin::Host& host) {
  Undoing undoing(host);
  undoing.undo(before, after, now, "", Meaning::of_world());
  return std::move(undoing.edits);
}

}  // namespace elsie::editing
