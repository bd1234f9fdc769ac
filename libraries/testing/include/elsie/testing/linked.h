// Plugins that are linked into a program, as tests do.
#pragma once

#include <utility>
#include <vector>

#include "elsie/api/registration.h"
#include "elsie/plugin/host.h"

namespace elsie::testing {

/// Adds the plugins that ELSIE_... macros register in the program or library with this call. Throws
/// as plugin::Host::add() does.
__attribute__((visibility("hidden"))) inline void add_linked(plugin::Host& host) {
  std::vector<Declaration> declarations;
  elsie::detail::declare_plugins(declarations);
  for (Declaration& declaration : declarations) {
    host.add(std::move(declaration));
  }
}

}  // namespace elsie::testing
