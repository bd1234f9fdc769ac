#include "elsie/world/world_tree.h"

#include <map>
#include <utility>

#include "elsie/plugin/declared_element.h"
#include "elsie/world/escaped.h"
#include "elsie/world/values.h"
#include "elsie/world/writer.h"

namespace elsie::world {
namespace {
// The id of an object; "" if it has none.
std::string id_of(const ElementSpec& spec, const void* object) {
  const AttributeSpec* id = spec.attribute("id");
  const auto held = id && id->get ? id->get(object) : std::nullopt;
  return held ? std::get<std::string>(*held) : "";
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

WorldTree::WorldTree(const World& world) : world_(world), file_{world.file, 0} {
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
  meanings_.push_back(meaning);
  return element;
}

std::string WorldTree::path(std::size_t meaning) const {
  const Meaning& own = meanings_[meaning];
  if (meaning == 0) return "";
  const std::string outer = path(own.holder);
  const ElementSpec* const around = meanings_[own.holder].spec;  // null: of a plugin
  if (own.spec && own.spec->group) return outer;
  const std::string& step = !own.spec ? plugin::element_at(own.use->elements, own.nested).element
                            : around->group ? around->members
                                            : own.spec->name;
  const bool is_only = own.spec && own.spec->at_most <= 1;
  const std::string key = is_only           ? ""
                          : own.number == 0 ? id_of(*own.spec, own.described.object)
                                            : std::to_string(own.number);
  return (outer.empty() ? "" : outer + "/") + step + (key.empty() ? "" : "[" + key + "]");
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
    add_declared(element, meaning, meaning.use->elements);
  }
  if (!spec.plugins) {
    add_children(element, spec, object, meaning);
  } else if (const Coordination* held = spec.inside ? spec.inside(object) : nullptr) {
    add_children(element, coordination_vocabulary(), held, meaning);
  }
}

void WorldTree::add_children(Element& element, const ElementSpec& spec, const void* object,
                             const Meaning& meaning) {
  const bool is_of_world = object == &world_;         // the world, or one of its lists
  std::map<const ElementSpec*, std::size_t> numbers;  // of a list's members: all count as one kind
  const auto parts = spec.parts_of(object);
  element.children.reserve(parts.size());
  for (const auto& [part, child] : parts) {
    const std::string id = child->group ? "" : id_of(*child, part.object);
    Meaning of_child;
    of_child.described = part;
    of_child.holder = *element.object;
    of_child.number = id.empty() && child->at_most > 1 ? ++numbers[spec.group ? &spec : child] : 0;
    of_child.robot = meaning.robot;
    of_child.robot_index = meaning.robot_index;
    of_child.is_listed = spec.group || child->at_most > 1;
    Element& made = element.children.emplace_back(begin(*child, of_child, id));
    if (!is_of_world || !(spec.group || child->group)) complete(made);
  }
}

void WorldTree::add_declared(Element& element, const Meaning& meaning,
                             const std::vector<ElementUse>& uses) {
  std::map<std::string, std::size_t> count;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const ElementUse& use = uses[i];
    Meaning of_child = meaning;
    of_child.spec = nullptr;
    of_child.described = {};
    of_child.nested.push_back(i);
    of_child.is_listed = true;
    of_child.holder = *element.object;
    of_child.number = ++count[use.element];
    Element child;
    child.name = use.element;
    child.where = use.location;
    child.object = meanings_.size();
    add_parameters(child, use, file_);
    meanings_.push_back(of_child);
    add_declared(child, of_child, use.elements);
    element.children.push_back(std::move(child));
  }
}

void WorldTree::renew_robot(std::size_t index) {
  Element* const robots = root_.child("robots");
  if (!robots || robots->unread) return;
  Meaning meaning = meanings_[*robots->children[index].object];
  meaning.described.object = &world_.robots[index];
  const ElementSpec& spec = *meaning.spec;
  robots->children[index] = begin(spec, meaning, world_.robots[index].id);
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
