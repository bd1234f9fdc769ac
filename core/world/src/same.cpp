#include "elsie/world/same.h"

#include <algorithm>
#include <string>

namespace elsie::world {

namespace {

const ElementSpec& member_of(const ElementSpec& group) { return group.children.front(); }

bool same_attributes(const ElementSpec& spec, const void* a, const void* b, Compared what) {
  return std::all_of(
      spec.attributes.begin(), spec.attributes.end(), [&](const AttributeSpec& attribute) {
        return !attribute.get || (what == Compared::settled && attribute.is_live()) ||
               attribute.get(a) == attribute.get(b);
      });
}

bool same_parts(const ElementSpec& spec, const void* a, const void* b, Compared what) {
  const auto parts = spec.parts_of(a), others = spec.parts_of(b);
  return std::equal(parts.begin(), parts.end(), others.begin(), others.end(),
                    [&](const auto& part, const auto& other) {
                      return part.second == other.second &&
                             same(*part.second, part.first.object, other.first.object, what);
                    });
}

}  // namespace

bool same(const PluginUse& a, const PluginUse& b) {
  return a.plugin == b.plugin && a.id == b.id && a.parameters == b.parameters &&
         std::equal(
             a.elements.begin(), a.elements.end(), b.elements.begin(), b.elements.end(),
             [](const ElementValue& one, const ElementValue& other) { return one == other; });
}

bool same(const ElementSpec& spec, const void* a, const void* b, Compared what) {
  if (!same_attributes(spec, a, b, what)) return false;
  if (!spec.plugins) return same_parts(spec, a, b, what);
  if (!same(*spec.use(a), *spec.use(b))) return false;
  const Coordination* const held = spec.inside ? spec.inside(a) : nullptr;
  const Coordination* const other = spec.inside ? spec.inside(b) : nullptr;
  return (held != nullptr) == (other != nullptr) &&
         (!held || same_parts(coordination_vocabulary(), held, other, what));
}

bool same_part(const ElementSpec& spec, const char* part, const void* a, const void* b) {
  const ElementSpec& child = *spec.child(part);
  const auto parts = child.parts(a), others = child.parts(b);
  return std::equal(parts.begin(), parts.end(), others.begin(), others.end(),
                    [&](const DescribedObject& one, const DescribedObject& other) {
                      return same(child, one.object, other.object);
                    });
}

const ElementSpec& robot_spec() {
  static const ElementSpec& spec = member_of(*vocabulary().child("robots"));
  return spec;
}

bool same(const SensorUse& a, const SensorUse& b, Compared what) {
  static const ElementSpec& spec = member_of(*robot_spec().child("sensors"));
  return same_attributes(spec, &a, &b, what);
}

bool same(const BehaviorUse& a, const BehaviorUse& b, Compared what) {
  static const ElementSpec& spec = member_of(*robot_spec().child("behaviors"));
  return same_attributes(spec, &a, &b, what);
}

}  // namespace elsie::world
