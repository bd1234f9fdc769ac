// Plugins that are linked into the program instead of loaded: for tests, and for programs that
// bring their own.
#pragma once

#include <utility>
#include <vector>

#include "elsie/api/registration.h"
#include "elsie/plugin/host.h"

namespace elsie::plugin {

/// Adds every plugin that an ELSIE_... macro registered in the program or library that this call is
/// compiled into. Throws as Host::add() does.
__attribute__((visibility("hidden"))) inline void add_linked(Host& host) {
  std::vector<Declaration> declarations;
  elsie::detail::declare_plugins(declarations);
  for (Declaration& declaration : declarations) {
    host.add(std::move(declaration));
  }
}

}  // namespace elsie::plugin
