// The vocabulary of worlds, plugins and events as JSON, for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "elsie/api/declaration.h"
#include "elsie/plugin/host.h"

namespace elsie::reference {

using Json = nlohmann::ordered_json;

/// The elements of world files by their names: `meaning`; `attributes`, each with `name`, `type`,
/// `unit`, `default`, `meaning`, bounds, `choices`, `form` ("id", "colour"), `refers_to` ("team",
/// "robot", "box") and the `cost` of an edit in a run; `children`; `holds`, the kind of the plugins
/// after which its children are named; `members`, the word for these in paths. The attributes that
/// all plugins of a kind may have stand under the name of the kind.
Json world_json();

/// A plugin's declaration and its library.
Json plugin_json(const plugin::Host& host, const Declaration& plugin);

/// `plugins`: all of them. `directories`: where they were looked for, and each file there.
Json plugins_json(const plugin::Host& host);

/// `simulator` and `plugins`: the events of both.
Json events_json(const plugin::Host& host);

/// "loaded", "ignored" or "refused".
const char* to_string(plugin::FileStatus status);

}  // namespace elsie::reference
