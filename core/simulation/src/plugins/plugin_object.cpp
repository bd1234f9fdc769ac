#include "plugins/plugin_object.h"

#include <stdexcept>
#include <utility>

#include "elsie/plugin/parameters.h"

namespace elsie::simulation {

Setup as_described(const world::PluginUse& use) {
  return {use.parameters, {use.elements.begin(), use.elements.end()}};
}

Memory memory_of(Component& object) {
  Memory memory;
  if (auto* const remembers = dynamic_cast<Remembers*>(&object)) {
    remembers->remember(memory);
  }
  memory.begin_recall();
  return memory;
}

void PluginObject::make(const plugin::Host& host, std::vector<base::Problem>& problems) {
  held = blaming(*use, problems, [&] {
    if (!declaration) {
      throw std::invalid_argument("no such plugin was found");
    }
    return made(host, as_described(*use));
  });
}

plugin::Object<Component> PluginObject::made(const plugin::Host& host, const Setup& setup) {
  plugin::Object<Component> object = create(host);
  if (declaration->hold) {
    declaration->hold(*object, *inside_of_it());
  }
  plugin::apply_parameters(*declaration, *object, setup.parameters, setup.elements);
  return object;
}

Setup PluginObject::completed(Setup setup, const Setup& now) const {
  for (const ParameterDeclaration& parameter : declaration->parameters) {
    if (now.parameters.contains(parameter.name)) {
      setup.parameters.try_emplace(parameter.name, parameter.default_value);
    }
  }
  return setup;
}

void PluginObject::set(Setup setup, const Perception& example) {
  // Noted first: what the plugin refuses may have been set in part.
  changed = completed(std::move(setup), this->setup());
  apply(*held, *changed, example);
  if (camera) {
    camera = camera_of(*held);
  }
}

std::optional<Camera> PluginObject::try_out(const Setup& setup, const Perception& example) const {
  const std::unique_ptr<Component> object = declaration->create();
  plugin::hold_nothing(*declaration, *object);
  apply(*object, setup, example);
  return camera_of(*object);
}

void PluginObject::apply(Component& object, const Setup& setup, const Perception& example) const {
  plugin::apply_parameters(*declaration, object, setup.parameters, setup.elements);
  equip(object, example);
}

void PluginObject::reset(std::uint64_t seed, const std::string& path) {
  random = Random(seed, path);
  forget();
  held->reset(random);
  is_new = false;
}

}  // namespace elsie::simulation
