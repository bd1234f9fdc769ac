#include "templates.h"

#include <algorithm>
#include <utility>

#include "elsie/world/vocabulary.h"

#include "ids.h"

namespace elsie::world {

namespace {

bool is_list(const std::string& name) {
  return name == "sensors" || name == "behaviors" || name == "coordinator";
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
      complete_robot_ids(robot);
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
                                  files_.places(from.where));
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
    complete_robot_ids(root);
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
    if (!child) {
      robot.children.push_back(base_child);
    } else if (base_child.name == "coordinator" && !child->children.empty() &&
               !base_child.children.empty() &&
               child->children.front().name != base_child.children.front().name) {
      drop_removals(*child);  // another coordinator replaces the template's
    } else if (is_list(base_child.name)) {
      overlay_list(*child, base_child);
    } else {
      inherit_attributes(*child, base_child);
    }
  }
  for (Element& child : robot.children) {
    if (is_list(child.name) && !base.child(child.name)) {
      drop_removals(child);
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
      inherit_attributes(entry, *found);
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

// Where there is nothing to take away.
void Templates::drop_removals(Element& list) {
  std::erase_if(list.children, [&](Element& entry) {
    const Attribute* remove = entry.find("remove");
    if (!remove) {
      return false;
    }
    const Attribute found = *remove;
    entry.erase("remove");
    if (found.value == "false") {
      return false;
    }
    if (found.value != "true") {
      problems_.add(found.where, "remove=\"" + found.value + "\" of <" + entry.name +
                                     ">: expected \"true\" or \"false\"");
      return false;
    }
    problems_.add(found.where, "there is nothing to remove: the template has no '" +
                                   entry.value("id") + "' in its <" + list.name + ">");
    return true;
  });
}

}  // namespace elsie::world
