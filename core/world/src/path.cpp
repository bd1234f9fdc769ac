#include "path.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>

#include "elsie/base/near_name.h"
#include "elsie/base/words.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/error.h"
#include "elsie/world/vocabulary.h"
#include "elsie/world/world_tree.h"

namespace elsie::world {

// Paths find existing elements, and do not use declarations.
const ElementSpec& nested_element() {
  static const ElementSpec spec;
  return spec;
}

namespace {

[[noreturn]] void refuse_path(const std::string& message) { throw std::invalid_argument(message); }

// Whether a step of this name may mean members of the group.
bool may_hold(const ElementSpec& group, const std::string& name) {
  return name == group.members || group.child(name) || group.children.front().plugins;
}

// The children that a step of this name means, including those of groups.
std::vector<Node> children(const Node& node, const std::string& name) {
  std::vector<Node> found;
  completed(*node.element);
  if (node.spec->group) {
    const ElementSpec& first = node.spec->children.front();
    for (Element& child : node.element->children) {
      const ElementSpec* spec = first.plugins ? &first : node.spec->child(child.name);
      if (spec && (name == node.spec->members || name == child.name)) {
        found.push_back({&child, spec});
      }
    }
    return found;
  }
  for (const ElementSpec& spec : node.spec->below()) {
    for (Element& child : node.element->children) {
      if (child.name != spec.name) continue;
      if (name == spec.name && name != spec.members) {
        found.push_back({&child, &spec});
      } else if (spec.group && may_hold(spec, name)) {
        const auto members = children({&child, &spec}, name);
        found.insert(found.end(), members.begin(), members.end());
      }
    }
  }
  const bool is_declared = node.spec == &nested_element();
  if (is_declared || (node.spec->plugins && !plugin::find_declared(node.spec->below(), name))) {
    for (Element& child : node.element->children) {
      if (child.name == name) {
        found.push_back({&child, &nested_element()});
      }
    }
  }
  // "coordinator/fusion_vector_summation" names the coordinator a second time.
  if (found.empty() && node.spec->plugins && node.element->name == name) found.push_back(node);
  return found;
}

// Adds what a world's layouts scatter, for a step of this name that means all.
void add_scattered(const Node& world, const std::string& name, std::vector<Node>& found) {
  for (const Node& scatter : children(world, "scatter")) {
    for (Element& thing : scatter.element->children) {
      for (const ElementSpec& group : world.spec->children) {
        const ElementSpec* spec = group.group ? group.child(thing.name) : nullptr;
        if (spec && (name == group.members || name == thing.name)) found.push_back({&thing, spec});
      }
    }
  }
}

// The names that a step may have at this node.
std::vector<std::string> names_at(const Node& node) {
  std::set<std::string> names;
  for (const ElementSpec& spec : node.spec->below()) {
    // Only existing elements of a plugin's element are known.
    if (node.spec->plugins && !node.element->child(spec.name)) continue;
    names.insert(spec.name);
    if (spec.group) names.insert(spec.members);
  }
  for (Element& child : node.element->children) {
    if (node.spec->plugins) names.insert(child.name);
    for (const Element& member : completed(child).children) {
      names.insert(member.name);
    }
  }
  return {names.begin(), names.end()};
}

// The text as a number; none if it is not a number as a whole.
std::optional<std::size_t> number_of(std::string_view text) {
  std::size_t number = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() ? std::optional(number)
                                                                             : std::nullopt;
}

std::string text_of(const PathStep& step) {
  return step.key.empty() ? step.name : step.name + "[" + step.key + "]";
}

// What a node's attribute has as its value; "plugin" is a plugin's name. Of plugins' elements only
// what is set is known. None: there is no such attribute.
std::optional<std::string> value_at(const Node& node, const std::string& attribute) {
  const Attribute* const set = completed(*node.element).find(attribute);
  if (set) return set->value;
  if (attribute == "plugin" && node.spec->plugins) return node.element->name;
  if (node.spec->plugins || node.spec == &nested_element()) return "";
  const AttributeSpec* const spec = node.spec->attribute(attribute);
  if (!spec) return std::nullopt;
  return spec->default_value ? plugin::format_value(*spec->default_value) : "";
}

// The nodes whose attribute has a value: none, one or several.
std::vector<Node> with_value(const std::vector<Node>& nodes, const PathStep& step) {
  const std::size_t equals = step.key.find('=');
  const std::string attribute = step.key.substr(0, equals), value = step.key.substr(equals + 1);
  std::vector<Node> found;
  bool is_known = false;
  for (const Node& node : nodes) {
    const std::optional<std::string> has = value_at(node, attribute);
    is_known |= has.has_value();
    if (has == value) found.push_back(node);
  }
  if (!is_known) {
    refuse_path(text_of(step) + ": no " + step.name + " has an attribute '" + attribute + "'");
  }
  return found;
}

// The nodes that the key of the step selects.
std::vector<Node> chosen(const std::vector<Node>& nodes, const PathStep& step) {
  if (step.key == "*") return nodes;
  if (step.selects_by_value()) return with_value(nodes, step);
  std::vector<std::string> ids;
  for (const Node& node : nodes) {
    const Attribute* id = node.element->find("id");
    if (id && !step.key.empty() && id->value == step.key) return {node};
  }
  for (const Node& node : nodes) {
    if (const Attribute* id = node.element->find("id")) ids.push_back(id->value);
  }
  std::erase(ids, "");
  const std::string count = std::to_string(nodes.size());
  if (step.key.empty()) {
    if (nodes.size() == 1) return nodes;
    refuse_path("'" + step.name + "' could be any of " + count + "; say which, as in " + step.name +
                "[" + (ids.empty() ? "1" : ids.front()) + "], or " + step.name +
                "[*] for all of them");
  }
  const auto number = number_of(step.key);
  if (number && *number >= 1 && *number <= nodes.size()) {
    return {nodes[*number - 1]};
  }
  if (number || ids.empty()) {
    refuse_path("there is no " + text_of(step) + "; they are numbered from 1 to " + count);
  }
  // All ids are listed if they are few, else only the nearest.
  refuse_path("there is no " + text_of(step) +
              (ids.size() > 10 ? base::near_or_all(step.key, ids, "there are")
                               : "; there are: " + base::listed(ids)));
}

Element empty_element(const std::string& name, const Node& parent) {
  Element made;
  made.name = name;
  made.where = parent.element->where;
  return made;
}

// `is_there` becomes true if there is something of that name, whether it is selected or not.
std::vector<Node> step_from(const Node& node, const PathStep& step, bool& is_there) {
  std::vector<Node> found = children(node, step.name);
  if (node.spec->root && (step.key == "*" || step.selects_by_value())) {
    add_scattered(node, step.name, found);
  }
  if (!found.empty()) {
    is_there = true;
    return chosen(found, step);
  }
  for (const ElementSpec& spec : node.spec->below()) {
    if (spec.name == step.name && spec.name != spec.members && !spec.plugins && spec.at_most == 1 &&
        step.key.empty()) {
      return {{&add_in_order(node, empty_element(step.name, node)), &spec}};
    }
  }
  return {};
}

// A hint how to add a missing element, if the path leads to an element.
std::string way_to_add(const Path& path, const PathStep& step) {
  return path.attribute.empty() && &step == &path.steps.back() && step.key.empty()
             ? "; to add one, write " + step.name + "[+] in the path"
             : "";
}

// A first step that names a part of a robot means that part of every robot.
std::vector<Node> step_from_robots(const Node& world, const PathStep& step, bool& is_there) {
  std::vector<Node> result;
  std::vector<Node> robots = children(world, "robot");
  add_scattered(world, "robot", robots);
  for (const Node& robot : robots) {
    const auto found = step_from(robot, step, is_there);
    result.insert(result.end(), found.begin(), found.end());
  }
  return result;
}

// Whether a missing element may be in an unreadable template, which has a message of its own.
bool lacks_a_template(const std::vector<Node>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(), [](const Node& node) {
    const auto robots = children(node, "robot");
    return node.element->incomplete ||
           std::any_of(robots.begin(), robots.end(),
                       [](const Node& robot) { return robot.element->incomplete; });
  });
}

// The names of elements that can be added to a node.
std::vector<std::string> addable_at(const Node& node) {
  std::vector<std::string> names;
  for (const ElementSpec& spec :
       node.spec->group ? std::vector<ElementSpec>{*node.spec} : node.spec->below()) {
    names.push_back(spec.group ? spec.members : spec.name);
  }
  return names;
}

// Inserts an element among the children of `holder`, as the n-th of those that `counts` accepts.
void insert(Element& holder, const PathStep& step, const Element& given,
            const std::function<bool(const Element&)>& counts) {
  std::vector<std::size_t> counted;
  for (std::size_t i = 0; i < holder.children.size(); ++i) {
    if (counts(holder.children[i])) counted.push_back(i);
  }
  const std::size_t end = counted.size() + 1;
  const std::size_t number =
      step.key == "+" ? end : number_of(std::string_view(step.key).substr(1)).value_or(0);
  if (number < 1 || number > end) {
    refuse_path("an element cannot be added as " + text_of(step) + "; expected " + step.name +
                "[+] for the end, or a number from 1 to " + std::to_string(end));
  }
  const std::size_t at = number == end ? holder.children.size() : counted[number - 1];
  holder.children.insert(holder.children.begin() + static_cast<long>(at), given);
}

void require_name(const PathStep& step, const Element& given) {
  if (given.name != step.name) {
    refuse_path("the path adds a <" + step.name + ">, but the element is a <" + given.name + ">");
  }
}

void refuse_second(const Element& there, const std::string& held, const std::string& step) {
  refuse_path("<" + there.name + "> holds one " + held +
              ", which is there already, written or by default; to replace it, leave out the "
              "brackets: " +
              step + "=<...>");
}

// Adds the element if the node may hold what the step names; returns whether it may.
bool add_to(const Node& node, const PathStep& step, const Element& given) {
  const auto named_alike = [&](const Element& child) { return child.name == step.name; };
  completed(*node.element);
  if (node.spec->group) {
    const ElementSpec& member = node.spec->children.front();
    const bool is_any = step.name == node.spec->members;
    if (!is_any && !member.plugins && !node.spec->child(step.name)) return false;
    if (!is_any) require_name(step, given);
    if (member.at_most == 1 && !node.element->children.empty()) {
      refuse_second(*node.element, "element", node.spec->members);
    }
    insert(*node.element, step, given,
           [&](const Element& child) { return is_any || named_alike(child); });
    return true;
  }
  for (const ElementSpec& spec : node.spec->below()) {
    if (spec.group && (step.name == spec.members || spec.child(step.name))) {
      Element* list = node.element->child(spec.name);
      return add_to({list ? list : &add_in_order(node, empty_element(spec.name, node)), &spec},
                    step, given);
    }
    if (spec.name == step.name) {
      require_name(step, given);
      if (spec.at_most > 1) {
        insert(*node.element, step, given, named_alike);
        return true;
      }
      if (node.element->child(spec.name)) {
        refuse_second(*node.element, "<" + spec.name + ">", step.name);
      }
      add_in_order(node, given);
      return true;
    }
  }
  if (node.spec->plugins || node.spec == &nested_element()) {
    require_name(step, given);
    insert(*node.element, step, given, named_alike);
    return true;
  }
  return false;
}

}  // namespace

Element& add_in_order(const Node& parent, Element child) {
  const auto& specs = parent.spec->below();
  const auto rank = [&](const std::string& name) {
    return std::find_if(specs.begin(), specs.end(),
                        [&](const ElementSpec& spec) { return spec.name == name; }) -
           specs.begin();
  };
  auto& children = parent.element->children;
  const auto after = std::find_if(children.begin(), children.end(), [&](const Element& other) {
    return rank(other.name) > rank(child.name);
  });
  return *children.insert(parent.spec->plugins ? children.end() : after, std::move(child));
}

void add_element(const std::vector<Node>& parents, const PathStep& step, const Element& given) {
  if (parents.empty()) return;
  const Node first = parents.front();
  std::size_t added = 0;
  for (const Node& node : parents) {
    added += add_to(node, step, given) ? 1 : 0;
  }
  if (added == 0 && first.spec->root) {  // the element is a part of every robot
    for (const Node& robot : children(first, "robot")) {
      added += add_to(robot, step, given) ? 1 : 0;
    }
  }
  if (added == 0) {
    refuse_path("nothing called '" + step.name + "' can be added to <" + first.element->name + ">" +
                base::near_or_all(step.name, addable_at(first), "there may be"));
  }
}

Path parse_path(std::string_view text) {
  Path path;
  const std::string whole(text);
  while (true) {
    if (text.starts_with('@')) {
      path.attribute = text.substr(1);
      if (path.attribute.ends_with("/@remove")) {
        path.attribute.resize(path.attribute.find('/'));
        path.from_attribute = true;
      }
      if (path.adds()) {
        refuse_path(
            "an element that is added stands at the end of a path, as in "
            "robot[+]=<robot .../>; its attributes stand in it");
      }
      if (path.attribute.empty() || path.attribute.find_first_of("/[]@") != std::string::npos) {
        refuse_path("expected the name of an attribute after \"@\", at the end of the path");
      }
      return path;
    }
    PathStep step;
    const std::size_t end = std::min(text.find_first_of("[/"), text.size());
    step.name = text.substr(0, end);
    text.remove_prefix(end);
    if (text.starts_with('[')) {
      const std::size_t close = text.find(']');
      if (close == std::string_view::npos || close == 1) {
        refuse_path("expected an id, a number, * or ATTRIBUTE=VALUE in brackets after '" +
                    step.name + "'" + (close == 1 ? "" : ", which are not closed by a ]"));
      }
      step.key = text.substr(1, close - 1);
      text.remove_prefix(close + 1);
    }
    if (step.name.empty()) {
      refuse_path("a step of the path is empty; a path looks like robot[r1]/@max_speed");
    }
    path.steps.push_back(std::move(step));
    if (text.empty()) return path;
    if (text.starts_with('[')) {
      refuse_path("'" + path.steps.back().name +
                  "' has more than one pair of brackets; expected one");
    }
    if (!text.starts_with('/')) refuse_path("expected \"/\" before '" + std::string(text) + "'");
    text.remove_prefix(1);
  }
}

std::vector<Node> find_nodes(Element& world, const Path& path) {
  std::vector<Node> nodes{{&world, &vocabulary()}};
  for (const PathStep& step : path.steps) {
    if (step.adds()) {
      refuse_path(
          "an element that is added stands at the end of a path, as in robot[+]=<robot .../>");
    }
    std::vector<Node> next;
    bool is_there = false;
    for (const Node& node : nodes) {
      const auto found = step_from(node, step, is_there);
      next.insert(next.end(), found.begin(), found.end());
    }
    if (next.empty() && nodes.front().spec == &vocabulary()) {
      next = step_from_robots(nodes.front(), step, is_there);
    }
    if (next.empty() && is_there) return {};
    if (next.empty() && lacks_a_template(nodes)) {
      return {};
    }
    if (next.empty()) {
      const auto names = names_at(nodes.front());
      const bool known = std::find(names.begin(), names.end(), step.name) != names.end();
      refuse_path("there is no '" + step.name + "' in <" + nodes.front().element->name + ">" +
                  (known ? " of this world" + way_to_add(path, step)
                         : base::near_or_all(step.name, names, "there are")));
    }
    nodes = std::move(next);
  }
  return nodes;
}

}  // namespace elsie::world
