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
void add_parameters(Element& element, const Use& use, const Location& where) {
  for (const auto& [name, value] : use.parameters) {
    const auto file = use.file_names.find(name);
    if (file == use.file_names.end() || value != ParameterValue(file->second.path)) {
      element.attributes.push_back({name, format_value(value), where});
    } else if (!file->second.name.empty()) {
      element.attributes.push_back({name, file->second.name, where});
    }
  }
}
}  // namespace

WorldTree::WorldTree(const World& world) : world_(world), file_{world.file, 1} {
  Meaning whole;
  whole.described.object = &world;
  root_ = begin(vocabulary(), whole, "");
  complete(root_);
}

Element& WorldTree::root() {
  for_each_element(root_, completed);
  return root_;
}

Element& completed(Element& element) {
  if (element.unread) element.unread->complete(element);
  return element;
}

// An element with its id only.
Element WorldTree::begin(const ElementSpec& spec, Meaning meaning, const std::string& id) {
  const auto& [order, object] = meaning.described;
  meaning.spec = &spec;
  if (spec.plugins) {
    meaning.use = spec.use(object);
    meaning.kind = spec.plugins;
  } else if (spec.name == "robot") {
    meaning.robot = static_cast<const Robot*>(object);
    meaning.robot_index = order;
  }
  Element element;
  element.name = meaning.use ? meaning.use->plugin : spec.name;
  element.where = spec.location ? spec.location(object) : file_;
  if (!id.empty()) element.attributes.push_back({"id", id, file_});
  element.object = meanings_.size();
  element.unread = this;
  meanings_.push_back(std::move(meaning));
  return element;
}

void WorldTree::complete(Element& element) {
  element.unread = nullptr;
  element.attributes.clear();
  const Meaning meaning = meanings_[*element.object];
  const ElementSpec& spec = *meaning.spec;
  const void* const object = meaning.described.object;
  for (const AttributeSpec& attribute : spec.attributes) {
    const auto value = attribute.get ? attribute.get(object) : std::nullopt;
    if (value && value != attribute.default_value) {
      element.attributes.push_back({attribute.name, format_value(*value), file_});
    }
  }
  if (meaning.use) {
    add_parameters(element, *meaning.use, file_);
    add_declared(element, meaning);
  }
  if (!spec.plugins) {
    add_children(element, spec, object, meaning);
  } else if (const Coordination* held = spec.inside ? spec.inside(object) : nullptr) {
    add_children(element, coordination_vocabulary(), held, meaning);
  }
}

void WorldTree::add_children(Element& element, const ElementSpec& spec, const void* object,
                             const Meaning& meaning) {
  const bool is_of_world = meaning.path.empty();  // the world, or one of its lists
  std::size_t number = 0;
  const auto parts = spec.parts_of(object);
  element.children.reserve(parts.size());
  for (const auto& [part, child] : parts) {
    Meaning of_child = meaning;
    of_child.described = part;
    of_child.use = nullptr;
    of_child.kind.reset();
    of_child.is_listed = spec.group || child->at_most > 1;
    std::string key;
    if (!child->group) {
      const AttributeSpec* id = child->attribute("id");
      const auto name = id && id->get ? id->get(part.object) : std::nullopt;
      if (name) key = std::get<std::string>(*name);
      of_child.path = joined(meaning.path, spec.group ? spec.members : child->name,
                             child->at_most <= 1 ? ""
                             : key.empty()       ? std::to_string(++number)
                                                 : key);
    }
    Element& made = element.children.emplace_back(begin(*child, std::move(of_child), key));
    if (!is_of_world || !(spec.group || child->group)) complete(made);
  }
}

void WorldTree::add_declared(Element& element, const Meaning& meaning) {
  std::map<std::string, std::size_t> count;
  for (std::size_t i = 0; i < meaning.use->elements.size(); ++i) {
    const ElementUse& use = meaning.use->elements[i];
    Meaning of_child = meaning;
    of_child.spec = nullptr;
    of_child.described = {};
    of_child.nested = i;
    of_child.is_listed = true;
    of_child.path = joined(meaning.path, use.element, std::to_string(++count[use.element]));
    Element child;
    child.name = use.element;
    child.where = use.location;
    child.object = meanings_.size();
    add_parameters(child, use, file_);
    meanings_.push_back(std::move(of_child));
    element.children.push_back(std::move(child));
  }
}

void WorldTree::renew_robot(std::size_t index) {
  Element* const robots = root_.child("robots");
  if (!robots || robots->unread) return;
  Meaning meaning = meanings_[*robots->children[index].object];
  meaning.described.object = &world_.robots[index];
  const ElementSpec& spec = *meaning.spec;
  robots->children[index] = begin(spec, std::move(meaning), world_.robots[index].id);
}

// The text of an element; "" if the element can be left out without a change of meaning.
std::string WorldTree::text(Element& element, std::size_t depth) {
  const std::size_t before = meanings_.size();
  const bool is_needed = depth == 0 || meaning(element).is_listed;
  completed(element);
  const std::string indent(2 * depth, ' ');
  std::string content;
  for (Element& child : element.children) {
    content += text(child, depth + 1);
  }
  element.children = {};
  meanings_.resize(before);
  if (content.empty() && element.attributes.empty() && !is_needed) return "";
  return indent + start_tag(element) +
         (content.empty() ? "/>\n" : ">\n" + content + indent + "</" + element.name + ">\n");
}

std::string write_world(const World& world) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + WorldTree(world).text();
}

}  // namespace elsie::world
