#include "templates.h"

#include <algorithm>
#include <set>
#include <utility>

#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/vocabulary.h"

#include "ids.h"

namespace elsie::world {

namespace {

bool is_list(const std::string& name) {
  return name == "segments" || name == "sensors" || name == "behaviors" || name == "coordinator" ||
         name == "drive";
}

// The lists in a behaviour that holds others.
bool is_held(const std::string& name) { return name == "behaviors" || name == "coordinator"; }

// The kind of the plugins in a list, if it has plugins.
std::optional<PluginKind> kind_in(const std::string& list) {
  return list == "sensors"       ? std::optional(PluginKind::sensor)
         : list == "behaviors"   ? std::optional(PluginKind::behavior)
         : list == "coordinator" ? std::optional(PluginKind::coordinator)
         : list == "drive"       ? std::optional(PluginKind::drive)
                                 : std::nullopt;
}

// The plugin's list that an element belongs to; an unknown element has a list of its own.
std::string list_of(const Declaration* declaration, const std::string& element) {
  const auto* declared =
      declaration ? plugin::find_declared(declaration->elements, element) : nullptr;
  return declared ? std::to_string(declared->list) : element;
}

void inherit_attributes(Element& over, const Element& base) {
  std::vector<Attribute> inherited;
  for (const Attribute& attribute : base.attributes) {
    if (!over.find(attribute.name)) {
      inherited.push_back(attribute);
    }
  }
  over.attributes.insert(over.attributes.end(), inherited.begin(), inherited.end());
}

}  // namespace

void Templates::merge_all(Element& world) {
  if (Element* robots = world.child("robots")) {
    for (Element& robot : robots->children) {
      complete_ids(robot, template_vocabulary());
      merge(robot);
    }
  }
}

void Templates::merge_given(Element& world) {
  Element* const robots = world.child("robots");
  for (std::size_t i = 0; robots && i < robots->children.size(); ++i) {
    if (Element& robot = robots->children[i]; robot.find("template")) {
      complete_ids(robot, template_vocabulary());
      merge(robot);
    }
  }
}

void Templates::merge(Element& robot) {
  const Attribute* reference = robot.find("template");
  if (!reference) {
    for (Element& child : robot.children) {
      if (is_list(child.name)) {
        drop_removals(child);
      }
    }
    return;
  }
  const Attribute from = *reference;
  robot.erase("template");
  const auto file = files_.find(from.value, from.where);
  const Element* base = nullptr;
  if (file) {
    base = load(*file, from.where);
  } else {
    problems_.add(from.where, "the template '" + from.value + "' is not there; looked " +
                                  files_.places(from.where, from.name, from.value));
  }
  if (base) {
    overlay(robot, *base);
  } else {
    robot.incomplete = true;
  }
}

const Element* Templates::load(const std::string& file, const Location& from) {
  const std::string key = Files::absolute(file);
  if (const auto cycle =
          std::find_if(open_.begin(), open_.end(),
                       [&](const std::string& open) { return Files::absolute(open) == key; });
      cycle != open_.end()) {
    std::string chain;
    for (auto i = cycle; i != open_.end(); ++i) {
      chain += *i + " -> ";
    }
    problems_.add(from, "a template includes itself: " + chain + file);
    return nullptr;
  }
  if (const auto known = loaded_.find(key); known != loaded_.end()) {
    return known->second ? &*known->second : nullptr;
  }
  std::optional<Element>& result = loaded_[key];
  try {
    Element root = parse_markup(read_text(file), file);
    const std::string format = root.value("format");
    const std::string right = "<robot_template format=\"" + std::to_string(kFormat) + "\">";
    if (root.name != "robot_template") {
      problems_.add(from, "the file '" + file + "' is no template: it begins with <" + root.name +
                              ">; expected " + right);
      return nullptr;
    }
    if (format != std::to_string(kFormat)) {
      problems_.add(
          from, "the template '" + file + "' has the format \"" + format + "\"; expected " + right);
      return nullptr;
    }
    root.erase("format");
    if (const Attribute* id = root.find("id")) {
      problems_.add(id->where, "a template has no id; the robots that use it have");
      root.erase("id");
    }
    complete_ids(root, template_vocabulary());
    open_.push_back(file);
    merge(root);
    open_.pop_back();
    if (!root.incomplete) {
      result = std::move(root);
    }
  } catch (const WorldError& error) {
    problems_.add(error);
  }
  return result ? &*result : nullptr;
}

void Templates::overlay(Element& robot, const Element& base) {
  inherit_attributes(robot, base);
  for (const Element& base_child : base.children) {
    Element* child = robot.child(base_child.name);
    if (is_list(base_child.name)) {
      overlay_group(robot, base_child);
    } else if (child) {
      inherit_attributes(*child, base_child);
    } else {
      robot.children.push_back(base_child);
    }
  }
  for (Element& child : robot.children) {
    if (is_list(child.name) && !base.child(child.name)) {
      drop_removals(child);
    }
  }
}

// <sensors>, <behaviors>, <coordinator>...: that of the template below the holder's own, if any.
void Templates::overlay_group(Element& holder, const Element& base) {
  Element* own = holder.child(base.name);
  if (!own) {
    holder.children.push_back(base);
  } else if ((base.name == "coordinator" || base.name == "drive") && !own->children.empty() &&
             !base.children.empty()) {
    overlay_only(*own, base);
  } else {
    overlay_list(*own, base);
  }
}

// Of a group with one element.
void Templates::overlay_only(Element& group, const Element& base) {
  Element& own = group.children.front();
  if (own.name != base.children.front().name) {
    drop_removals(group);  // another plugin replaces the template's
    return;
  }
  // There is one, whatever it is called: by default as in the template.
  Element renamed = base;
  Element& inherited = renamed.children.front();
  if (own.value("id") == own.name) {
    own.set("id", inherited.value("id"), own.where);
  } else {
    inherited.set("id", own.value("id"), own.where);
  }
  overlay_list(group, renamed);
}

void Templates::overlay_use(PluginKind kind, Element& use, const Element& base) {
  inherit_attributes(use, base);
  const Declaration* declaration = host_.find(kind, use.name);
  std::set<std::string> replaced;
  for (Element& child : use.children) {
    replaced.insert(list_of(declaration, child.name));
    if (is_held(child.name) && !base.child(child.name)) {
      drop_removals(child);
    }
  }
  for (const Element& base_child : base.children) {
    if (is_held(base_child.name)) {
      overlay_group(use, base_child);
    } else if (!replaced.contains(list_of(declaration, base_child.name))) {
      use.children.push_back(base_child);
    }
  }
}

void Templates::overlay_list(Element& list, const Element& base) {
  std::vector<Element> merged = base.children;
  std::vector<bool> used(merged.size(), false);
  std::vector<Element> added;
  std::vector<std::size_t> removed;
  for (Element& entry : list.children) {
    const std::string id = entry.value("id");
    const auto found = std::find_if(merged.begin(), merged.end(),
                                    [&](const Element& e) { return e.value("id") == id; });
    const auto index = static_cast<std::size_t>(found - merged.begin());
    if (found == merged.end() || used[index]) {
      added.push_back(std::move(entry));
      continue;
    }
    used[index] = true;
    if (entry.name != found->name) {
      problems_.add(entry.where, "'" + id + "' is a <" + found->name + "> in the template and a <" +
                                     entry.name +
                                     "> here; use another id, and remove=\"true\" to take away the "
                                     "template's");
    } else if (entry.value("remove") == "true") {
      removed.push_back(index);
    } else {
      if (const auto kind = kind_in(list.name)) {
        overlay_use(*kind, entry, *found);
      } else {
        inherit_attributes(entry, *found);
      }
      entry.erase("remove");
      *found = std::move(entry);
    }
  }
  for (auto index = removed.rbegin(); index != removed.rend(); ++index) {
    merged.erase(merged.begin() + static_cast<long>(*index));
  }
  list.children = std::move(added);
  drop_removals(list);
  list.children.insert(list.children.begin(), std::make_move_iterator(merged.begin()),
                       std::make_move_iterator(merged.end()));
}

// Takes out the entries of a list that have remove="true", to any depth, and all such attributes.
// Here there is nothing that they could remove.
void Templates::drop_removals(Element& list) {
  std::erase_if(list.children, [&](Element& entry) {
    for (Element& child : entry.children) {
      if (list.name == "behaviors" && is_held(child.name)) {
        drop_removals(child);
      }
    }
    const Attribute* remove = entry.find("remove");
    if (!remove) {
      return false;
    }
    const Attribute found = *remove;
    entry.erase("remove");
    if (found.value == "true") {
      problems_.add(found.where, "there is nothing to remove: the template has no '" +
                                     entry.value("id") + "' in its <" + list.name + ">");
    } else if (found.value != "false") {
      problems_.add(found.where, in_words(found, entry) + ": expected true or false");
    }
    return found.value == "true";
  });
}

}  // namespace elsie::world
