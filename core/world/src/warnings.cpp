#include "elsie/world/warnings.h"

#include <filesystem>

#include "elsie/base/words.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/engine_facts.h"
#include "elsie/world/values.h"

namespace elsie::world {
namespace {

// Warns of parameters that only other engines have.
void add_parameters_of_others(const Physics& physics, std::vector<Warning>& found) {
  const std::vector<AttributeSpec> own = engine_parameters(physics.engine);
  for (const AttributeSpec& parameter : engine_parameters()) {
    if (plugin::find_declared(own, parameter.name)) continue;
    const auto value = parameter.get(&physics);
    if (value == parameter.default_value) continue;
    found.push_back({Warning::About::no_effect, 0, physics.location,
                     parameter.name + "=\"" + format_value(*value) +
                         "\" has no effect, because the engine '" + physics.engine +
                         "' has no such parameter; expected an engine that has it: " +
                         base::enumerated(engines_with(parameter.name), "or")});
  }
}

}  // namespace

std::string Warning::text() const {
  const std::string sentence = "warning: " + message;
  return location.file.empty() ? sentence
                               : base::Problem{location.file, location.line, sentence}.text();
}

std::vector<Warning> warnings(const World& world) {
  std::vector<Warning> found;
  const std::string& engine = world.physics.engine;
  if (!std::filesystem::exists(plugin::engine_file(engine))) return found;
  add_parameters_of_others(world.physics, found);
  reinterpret_cast<EngineWarnings>(plugin::engine_symbol(engine, "elsie_warn"))(world, found);
  for (Warning& warning : found) {
    if (warning.location.file.empty()) warning.location.file = world.file;
  }
  return found;
}

}  // namespace elsie::world
