#include "path.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <stdexcept>

#include "elsie/base/near_name.h"
#include "elsie/base/words.h"
#include "elsie/world/error.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

// Paths do not use declarations: they find the elements that exist.
const ElementSpec& nested_element() {
  static const ElementSpec spec;
  return spec;
}

namespace {

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

bool is_among(const std::vector<ElementSpec>& specs, const std::string& name) {
  return std::any_of(specs.begin(), specs.end(),
                     [&](const ElementSpec& spec) { return spec.name == name; });
}

// The children of a group that a step of this name means.
void collect_members(Element& group, const ElementSpec& spec, const std::string& name,
                     std::vector<Place>& found) {
  for (Element& child : group.children) {
    const ElementSpec* child_spec =
        spec.children.front().plugins ? &spec.children.front() : spec.child(child.name);
    if (child_spec && (name == spec.members || name == child.name)) {
      found.push_back({&child, child_spec});
    }
  }
}

std::vector<Place> children(const Place& place, const std::string& name) {
  std::vector<Place> found;
  if (place.spec->group) {
    collect_members(*place.element, *place.spec, name, found);
    return found;
  }
  for (const ElementSpec& spec : place.spec->below()) {
    for (Element& child : place.element->children) {
      if (child.name != spec.name) {
        continue;
      }
      if (name == spec.name && name != spec.members) {
        found.push_back({&child, &spec});
      } else if (spec.group) {
        collect_members(child, spec, name, found);
      }
    }
  }
  if (place.spec->plugins) {
    for (Element& child : place.element->children) {
      if (child.name == name && !is_among(place.spec->below(), name)) {
        found.push_back({&child, &nested_element()});
      }
    }
  }
  // "coordinator/fusion_vector_summation": the coordinator, named once more.
  if (found.empty() && place.spec->plugins && place.element->name == name) {
    found.push_back(place);
  }
  return found;
}

// The names that a step may have here.
std::vector<std::string> names_at(const Place& place) {
  std::vector<std::string> names;
  for (const ElementSpec& spec : place.spec->below()) {
    // What a plugin's element may hold is known by what is there.
    if (place.spec->plugins && !place.element->child(spec.name)) {
      continue;
    }
    names.push_back(spec.name);
    if (spec.group && spec.members != spec.name) {
      names.push_back(spec.members);
    }
  }
  for (const Element& child : place.element->children) {
    if (place.spec->plugins) {
      names.push_back(child.name);
    }
    for (const Element& member : child.children) {
      names.push_back(member.name);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string text_of(const PathStep& step) {
  return step.key.empty() ? step.name : step.name + "[" + step.key + "]";
}

// The one meant by the step's key.
std::vector<Place> chosen(const std::vector<Place>& places, const PathStep& step) {
  if (step.key == "*") {
    return places;
  }
  std::vector<std::string> ids;
  for (const Place& place : places) {
    ids.push_back(place.element->value("id"));
    if (!step.key.empty() && ids.back() == step.key) {
      return {place};
    }
  }
  ids.erase(std::remove(ids.begin(), ids.end(), ""), ids.end());
  const std::string count = std::to_string(places.size());
  if (step.key.empty()) {
    if (places.size() == 1) {
      return places;
    }
    refuse("'" + step.name + "' could be any of " + count + "; say which, as in " + step.name +
           "[" + (ids.empty() ? "1" : ids.front()) + "], or " + step.name + "[*] for all of them");
  }
  std::size_t number = 0;
  const char* end = step.key.data() + step.key.size();
  const auto parsed = std::from_chars(step.key.data(), end, number);
  const bool is_number = parsed.ec == std::errc() && parsed.ptr == end;
  if (is_number && number >= 1 && number <= places.size()) {
    return {places[number - 1]};
  }
  if (is_number || ids.empty()) {
    refuse("there is no " + text_of(step) + "; they are numbered from 1 to " + count);
  }
  // Few ids are listed; of many, only the nearest.
  refuse("there is no " + text_of(step) +
         (ids.size() > 10 ? base::near_or_all(step.key, ids, "there are")
                          : "; there are: " + base::listed(ids)));
}

Element empty_element(const std::string& name, const Place& parent) {
  Element made;
  made.name = name;
  made.where = parent.element->where;
  return made;
}

std::vector<Place> step_from(const Place& place, const PathStep& step) {
  std::vector<Place> found = children(place, step.name);
  if (!found.empty()) {
    return chosen(found, step);
  }
  for (const ElementSpec& spec : place.spec->below()) {
    if (spec.name != step.name || spec.name == spec.members || spec.plugins || spec.at_most > 1 ||
        !step.key.empty()) {
      continue;
    }
    return {{&add_in_order(place, empty_element(step.name, place)), &spec}};
  }
  return {};
}

// A part of a robot, named without a robot: that of every robot.
std::vector<Place> step_from_robots(const Place& world, const PathStep& step) {
  std::vector<Place> result;
  for (const Place& robot : children(world, "robot")) {
    const auto found = step_from(robot, step);
    result.insert(result.end(), found.begin(), found.end());
  }
  return result;
}

// Whether a missing element may be in a template that could not be read, which has its own message.
bool lacks_a_template(const std::vector<Place>& places) {
  return std::any_of(places.begin(), places.end(), [](const Place& place) {
    const auto robots = children(place, "robot");
    return place.element->incomplete ||
           std::any_of(robots.begin(), robots.end(),
                       [](const Place& robot) { return robot.element->incomplete; });
  });
}

// What a step may call an element that is to be added to a place.
std::vector<std::string> addable_at(const Place& place) {
  std::vector<std::string> names;
  for (const ElementSpec& spec :
       place.spec->group ? std::vector<ElementSpec>{*place.spec} : place.spec->below()) {
    names.push_back(spec.group ? spec.members : spec.name);
  }
  return names;
}

// Adds to the children of `holder`, as the n-th of those for which `counts` is true.
void insert(Element& holder, const PathStep& step, const Element& given,
            const std::function<bool(const Element&)>& counts) {
  std::vector<std::size_t> counted;
  for (std::size_t i = 0; i < holder.children.size(); ++i) {
    if (counts(holder.children[i])) {
      counted.push_back(i);
    }
  }
  std::size_t number = counted.size() + 1;
  if (step.key != "+") {
    const char* const end = step.key.data() + step.key.size();
    const auto parsed = std::from_chars(step.key.data() + 1, end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end || number < 1 ||
        number > counted.size() + 1) {
      refuse("an element cannot be added as " + text_of(step) + "; expected " + step.name +
             "[+] for the end, or a number from 1 to " + std::to_string(counted.size() + 1));
    }
  }
  const std::size_t at = number > counted.size() ? holder.children.size() : counted[number - 1];
  holder.children.insert(holder.children.begin() + static_cast<long>(at), given);
}

void require_name(const PathStep& step, const Element& given) {
  if (given.name != step.name) {
    refuse("the path adds a <" + step.name + ">, but the element is a <" + given.name + ">");
  }
}

void refuse_second(const Element& there, const std::string& held, const std::string& step) {
  refuse("<" + there.name + "> holds one " + held + ", which is there already; to replace it, " +
         "leave out the brackets: " + step + "=<...>");
}

void insert_member(Element& list, const ElementSpec& group, const PathStep& step,
                   const Element& given) {
  if (step.name != group.members) {
    require_name(step, given);
  }
  if (group.children.front().at_most == 1 && !list.children.empty()) {
    refuse_second(list, "element", group.members);
  }
  insert(list, step, given, [&](const Element& child) {
    return step.name == group.members || child.name == step.name;
  });
}

// Whether a place may hold what the step names; if so, it is added.
bool add_to(const Place& place, const PathStep& step, const Element& given) {
  const auto is_member = [&](const ElementSpec& group) {
    return group.group && (step.name == group.members || group.child(step.name));
  };
  const auto named_alike = [&](const Element& child) { return child.name == step.name; };
  if (place.spec->group) {
    const bool plugins = place.spec->children.front().plugins.has_value();
    if (!is_member(*place.spec) && !plugins) {
      return false;
    }
    insert_member(*place.element, *place.spec, step, given);
    return true;
  }
  for (const ElementSpec& spec : place.spec->below()) {
    if (is_member(spec)) {
      Element* list = place.element->child(spec.name);
      insert_member(list ? *list : add_in_order(place, empty_element(spec.name, place)), spec, step,
                    given);
      return true;
    }
    if (spec.name == step.name) {
      require_name(step, given);
      if (spec.at_most > 1) {
        insert(*place.element, step, given, named_alike);
        return true;
      }
      if (place.element->child(spec.name)) {
        refuse_second(*place.element, "<" + spec.name + ">", step.name);
      }
      add_in_order(place, given);
      return true;
    }
  }
  if (place.spec->plugins) {
    require_name(step, given);
    insert(*place.element, step, given, named_alike);
    return true;
  }
  return false;
}

}  // namespace

Element& add_in_order(const Place& parent, Element child) {
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

void add_element(Element& world, const Path& path, const Element& given) {
  Path parents = path;
  parents.steps.pop_back();
  const PathStep& step = path.steps.back();
  std::vector<Place> places = find_places(world, parents);
  if (places.empty()) {
    return;  // a robot's template could not be read
  }
  const Place first = places.front();
  std::size_t added = 0;
  for (const Place& place : places) {
    added += add_to(place, step, given) ? 1 : 0;
  }
  if (added == 0 && parents.steps.empty()) {  // of every robot
    for (const Place& robot : children(first, "robot")) {
      added += add_to(robot, step, given) ? 1 : 0;
    }
  }
  if (added == 0) {
    refuse("nothing called '" + step.name + "' can be added to <" + first.element->name + ">" +
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
        refuse(
            "an element that is added stands at the end of a path, as in "
            "robot[+]=<robot .../>; its attributes stand in it");
      }
      if (path.attribute.empty() || path.attribute.find_first_of("/[]@") != std::string::npos) {
        refuse("expected the name of an attribute after \"@\", at the end of the path");
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
        refuse("expected an id, a number or * in the brackets after '" + step.name + "'");
      }
      step.key = text.substr(1, close - 1);
      text.remove_prefix(close + 1);
    }
    if (step.name.empty()) {
      refuse("a step of the path is empty; a path looks like robot[r1]/@max_speed");
    }
    path.steps.push_back(std::move(step));
    if (text.empty()) {
      return path;
    }
    if (!text.starts_with('/')) {
      refuse("expected \"/\" before '" + std::string(text) + "'");
    }
    text.remove_prefix(1);
  }
}

namespace {

// How an element that is missing is added, if the path is that of an element.
std::string way_to_add(const Path& path, const PathStep& step) {
  return path.attribute.empty() && &step == &path.steps.back() && step.key.empty()
             ? "; to add one, write " + step.name + "[+] in the path"
             : "";
}

}  // namespace

std::vector<Place> find_places(Element& world, const Path& path) {
  std::vector<Place> places{{&world, &vocabulary()}};
  for (const PathStep& step : path.steps) {
    if (step.adds()) {
      refuse("an element that is added stands at the end of a path, as in robot[+]=<robot .../>");
    }
    std::vector<Place> next;
    for (const Place& place : places) {
      const auto found = step_from(place, step);
      next.insert(next.end(), found.begin(), found.end());
    }
    if (next.empty() && places.front().spec == &vocabulary()) {
      next = step_from_robots(places.front(), step);
    }
    if (next.empty() && lacks_a_template(places)) {
      return {};
    }
    if (next.empty()) {
      const auto names = names_at(places.front());
      const bool known = std::find(names.begin(), names.end(), step.name) != names.end();
      refuse("there is no '" + step.name + "' in <" + places.front().element->name + ">" +
             (known ? " of this world" + way_to_add(path, step)
                    : base::near_or_all(step.name, names, "there are")));
    }
    places = std::move(next);
  }
  return places;
}

}  // namespace elsie::world
