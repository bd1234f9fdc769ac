#include "elsie/world/attributes.h"

#include <stdexcept>
#include <utility>

#include "elsie/base/near_name.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/world/values.h"

#include "path.h"
#include "refusals.h"

namespace elsie::world {

namespace {

// The parameters that the plugin declares for its element, or for a nested element, as fields.
std::vector<Field> declared_fields(const WorldTree::Meaning& meaning, const plugin::Host& host) {
  std::vector<Field> fields;
  const Declaration* plugin = meaning.use ? host.find(*meaning.kind, meaning.use->plugin) : nullptr;
  if (!plugin) return fields;
  std::optional<plugin::DeclaredElement> declared(*plugin);
  const std::vector<ElementUse>* uses = &meaning.use->elements;
  for (const std::size_t i : meaning.nested) {
    declared = declared->inside((*uses)[i].element);
    if (!declared) return fields;
    uses = &(*uses)[i].elements;
  }
  const ElementDeclaration* const element = declared->element();
  const bool is_fixed = (meaning.kind && plugin::is_of_world(*meaning.kind)) ||
                        (meaning.kind == PluginKind::drive && !(element && element->is_of_kind));
  for (const ParameterDeclaration& parameter : declared->parameters()) {
    fields.push_back(field_of(parameter));
    if (is_fixed) fields.back().cost = Cost::object;
  }
  return fields;
}

}  // namespace

std::vector<AttributeTarget> Attributes::find(std::string_view text) const {
  const Path path = parse_path(text);
  if (path.attribute.empty()) {
    throw std::invalid_argument(
        "the path leads to an element; expected an attribute at its end, as in "
        "robot[r1]/@max_speed");
  }
  if (path.attribute == "remove" || path.from_attribute) {
    throw std::invalid_argument(
        "an element can be removed before a run only: by --set, or by <set> in an experiment");
  }
  std::vector<AttributeTarget> targets;
  for (const Node& found : find_nodes(tree().begun(), path)) {
    if (!found.element->object) {  // find_nodes() made it
      tree_.reset();
      throw std::invalid_argument("there is no such element in this world");
    }
    targets.push_back(target(*found.element, path.attribute));
  }
  return targets;
}

AttributeTarget Attributes::target(const Element& element, const std::string& name) const {
  const WorldTree::Meaning& meaning = tree_->meaning(element);
  std::vector<Field> fields = declared_fields(meaning, host_);
  if (meaning.spec) {
    fields.insert(fields.end(), meaning.spec->attributes.begin(), meaning.spec->attributes.end());
  }
  const std::string path = tree_->path(element);
  AttributeTarget target{meaning,
                         (path.empty() ? "@" : path + "/@") + name,
                         element.name,
                         {},
                         meaning.spec ? meaning.spec->attribute(name) : nullptr,
                         {}};
  for (const Field& field : fields) {
    if (field.is_live()) {
      target.live.push_back(field.name);
    }
    if (field.name == name && target.field.name.empty()) {
      target.field = field;
    }
  }
  if (target.field.name.empty()) {
    throw std::invalid_argument("<" + element.name + "> has no attribute '" + name + "'" +
                                base::near_or_all(name, names_of(fields), "it may have"));
  }
  return target;
}

ParameterValue Attributes::read(const AttributeTarget& target, std::string_view text) const {
  Parsed parsed = parse_value(target.field, text);
  if (!parsed.value) {
    throw std::invalid_argument("expected " + parsed.expected);
  }
  if (target.field.type != ParameterType::file || (text.empty() && target.field.may_be_no_file())) {
    return std::move(*parsed.value);
  }
  const Location where{"--set " + target.path + "=" + std::string(text), 0};
  const auto file = files_.find(std::string(text), where);
  if (!file) {
    throw std::invalid_argument(files_.why_not(where, target.field.name, std::string(text)));
  }
  return Files::absolute(*file);
}

void Attributes::set(const AttributeTarget& target, std::string_view text) const {
  const ParameterValue value = read(target, text);
  if (target.attribute) {
    target.attribute->set(const_cast<void*>(target.described.object), value);
    return;
  }
  const auto put = [&](auto& use) {
    use.parameters[target.field.name] = value;
    use.file_names.erase(target.field.name);
    if (target.field.type == ParameterType::file && !text.empty()) {
      const std::string& path = std::get<std::string>(value);
      use.file_names[target.field.name] = {path, files_.name_for_world(path, std::string(text))};
    }
  };
  auto& use = const_cast<PluginUse&>(*target.use);
  target.nested.empty() ? put(use) : put(plugin::element_at(use.elements, target.nested));
}

std::vector<std::string> Attributes::robots_at(std::string_view text) const {
  std::vector<std::string> ids;
  try {
    Path path = parse_path(text);
    if (path.adds()) {
      path.steps.pop_back();
    }
    for (const Node& target : find_nodes(tree().begun(), path)) {
      const Robot* robot = target.element->object ? tree().meaning(*target.element).robot : nullptr;
      if (robot && (ids.empty() || ids.back() != robot->id)) {
        ids.push_back(robot->id);
      }
    }
  } catch (const std::invalid_argument&) {
    // The path leads to nothing.
  }
  return ids;
}

}  // namespace elsie::world
