// Robot templates: files whose content a robot element takes over and overrides.
#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "elsie/base/words.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/files.h"
#include "elsie/world/tree.h"
#include "elsie/world/vocabulary.h"

#include "ids.h"

namespace elsie::world {

namespace {

// The list of this name in a robot, or in a behaviour that holds others; null if there is none.
const ElementSpec* list_in(const ElementSpec& holder, const std::string& name) {
  const ElementSpec* found = plugin::find_declared(holder.below(), name);
  return found && found->group ? found : nullptr;
}

// The plugin's list that an element belongs to; an unknown element has a list of its own.
std::string declared_list(const Declaration* declaration, const std::string& element) {
  const auto* declared =
      declaration ? plugin::find_declared(declaration->elements, element) : nullptr;
  return declared ? std::to_string(declared->list) : element;
}

void inherit_attributes(Element& over, const Element& base) {
  std::vector<Attribute> inherited;
  std::copy_if(base.attributes.begin(), base.attributes.end(), std::back_inserter(inherited),
               [&](const Attribute& attribute) { return !over.find(attribute.name); });
  over.attributes.insert(over.attributes.end(), inherited.begin(), inherited.end());
}

class Templates {
 public:
  Templates(const plugin::Host& host, const Files& files, Problems& problems)
      : host_(host), files_(files), problems_(problems) {}

  void merge(Element& robot) {
    const Attribute* reference = robot.find("template");
    if (!reference) {
      drop_removals_in(template_vocabulary(), robot);
      return;
    }
    const Attribute from = *reference;
    robot.erase("template");
    const auto file = files_.find(from.value, from.where);
    const Element* base = file ? load(*file, from.where) : nullptr;
    if (!file) {
      problems_.add(from.where, "the template '" + from.value +
                                    "': " + files_.why_not(from.where, from.name, from.value));
    }
    if (base) {
      overlay(template_vocabulary(), robot, *base);
    } else {
      robot.incomplete = true;
    }
  }

 private:
  const Element* load(const std::string& file, const Location& from) {
    const std::string key = Files::absolute(file);
    const auto cycle = std::find_if(open_.begin(), open_.end(), [&](const std::string& open) {
      return Files::absolute(open) == key;
    });
    if (cycle != open_.end()) {
      std::vector<std::string> chain(cycle, open_.end());
      chain.push_back(file);
      problems_.add(from, "a template includes itself: " + base::joined(chain, " -> "));
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
        problems_.add(from, "the template '" + file + "' has the format \"" + format +
                                "\"; expected " + right);
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
      if (!root.incomplete) result = std::move(root);
    } catch (const WorldError& error) {
      problems_.add(error);
    }
    return result ? &*result : nullptr;
  }

  // Merges a template's element under the robot's own element; `spec` describes both.
  void overlay(const ElementSpec& spec, Element& own, const Element& base) {
    inherit_attributes(own, base);
    const Declaration* declaration = spec.plugins ? host_.find(*spec.plugins, own.name) : nullptr;
    std::set<std::string> replaced;
    for (Element& child : own.children) {
      replaced.insert(declared_list(declaration, child.name));
      const ElementSpec* list = list_in(spec, child.name);
      if (list && !base.child(child.name)) drop_removals(*list, child);
    }
    for (const Element& inherited : base.children) {
      Element* child = own.child(inherited.name);
      const ElementSpec* list = list_in(spec, inherited.name);
      if (child && list) {
        overlay_group(*list, *child, inherited);
      } else if (child && !spec.plugins) {
        inherit_attributes(*child, inherited);
      } else if (list || !replaced.contains(declared_list(declaration, inherited.name))) {
        own.children.push_back(inherited);
      }
    }
  }

  void overlay_group(const ElementSpec& group, Element& own, const Element& base) {
    const bool has_one = group.children.front().at_most == 1;
    if (!has_one || own.children.empty() || base.children.empty()) {
      overlay_list(group, own, base);
      return;
    }
    Element& only = own.children.front();
    if (only.name != base.children.front().name) {
      drop_removals(group, own);  // another plugin replaces the template's
      return;
    }
    // There is only one, whatever its id; by default it has the id in the template.
    Element renamed = base;
    Element& inherited = renamed.children.front();
    if (only.value("id") == only.name) {
      only.set("id", inherited.value("id"), only.where);
    } else {
      inherited.set("id", only.value("id"), only.where);
    }
    overlay_list(group, own, renamed);
  }

  void overlay_list(const ElementSpec& group, Element& list, const Element& base) {
    std::vector<Element> merged = base.children;
    std::vector<bool> used(merged.size(), false);
    std::vector<Element> added;
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
        problems_.add(entry.where,
                      "'" + id + "' is a <" + found->name + "> in the template and a <" +
                          entry.name +
                          "> here; use another id, and remove=\"true\" to take away the "
                          "template's");
      } else if (entry.value("remove") == "true") {
        found->removed_by = entry.where;
      } else {
        overlay(group.children.front(), entry, *found);
        entry.erase("remove");
        *found = std::move(entry);
      }
    }
    std::erase_if(merged, [](const Element& each) { return each.removed_by.has_value(); });
    list.children = std::move(added);
    drop_removals(group, list);
    list.children.insert(list.children.begin(), std::make_move_iterator(merged.begin()),
                         std::make_move_iterator(merged.end()));
  }

  // Removes the entries of a list that have remove="true", to any depth, and all such attributes,
  // because there is nothing that they could remove.
  void drop_removals(const ElementSpec& group, Element& list) {
    std::erase_if(list.children, [&](Element& entry) {
      drop_removals_in(group.children.front(), entry);
      const Attribute* remove = entry.find("remove");
      if (!remove) return false;
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

  void drop_removals_in(const ElementSpec& holder, Element& element) {
    for (Element& child : element.children) {
      if (const ElementSpec* list = list_in(holder, child.name)) drop_removals(*list, child);
    }
  }

  const plugin::Host& host_;
  const Files& files_;
  Problems& problems_;
  std::map<std::string, std::optional<Element>> loaded_;  // by absolute path; none: with problems
  std::vector<std::string> open_;                         // being loaded, outermost first
};

}  // namespace

void merge_templates(Element& world, const plugin::Host& host, const Files& files,
                     Problems& problems) {
  Templates templates(host, files, problems);
  if (Element* robots = world.child("robots")) {
    for (Element& robot : robots->children) {
      templates.merge(robot);
    }
  }
  if (Element* layouts = world.child("layouts")) {
    for (Element& scatter : layouts->children) {
      if (Element* robot = scatter.child("robot")) templates.merge(*robot);
    }
  }
}

}  // namespace elsie::world
