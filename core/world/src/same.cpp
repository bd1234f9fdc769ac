#include "elsie/world/same.h"

#include <algorithm>
#include <string>

namespace elsie::world {

namespace {

bool same_elements(const std::vector<ElementUse>& a, const std::vector<ElementUse>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.element == other.element && one.parameters == other.parameters &&
           same_elements(one.elements, other.elements);
  });
}

const ElementSpec& member_of(const ElementSpec& group) { return group.children.front(); }

bool same_attributes(const ElementSpec& spec, const void* a, const void* b, Cost least) {
  return std::all_of(
      spec.attributes.begin(), spec.attributes.end(), [&](const AttributeSpec& attribute) {
        return !attribute.get || attribute.cost < least || attribute.get(a) == attribute.get(b);
      });
}

/// The highest cost of any change in such an element.
Cost most(const ElementSpec& spec) {
  Cost cost = spec.cost;
  for (const AttributeSpec& attribute : spec.attributes) cost = std::max(cost, attribute.cost);
  for (const ElementSpec& child : spec.children) cost = std::max(cost, most(child));
  return cost;
}

auto dear_parts(const ElementSpec& spec, const void* object, Cost least) {
  auto parts = spec.parts_of(object);
  const ElementSpec* last = nullptr;
  bool is_cheap = false;  // of the last one: most parts of a list are of one kind
  std::erase_if(parts, [&](const auto& part) {
    if (part.second != last) is_cheap = most(*(last = part.second)) < least;
    return is_cheap;
  });
  return parts;
}

bool same_parts(const ElementSpec& spec, const void* a, const void* b, Cost least) {
  const auto parts = dear_parts(spec, a, least), others = dear_parts(spec, b, least);
  return std::equal(parts.begin(), parts.end(), others.begin(), others.end(),
                    [&](const auto& part, const auto& other) {
                      return part.second == other.second &&
                             same(*part.second, part.first.object, other.first.object, least);
                    });
}

}  // namespace

std::vector<ElementValue> values_of(const std::vector<ElementUse>& elements) {
  std::vector<ElementValue> values;
  for (const ElementUse& use : elements) {
    values.push_back({use.element, use.parameters, values_of(use.elements)});
  }
  return values;
}

bool same(const PluginUse& a, const PluginUse& b) {
  return a.plugin == b.plugin && a.id == b.id && a.parameters == b.parameters &&
         same_elements(a.elements, b.elements);
}

bool same(const ElementSpec& spec, const void* a, const void* b, Cost least) {
  if (a == b) return true;  // as what copies of a world share
  if (!same_attributes(spec, a, b, least)) return false;
  if (!spec.plugins) return same_parts(spec, a, b, least);
  if (spec.cost >= least && !same(*spec.use(a), *spec.use(b))) return false;
  const Coordination* const held = spec.inside ? spec.inside(a) : nullptr;
  const Coordination* const other = spec.inside ? spec.inside(b) : nullptr;
  return (held != nullptr) == (other != nullptr) &&
         (!held || same_parts(coordination_vocabulary(), held, other, least));
}

bool same_part(const ElementSpec& spec, const char* part, const void* a, const void* b) {
  const ElementSpec& child = *spec.child(part);
  const auto parts = child.parts(a), others = child.parts(b);
  return std::equal(parts.begin(), parts.end(), others.begin(), others.end(),
                    [&](const DescribedObject& one, const DescribedObject& other) {
                      return same(child, one.object, other.object);
                    });
}

bool same(const Obstacle& a, const Obstacle& b, Cost least) {
  const char* const list = a.kind == ObstacleKind::resource ? "resources" : "obstacles";
  return a.element() == b.element() &&
         same(*vocabulary().child(list)->child(a.element()), &a, &b, least);
}

bool same(const MountedUse& a, const MountedUse& b, Cost least) {
  return same_attributes(member_of(*robot_spec().child("sensors")), &a, &b, least);
}

bool same(const BehaviorUse& a, const BehaviorUse& b, Cost least) {
  return same_attributes(member_of(*robot_spec().child("behaviors")), &a, &b, least);
}

}  // namespace elsie::world
