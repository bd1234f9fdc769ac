#include "elsie/world/writer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "elsie/world/escaped.h"
#include "elsie/world/values.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

namespace {

void append_attribute(std::string& text, const std::string& name, const ParameterValue& value) {
  text += " " + name + "=\"" + escaped_attribute(format_value(value)) + "\"";
}

// The parameters that are given to a plugin, or to an element in its own.
template <class Use>
void append_parameters(std::string& text, const Use& use) {
  for (const auto& [name, value] : use.parameters) {
    const auto file = use.file_names.find(name);
    if (file == use.file_names.end() || value != ParameterValue(file->second.path)) {
      append_attribute(text, name, value);
    } else if (!file->second.name.empty()) {
      append_attribute(text, name, file->second.name);
    }
  }
}

std::string element(const ElementSpec& spec, const void* object, bool needed, std::size_t depth);

std::string children(const ElementSpec& spec, const void* object, std::size_t depth) {
  std::string text;
  for (const auto& [part, child] : spec.parts_of(object)) {
    const bool is_listed = spec.group || child->at_most > 1;
    text += element(*child, part.object, is_listed, depth);
  }
  return text;
}

// What stands in a plugin's element.
std::string inside(const ElementSpec& spec, const PluginUse& use, const void* object,
                   std::size_t depth) {
  std::string text;
  for (const ElementUse& nested : use.elements) {
    text += std::string(2 * depth, ' ') + "<" + nested.element;
    append_parameters(text, nested);
    text += "/>\n";
  }
  const Coordination* held = spec.inside ? spec.inside(object) : nullptr;
  return held ? text + children(coordination_vocabulary(), held, depth) : text;
}

// "" when it is not needed and has nothing to say: everything is as it would be without it.
std::string element(const ElementSpec& spec, const void* object, bool needed, std::size_t depth) {
  const std::string indent(2 * depth, ' ');
  const PluginUse* use = spec.plugins ? spec.use(object) : nullptr;
  const std::string& name = use ? use->plugin : spec.name;
  std::string attributes;
  if (!spec.group) {
    for (const AttributeSpec& attribute : spec.attributes) {
      const auto value = attribute.get ? attribute.get(object) : std::nullopt;
      if (value && value != attribute.default_value) {
        append_attribute(attributes, attribute.name, *value);
      }
    }
  }
  if (use) {
    append_parameters(attributes, *use);
  }
  const std::string content =
      use ? inside(spec, *use, object, depth + 1) : children(spec, object, depth + 1);
  if (!needed && attributes.empty() && content.empty()) {
    return "";
  }
  return indent + "<" + name + attributes +
         (content.empty() ? "/>\n" : ">\n" + content + indent + "</" + name + ">\n");
}

}  // namespace

std::string write_world(const World& world) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + element(vocabulary(), &world, true, 0);
}

}  // namespace elsie::world
