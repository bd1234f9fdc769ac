// Plugin objects as a world describes them.
#pragma once

#include <stdexcept>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"

#include "plugins/guard.h"

namespace elsie::simulation {

/// Makes and configures one plugin object; none, and a problem added, when that fails. `inside`:
/// what it holds if it is a behaviour that holds others.
template <class Kind>
plugin::Object<Kind> make(const plugin::Host& host, PluginKind kind, const world::PluginUse& use,
                          std::vector<base::Problem>& problems, Coordination* inside = nullptr) {
  return blaming(use, problems, [&] {
    const Declaration* declaration = host.find(kind, use.plugin);
    if (!declaration) {
      throw std::invalid_argument("no such plugin was found");
    }
    auto object = host.create<Kind>(kind, use.plugin);
    if (declaration->hold) {
      declaration->hold(*object, *inside);
    }
    const std::vector<ElementValue> elements(use.elements.begin(), use.elements.end());
    plugin::apply_parameters(*declaration, *object, use.parameters, elements);
    return object;
  });
}

}  // namespace elsie::simulation
