// A plugin's object, made and configured.
#pragma once

#include <string>

#include "elsie/plugin/parameters.h"
#include "elsie/testing/plugins.h"

namespace elsie::testing {

/// `prepare` is called before configured().
template <class Kind, class Prepare>
plugin::Object<Kind> make(const Plugins& plugins, const Declaration& declaration,
                          const Settings& settings, const Elements& elements, Prepare prepare) {
  auto object = plugins.host().create<Kind>(declaration.kind, declaration.name);
  prepare(*object);
  plugin::apply_parameters(declaration, *object, plugins.completed(declaration, settings),
                           plugins.completed(declaration, elements));
  return object;
}

}  // namespace elsie::testing
