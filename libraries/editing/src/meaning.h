// The meanings of elements: combines the core's vocabulary with the declarations of plugins.
#pragma once

#include <optional>
#include <string>

#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/host.h"
#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::editing {

using world::Attribute;
using world::AttributeSpec;
using world::Element;
using world::ElementSpec;
using world::Field;

class Meaning {
 public:
  static Meaning of_world() { return Meaning(&world::vocabulary()); }

  /// The meaning of an element without a parent, as in a <change>; empty if its name is unknown.
  static Meaning of_name(const std::string& name, const plugin::Host& host,
                         const ElementSpec& among = world::vocabulary()) {
    for (const ElementSpec& each : among.children) {
      const Declaration* plugin = each.plugins ? host.find(*each.plugins, name) : nullptr;
      if (plugin || (!each.plugins && !each.group && each.name == name)) {
        return {&each, plugin};
      }
      if (Meaning inside = of_name(name, host, each); inside.spec_) {
        return inside;
      }
    }
    return {};
  }

  /// The meaning of an element inside this one; empty if it is unknown.
  Meaning child(const Element& child, const plugin::Host& host) const {
    if (declared_) {
      const ElementSpec* const held =
          plugin_ && plugin_->hold ? world::coordination_vocabulary().child(child.name) : nullptr;
      return held ? Meaning(held) : Meaning(declared_->inside(child.name));
    }
    if (!spec_ || spec_->plugins) return {};
    if (!spec_->children.empty() && spec_->children.front().plugins) {
      const ElementSpec& use = spec_->children.front();
      return {&use, host.find(*use.plugins, child.name)};
    }
    return Meaning(spec_->child(child.name));
  }

  std::optional<Field> field(const std::string& attribute) const {
    if (const AttributeSpec* known = spec_ ? spec_->attribute(attribute) : nullptr) {
      return *known;
    }
    const ParameterDeclaration* parameter =
        declared_ ? plugin::find_declared(declared_->parameters(), attribute) : nullptr;
    return parameter ? std::optional(world::field_of(*parameter)) : std::nullopt;
  }

  /// Null for an element that a plugin declares.
  const ElementSpec* spec() const { return spec_; }
  bool is_use() const { return spec_ && spec_->plugins; }
  /// Whether a plugin declares the element.
  bool is_declared() const { return declared_ && declared_->element(); }

  Meaning() = default;

 private:
  explicit Meaning(const ElementSpec* spec) : spec_(spec) {}
  Meaning(const ElementSpec* spec, const Declaration* plugin) : spec_(spec), plugin_(plugin) {
    if (plugin) declared_.emplace(*plugin);
  }
  explicit Meaning(const std::optional<plugin::DeclaredElement>& declared) : declared_(declared) {}

  const ElementSpec* spec_ = nullptr;
  const Declaration* plugin_ = nullptr;                // whose own element it is
  std::optional<plugin::DeclaredElement> declared_{};  // a plugin's own element, or one inside it
};

}  // namespace elsie::editing
