// Makes and configures a plugin's object.
#pragma once

#include <stdexcept>
#include <string>

#include "elsie/api/remember.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/parameters.h"
#include "elsie/testing/plugins.h"

namespace elsie::testing {

/// `prepare` is called before configured().
template <class Kind, class Prepare>
plugin::Object<Kind> make(const Plugins& plugins, const Declaration& declaration,
                          const Settings& settings, const Elements& elements, Prepare prepare) {
  const plugin::Call call({.plugin = &declaration.name, .doing = "while it was made"});
  auto object = plugins.host().create<Kind>(declaration.kind, declaration.name);
  prepare(*object);
  plugin::apply_parameters(declaration, *object, plugins.completed(declaration, settings),
                           plugins.completed(declaration, elements));
  return object;
}

/// Throws std::invalid_argument unless the plugin's structs are of this kind. `does`: "sensor 'x'
/// makes readings".
inline void require_kind(const ReadingKind& own, const ReadingKind& wanted,
                         const std::string& does) {
  if (own == wanted) return;
  throw std::invalid_argument(does + " of the kind '" + own.name + "' (" +
                              std::to_string(own.size) + " bytes), not '" + wanted.name + "' (" +
                              std::to_string(wanted.size) + " bytes)");
}

/// Passes what `before` remembers to `now` if both classes derive from Remembers; returns whether
/// they do.
inline bool hand_over(Component& before, Component& now) {
  auto* const from = dynamic_cast<Remembers*>(&before);
  auto* const to = dynamic_cast<Remembers*>(&now);
  if (!from || !to) {
    return false;
  }
  Memory memory;
  from->remember(memory);
  memory.begin_recall();
  to->remember(memory);
  return true;
}

}  // namespace elsie::testing
