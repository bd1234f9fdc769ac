#include "elsie/world/attributes.h"

#include <stdexcept>
#include <utility>

#include "elsie/base/near_name.h"
#include "elsie/plugin/host.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/markup.h"
#include "elsie/world/values.h"
#include "elsie/world/world_tree.h"

#include "path.h"

namespace elsie::world {

class Attributes::Impl {
 public:
  Impl(const World& world, const plugin::Host& host, std::vector<std::string> data_directories,
       std::map<std::string, std::string> files)
      : world_(world),
        host_(host),
        files_(world.file, std::move(data_directories), "", std::move(files)) {}

  std::vector<AttributePlace> find(std::string_view text) {
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
    if (!tree_) {
      tree_.emplace(world_);
    }
    std::vector<AttributePlace> places;
    for (const Place& found : find_places(tree_->root(), path)) {
      if (!found.element->object) {  // find_places() made it
        tree_.reset();
        throw std::invalid_argument("there is no such element in this world");
      }
      places.push_back(place(*found.element, tree_->meaning(*found.element), path.attribute));
    }
    return places;
  }

  ParameterValue read(const AttributePlace& place, std::string_view text) const {
    Parsed parsed = parse_value(place.field, text);
    if (!parsed.value) {
      throw std::invalid_argument(parsed.problem);
    }
    if (place.field.type != ParameterType::file || (text.empty() && !place.field.required)) {
      return std::move(*parsed.value);
    }
    const Location where{world_.file, 0};
    const auto file = files_.find(std::string(text), where);
    if (!file) {
      throw std::invalid_argument(files_.why_not(where, place.field.name, std::string(text)));
    }
    return Files::absolute(*file);
  }

 private:
  AttributePlace place(const Element& element, const WorldTree::Meaning& meaning,
                       const std::string& name) const {
    AttributePlace place;
    place.path = meaning.path + (meaning.path.empty() ? "@" : "/@") + name;
    place.element = element.name;
    place.robot = meaning.robot;
    place.use = meaning.use;
    place.nested = meaning.nested;
    bool found = false;
    std::vector<std::string> names;
    const auto add = [&](const Field& field) {
      names.push_back(field.name);
      if (field.is_live()) {
        place.live.push_back(field.name);
      }
      if (!found && field.name == name) {
        found = true;
        place.field = field;
      }
    };
    for (const ParameterDeclaration& parameter : parameters(meaning)) {
      Field field = field_of(parameter);
      if (meaning.kind == PluginKind::measure || meaning.kind == PluginKind::drive) {
        field.change = nullptr;
      }
      add(field);
    }
    if (meaning.spec) {
      for (const AttributeSpec& attribute : meaning.spec->attributes) {
        add(attribute);
      }
    }
    if (!found) {
      throw std::invalid_argument("<" + element.name + "> has no attribute '" + name + "'" +
                                  base::near_or_all(name, names, "it may have"));
    }
    return place;
  }

  // Those that the plugin declares for its element, or for one in it.
  std::vector<ParameterDeclaration> parameters(const WorldTree::Meaning& meaning) const {
    const Declaration* plugin =
        meaning.use ? host_.find(*meaning.kind, meaning.use->plugin) : nullptr;
    if (!plugin) {
      return {};
    }
    if (!meaning.nested) {
      return plugin->parameters;
    }
    const auto* element =
        plugin::find_declared(plugin->elements, meaning.use->elements[*meaning.nested].element);
    return element ? element->parameters : std::vector<ParameterDeclaration>();
  }

  const World& world_;
  const plugin::Host& host_;
  Files files_;
  std::optional<WorldTree> tree_;  // once it was needed
};

Attributes::Attributes(const World& world, const plugin::Host& host,
                       std::vector<std::string> data_directories,
                       std::map<std::string, std::string> files)
    : impl_(std::make_unique<Impl>(world, host, std::move(data_directories), std::move(files))) {}
Attributes::Attributes(Attributes&&) noexcept = default;
Attributes& Attributes::operator=(Attributes&&) noexcept = default;
Attributes::~Attributes() = default;

std::vector<AttributePlace> Attributes::find(std::string_view path) const {
  return impl_->find(path);
}

ParameterValue Attributes::read(const AttributePlace& place, std::string_view text) const {
  return impl_->read(place, text);
}

std::vector<std::string> robots_at(const World& world, std::string_view text) {
  std::vector<std::string> ids;
  try {
    Path path = parse_path(text);
    if (path.adds()) {
      path.steps.pop_back();
    }
    WorldTree tree(world);
    for (const Place& place : find_places(tree.root(), path)) {
      const Robot* robot = place.element->object ? tree.meaning(*place.element).robot : nullptr;
      if (robot && (ids.empty() || ids.back() != robot->id)) {
        ids.push_back(robot->id);
      }
    }
  } catch (const std::invalid_argument&) {
    // It leads to nothing.
  }
  return ids;
}

}  // namespace elsie::world
