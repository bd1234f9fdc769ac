#include "random_edits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "elsie/plugin/parameters.h"
#include "elsie/world/escaped.h"
#include "elsie/world/values.h"
#include "elsie/world/vocabulary.h"

namespace elsie::test {

using world::ElementSpec;
using world::Field;

// Goes down from the world to a random element, and edits it.
class Walk {
 public:
  Walk(RandomEdits& random, const plugin::Host& host) : random_(random), host_(host) {}

  std::string edit(const ElementSpec& spec, const void* object, const std::string& path,
                   const ElementSpec* list) {
    const world::PluginUse* use = spec.plugins ? spec.use(object) : nullptr;
    const Declaration* declaration = use ? host_.find(*spec.plugins, use->plugin) : nullptr;
    const world::Coordination* inside = spec.inside ? spec.inside(object) : nullptr;
    const auto parts = inside         ? world::coordination_vocabulary().parts_of(inside)
                       : spec.plugins ? decltype(spec.parts_of(object))()
                                      : spec.parts_of(object);
    if (!parts.empty() && random_.happens(0.8)) {
      const std::size_t chosen = random_.below(parts.size());
      const auto& [part, child] = parts[chosen];
      const std::string start = path.empty() ? "" : path + "/";
      if (child->group) {
        return edit(*child, part.object, path, nullptr);
      }
      const std::string name = spec.group ? spec.members : child->name;
      const std::size_t before = spec.group ? chosen : part.order;
      return edit(
          *child, part.object,
          start + name + (child->at_most == 1 ? "" : "[" + std::to_string(before + 1) + "]"),
          spec.group ? &spec : nullptr);
    }
    if (spec.group) {
      return addition(spec, path, parts.size());
    }
    if (use && declaration && !declaration->elements.empty() && random_.happens(0.3)) {
      return nested(*use, *declaration, path);
    }
    if (random_.happens(0.15) && !spec.root) {
      return path + "/@remove=true";
    }
    if (random_.happens(0.1) && !spec.root) {
      return path + "=" +
             element(list ? list->children[random_.below(list->children.size())] : spec);
    }
    return attribute(fields(spec, declaration), path);
  }

 private:
  template <class Range>
  const auto& one_of(const Range& range) {
    return range[random_.below(range.size())];
  }

  static std::vector<Field> fields(const ElementSpec& spec, const Declaration* declaration) {
    std::vector<Field> found(spec.attributes.begin(), spec.attributes.end());
    if (declaration) {
      for (const ParameterDeclaration& parameter : declaration->parameters) {
        found.push_back(world::field_of(parameter));
      }
    }
    return found;
  }

  std::string attribute(const std::vector<Field>& fields, const std::string& path) {
    const std::string start = path.empty() ? "@" : path + "/@";
    if (fields.empty() || random_.happens(0.03)) {
      return start + "nonsense=1";
    }
    const Field& field = one_of(fields);
    return random_.happens(0.2) ? start + field.name + "/@remove=true"
                                : start + field.name + "=" + value(field);
  }

  std::string value(const Field& field) {
    if (random_.happens(0.05)) {
      return one_of(std::vector<std::string>{"", "nan", "a \"b\" & 'c' <d>", "-1e300", "yes",
                                             "\xC3\xA4\xC3\xB6", "line\nbreak"});
    }
    if (!field.facts.choices.empty()) {
      return one_of(field.facts.choices);
    }
    switch (field.type) {
      case ParameterType::boolean:
        return random_.happens(0.5) ? "true" : "false";
      case ParameterType::integer:
      case ParameterType::real: {
        const double low = std::max({field.facts.min, field.facts.above, field.lowest, -3.0});
        const double high = std::min({field.facts.max, field.highest, low + 4.0});
        double drawn = low + (high - low) * static_cast<double>(random_.below(1000)) / 999;
        if (random_.happens(0.05)) {
          drawn = high + 1e5;
        }
        return world::format_value(field.type == ParameterType::integer
                                       ? ParameterValue(static_cast<std::int64_t>(drawn))
                                       : ParameterValue(drawn));
      }
      case ParameterType::reals:
        return random_.happens(0.5) ? "0.5 1" : "1 2 3";
      case ParameterType::file:
        return one_of(std::vector<std::string>{"nowhere.xml", "../robots/scout.xml",
                                               "../robots/collector.xml",
                                               "../fuzzy_models/avoid_obstacle.fcl"});
      case ParameterType::text:
        break;
    }
    return field.form == world::TextForm::colour ? (random_.happens(0.5) ? "#12ab9f" : "#000000")
           : field.refers_to == world::Reference::team
               ? one_of(std::vector<std::string>{"red", "blue", "green"})
               : one_of(std::vector<std::string>{"r1", "r2", "thing", "avoid_obstacle", "wander",
                                                 "static_box_2"});
  }

  std::string element(const ElementSpec& spec) {
    const Declaration* declaration = nullptr;
    if (spec.plugins) {
      declaration = one_of(host_.all(*spec.plugins));
    }
    std::string text = "<" + (declaration ? declaration->name : spec.name);
    for (const Field& field : fields(spec, declaration)) {
      const bool is_place = field.name == "x" || field.name == "y";
      if (field.name != "remove" && field.name != "template" &&
          (field.required || random_.happens(is_place ? 0.8 : 0.08))) {
        text += " " + field.name + "=\"" + world::escaped_attribute(value(field)) + "\"";
      }
    }
    return text + "/>";
  }

  std::string addition(const ElementSpec& group, const std::string& path, std::size_t count) {
    const ElementSpec& child = one_of(group.children);
    const std::size_t number = 1 + random_.below(count + 2);
    return (path.empty() ? "" : path + "/") + group.members +
           (random_.happens(0.5) ? "[+]" : "[+" + std::to_string(number) + "]") + "=" +
           element(child);
  }

  // An element that a plugin declares.
  std::string nested(const world::PluginUse& use, const Declaration& declaration,
                     const std::string& path) {
    const ElementDeclaration& declared = one_of(declaration.elements);
    const auto count = static_cast<std::size_t>(
        std::count_if(use.elements.begin(), use.elements.end(),
                      [&](const auto& each) { return each.element == declared.name; }));
    std::vector<Field> fields;
    std::string text = "<" + declared.name;
    for (const ParameterDeclaration& parameter : declared.parameters) {
      fields.push_back(world::field_of(parameter));
      if (parameter.facts.required || random_.happens(0.5)) {
        text +=
            " " + parameter.name + "=\"" + world::escaped_attribute(value(fields.back())) + "\"";
      }
    }
    const std::string start = path + "/" + declared.name;
    if (count == 0 || random_.happens(0.3)) {
      return start + (random_.happens(0.5) ? "[+]" : "[+1]") + "=" + text + "/>";
    }
    const std::string one = start + "[" + std::to_string(1 + random_.below(count)) + "]";
    return random_.happens(0.3)   ? one + "/@remove=true"
           : random_.happens(0.2) ? one + "=" + text + "/>"
                                  : attribute(fields, one);
  }

  RandomEdits& random_;
  const plugin::Host& host_;
};

std::string RandomEdits::next(const world::World& world) {
  if (happens(0.01)) {
    return below(2) == 0 ? "robot[nobody]/@x=1" : "][";
  }
  return Walk(*this, host_).edit(world::vocabulary(), &world, "", nullptr);
}

}  // namespace elsie::test
