// Why an element of a plugin may not stand where it does, as the end of a sentence.
#pragma once

#include <string>

#include "elsie/api/declaration.h"
#include "elsie/world/markup.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

/// No plugin of this kind has this name: it is of another kind, or was not found.
std::string explain_missing(const plugin::Host& host, PluginKind kind, const std::string& name);

/// The plugin with this declaration may not hold `child`.
std::string explain_child(const plugin::Host& host, const Declaration& declaration,
                          const Element& child);

}  // namespace elsie::world
