#include "own_text.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "elsie/world/error.h"
#include "elsie/world/tree.h"
#include "elsie/world/values.h"

#include "rewriting.h"

namespace elsie::editing {
namespace {

const Element* child_of(const Element* holder, const Element& like) {
  if (!holder || !like.object) return nullptr;
  const auto found =
      std::find_if(holder->children.begin(), holder->children.end(),
                   [&](const Element& child) { return child.object == like.object; });
  return found == holder->children.end() ? nullptr : &*found;
}

bool is_only(const Meaning& member) { return member.spec() && member.spec()->at_most == 1; }
bool has_one(const Meaning& list) {
  return list.spec() && list.spec()->group && list.spec()->children.front().at_most == 1;
}

/// The element of a template that a child with this name and id overrides; null if there is none.
const Element* overridden(const Element& base, const Element& child, const Meaning& list) {
  const bool is_member = list.spec() && list.spec()->group;
  const auto found =
      std::find_if(base.children.begin(), base.children.end(), [&](const Element& each) {
        return each.name == child.name &&
               (!is_member || has_one(list) || each.value("id") == child.value("id"));
      });
  return found == base.children.end() ? nullptr : &*found;
}

Element removal_of(const Element& member) {
  Element removal;
  removal.name = member.name;
  removal.set("id", member.value("id"), {});
  removal.set("remove", "true", {});
  return removal;
}

/// The place of a child in the text; after all others if it is not there.
double place_of(const Element* raw, const Element& child) {
  const Element* const found = child_of(raw, child);
  return found ? static_cast<double>(found - raw->children.data())
               : std::numeric_limits<double>::infinity();
}

std::vector<Element> in_order(std::vector<std::pair<double, Element>> placed) {
  std::stable_sort(placed.begin(), placed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Element> elements;
  for (auto& [place, element] : placed) {
    elements.push_back(std::move(element));
  }
  return elements;
}

bool same_with_ids(const Element& a, const Element& b) {
  const auto is_completed = [](const Element& element) {
    const Attribute* const id = element.find("id");
    return id && id->completed;
  };
  return a.object == b.object && is_completed(a) == is_completed(b) &&
         a.children.size() == b.children.size() &&
         std::equal(a.children.begin(), a.children.end(), b.children.begin(), same_with_ids);
}

}  // namespace

void put_in_order(Element& element, const ElementSpec& spec) {
  const bool of_plugins = spec.group && spec.children.front().plugins;
  const auto& below = spec.below();
  const auto rank = [&](const Element& child) {
    return std::find_if(below.begin(), below.end(),
                        [&](const ElementSpec& each) { return each.name == child.name; });
  };
  if (!spec.group && !spec.nested) {
    std::stable_sort(element.children.begin(), element.children.end(),
                     [&](const Element& a, const Element& b) { return rank(a) < rank(b); });
  }
  for (Element& child : element.children) {
    const auto known = of_plugins ? below.begin() : rank(child);
    if (known != below.end()) {
      put_in_order(child, *known);
    }
  }
}

Element OwnText::of(Element& wanted, const Element* before, const Element* raw, const Element* base,
                    const Meaning& meaning) const {
  if (raw && before && alike(wanted, *before) && same_with_ids(wanted, *before)) {
    return *raw;
  }
  if (raw && !base && raw->name == "robot" && raw->find("template")) {
    const Element inherited = template_of(*raw);
    return of(wanted, before, raw, &inherited, meaning);
  }
  Element own;
  own.name = wanted.name;
  own.text = wanted.text;
  if (raw) own.object = raw->object;
  take_attributes(wanted, raw, base, meaning, own);
  if (base) {
    override_children(wanted, before, raw, *base, meaning, own);
    return own;
  }
  for (Element& child : wanted.children) {
    own.children.push_back(of(child, child_of(before, child), child_of(raw, child), nullptr,
                              meaning.child(child, host_)));
  }
  return own;
}

void OwnText::take_attributes(Element& wanted, const Element* raw, const Element* base,
                              const Meaning& meaning, Element& own) const {
  for (const Attribute& attribute : raw ? raw->attributes : std::vector<Attribute>()) {
    // The reader has taken these away.
    if (attribute.name == "template" || attribute.name == "remove") {
      own.attributes.push_back(attribute);
    }
  }
  const std::string id = wanted.value("id");
  if (base && !raw && !id.empty() && !(id == wanted.name && is_only(meaning))) {
    own.set("id", id, {});
  }
  for (const Attribute& attribute : wanted.attributes) {
    const Attribute* const inherited = base ? base->find(attribute.name) : nullptr;
    if (!own.find(attribute.name) &&
        (!inherited || inherited->value != attribute.value || (raw && raw->find(attribute.name)))) {
      own.attributes.push_back(attribute);
    }
  }
  for (const Attribute& inherited : base ? base->attributes : std::vector<Attribute>()) {
    if (wanted.find(inherited.name)) continue;
    const auto field = meaning.field(inherited.name);
    if (!field || !field->default_value) {
      throw world::WorldError(
          {{edit_, 0,
            "<" + wanted.name + "> has its '" + inherited.name +
                "' from the robot's template, and a file cannot restore its default; give it a "
                "value instead"}});
    }
    const std::string value = world::format_value(*field->default_value);
    own.set(inherited.name, value, {edit_, 0});
    wanted.set(inherited.name, value, {edit_, 0});
  }
}

void OwnText::override_children(Element& wanted, const Element* before, const Element* raw,
                                const Element& base, const Meaning& meaning, Element& own) const {
  const bool replaces = replaces_declared(wanted, base, meaning);
  std::vector<std::pair<double, Element>> placed;
  std::optional<double> last;  // the place of the last one that is not in the template
  const auto first_own = [&] {
    for (const Element& child : wanted.children) {
      if (child_of(raw, child) && !overridden(base, child, meaning)) {
        return place_of(raw, child) - 0.5;
      }
    }
    return std::numeric_limits<double>::infinity();
  };
  for (Element& child : wanted.children) {
    const Meaning below = meaning.child(child, host_);
    const Element* const there = child_of(raw, child);
    const Element* const inherited =
        below.is_declared() ? nullptr : overridden(base, child, meaning);
    const bool is_inherited =
        below.is_declared() ? !replaces : inherited && alike(child, *inherited);
    if (!there && is_inherited) continue;
    double place = place_of(raw, child);
    if (!inherited) {
      if (!there) place = last ? *last : first_own();
      last = place;
    }
    placed.emplace_back(place, of(child, child_of(before, child), there, inherited, below));
  }
  for (const Element& inherited : base.children) {
    if (!meaning.spec() || !meaning.spec()->group || has_one(meaning) ||
        std::any_of(wanted.children.begin(), wanted.children.end(), [&](const Element& child) {
          return child.value("id") == inherited.value("id");
        })) {
      continue;
    }
    Element removal = removal_of(inherited);
    for (const Element& child : raw ? raw->children : std::vector<Element>()) {
      const bool is_free = std::none_of(placed.begin(), placed.end(), [&](const auto& other) {
        return other.second.object == child.object;  // it has another id now
      });
      if (is_free && child.value("id") == inherited.value("id")) removal.object = child.object;
    }
    placed.emplace_back(place_of(raw, removal), std::move(removal));
  }
  own.children = in_order(std::move(placed));
}

bool OwnText::replaces_declared(const Element& wanted, const Element& base,
                                const Meaning& meaning) const {
  if (!meaning.is_use()) return false;
  const auto declared = [&](const Element& element) {
    std::vector<Element> found;
    std::copy_if(element.children.begin(), element.children.end(), std::back_inserter(found),
                 [&](const Element& child) { return meaning.child(child, host_).is_declared(); });
    return found;
  };
  const auto now = declared(wanted), inherited = declared(base);
  return !std::equal(now.begin(), now.end(), inherited.begin(), inherited.end(), alike);
}

Element OwnText::template_of(const Element& robot) const {
  Element bare;
  bare.name = robot.name;
  bare.where = robot.where;
  bare.set("template", robot.value("template"), robot.find("template")->where);
  Element world, robots;
  world.name = "world";
  robots.name = "robots";
  robots.children.push_back(std::move(bare));
  world.children.push_back(std::move(robots));
  world::Problems problems;
  world::merge_templates(world, host_, files_, problems);
  problems.raise<world::WorldError>(robot.where.file);
  put_in_order(world);
  return std::move(world.children.front().children.front());
}

}  // namespace elsie::editing
