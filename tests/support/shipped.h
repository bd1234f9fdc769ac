// The plugins that Elsie ships, from the build tree.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"

#include "places.h"

namespace elsie::test {

/// The folder of the shipped plugins.
inline std::vector<plugin::SearchDirectory> shipped_directory() {
  return {{plugin_directory(), "the build tree"}};
}

/// The host with all shipped plugins.
const plugin::Host& shipped();

/// Parameters as in a world file: fuzzy models and other files are found in the source tree.
using Parameters = std::map<std::string, ParameterValue>;

/// Makes a configured object of a shipped plugin.
template <class Kind>
plugin::Object<Kind> make(PluginKind kind, const std::string& name, Parameters parameters = {},
                          const std::vector<ElementValue>& elements = {}) {
  const Declaration* declaration = shipped().find(kind, name);
  if (!declaration) {
    throw std::runtime_error("no shipped plugin '" + name + "'");
  }
  for (const ParameterDeclaration& parameter : declaration->parameters) {
    if (parameter.type == ParameterType::file && !parameters.contains(parameter.name)) {
      parameters[parameter.name] = source_path(std::get<std::string>(parameter.default_value));
    }
  }
  auto object = shipped().create<Kind>(kind, name);
  plugin::apply_parameters(*declaration, *object, parameters, elements);
  return object;
}

}  // namespace elsie::test
