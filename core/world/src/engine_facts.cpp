#include "elsie/world/engine_facts.h"

#include "elsie/base/words.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/parameters.h"

namespace elsie::world {
namespace {

AttributeSpec attribute_of_physics(AttributeSpec parameter) {
  if (const auto engines = engines_with(parameter.name); engines != plugin::engine_names()) {
    parameter.facts.meaning += "; of the engine " + base::enumerated(engines);
  }
  parameter.set = [name = parameter.name](void* physics, const ParameterValue& value) {
    static_cast<Physics*>(physics)->parameters[name] = value;
  };
  parameter.get = [name = parameter.name, by_default = parameter.default_value](
                      const void* physics) -> std::optional<ParameterValue> {
    const auto& given = static_cast<const Physics*>(physics)->parameters;
    const auto found = given.find(name);
    return found == given.end() ? by_default : found->second;
  };
  return parameter;
}

}  // namespace

std::vector<AttributeSpec> engine_parameters(const std::string& engine) {
  std::vector<AttributeSpec> parameters;
  try {
    reinterpret_cast<EngineParameters>(plugin::engine_symbol(engine, "elsie_engine_parameters"))(
        parameters);
  } catch (const plugin::PluginError&) {
    return {};
  }
  return parameters;
}

std::vector<AttributeSpec> engine_parameters() {
  std::vector<AttributeSpec> all;
  for (const std::string& engine : plugin::engine_names()) {
    for (AttributeSpec& parameter : engine_parameters(engine)) {
      if (plugin::find_declared(all, parameter.name)) continue;
      all.push_back(attribute_of_physics(std::move(parameter)));
    }
  }
  return all;
}

std::vector<std::string> engines_with(const std::string& parameter) {
  std::vector<std::string> engines = plugin::engine_names();
  std::erase_if(engines, [&](const std::string& engine) {
    return !plugin::find_declared(engine_parameters(engine), parameter);
  });
  return engines;
}

}  // namespace elsie::world
