#include "elsie/world/world_tree.h"

#include <map>
#include <utility>

#include "elsie/world/escaped.h"
#include "elsie/world/values.h"
#include "elsie/world/writer.h"

namespace elsie::world {
namespace {
// Joins steps of a path, "robot[r1]/sensor[2]", with brackets where they are needed.
std::string joined(const std::string& path, const std::string& step, const std::string& key) {
  return (path.empty() ? "" : path + "/") + step + (key.empty() ? "" : "[" + key + "]");
}

// The parameters that are set for a plugin, or for an element nested in its element.
template <class Use>
void add_parameters(Element& element, const Use& use) {
  for (const auto& [name, value] : use.parameters) {
    const auto file = use.file_names.find(name);
    if (file == use.file_names.end() || value != ParameterValue(file->second.path)) {
      element.attributes.push_back({name, format_value(value), {}});
    } else if (!file->second.name.empty()) {
      element.attributes.push_back({name, file->second.name, {}});
    }
  }
}

// The text of an element; "" if the element can be left out without a change of meaning.
std::string text_of(const Element& element, const WorldTree& tree, std::size_t depth) {
  const std::string indent(2 * depth, ' ');
  std::string content = element.text;
  for (const Element& child : element.children) {
    content += text_of(child, tree, depth + 1);
  }
  const bool is_needed = depth == 0 || tree.meaning(element).is_listed;
  if (content.empty() && element.attributes.empty() && !is_needed) return "";
  return indent + start_tag(element) +
         (content.empty() ? "/>\n" : ">\n" + content + indent + "</" + element.name + ">\n");
}
}  // namespace

Element WorldTree::make(const ElementSpec& spec, const void* object, Meaning meaning) {
  meaning.spec = &spec;
  if (spec.plugins) {
    meaning.use = spec.use(object);
    meaning.kind = spec.plugins;
  } else if (spec.name == "robot") {
    meaning.robot = static_cast<const Robot*>(object);
  }
  Element element;
  element.name = meaning.use ? meaning.use->plugin : spec.name;
  element.object = meanings_.size();
  meanings_.push_back(meaning);
  for (const AttributeSpec& attribute : spec.attributes) {
    const auto value = attribute.get ? attribute.get(object) : std::nullopt;
    if (value && value != attribute.default_value) {
      element.attributes.push_back({attribute.name, format_value(*value), {}});
    }
  }
  if (meaning.use) {
    add_parameters(element, *meaning.use);
    add_declared(element, meaning);
  }
  if (!spec.plugins) {
    add_children(element, spec, object, meaning);
  } else if (const Coordination* held = spec.inside ? spec.inside(object) : nullptr) {
    add_children(element, coordination_vocabulary(), held, meaning);
  }
  return element;
}

void WorldTree::add_children(Element& element, const ElementSpec& spec, const void* object,
                             const Meaning& meaning) {
  std::size_t number = 0;
  for (const auto& [part, child] : spec.parts_of(object)) {
    Meaning of_child = meaning;
    of_child.use = nullptr;
    of_child.kind.reset();
    of_child.is_listed = spec.group || child->at_most > 1;
    if (!child->group) {
      const AttributeSpec* id = child->attribute("id");
      const auto name = id && id->get ? id->get(part.object) : std::nullopt;
      const std::string key = name ? std::get<std::string>(*name) : "";
      of_child.path = joined(meaning.path, spec.group ? spec.members : child->name,
                             child->at_most <= 1 ? ""
                             : key.empty()       ? std::to_string(++number)
                                                 : key);
    }
    const std::size_t before = meanings_.size();
    Element made = make(*child, part.object, std::move(of_child));
    if (as_text_ && spec.group && meaning.path.empty()) {  // of the world: robots, obstacles...
      element.text += text_of(made, *this, 2);
      meanings_.resize(before);
    } else {
      element.children.push_back(std::move(made));
    }
  }
}

void WorldTree::add_declared(Element& element, const Meaning& meaning) {
  std::map<std::string, std::size_t> count;
  for (std::size_t i = 0; i < meaning.use->elements.size(); ++i) {
    const ElementUse& use = meaning.use->elements[i];
    Meaning of_child = meaning;
    of_child.spec = nullptr;
    of_child.nested = i;
    of_child.is_listed = true;
    of_child.path = joined(meaning.path, use.element, std::to_string(++count[use.element]));
    Element child;
    child.name = use.element;
    child.object = meanings_.size();
    add_parameters(child, use);
    meanings_.push_back(std::move(of_child));
    element.children.push_back(std::move(child));
  }
}

std::string write_world(const World& world) {
  WorldTree tree(world, true);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + text_of(tree.root(), tree, 0);
}

}  // namespace elsie::world
