// Physics engines are libraries of their own, `elsie/engines/NAME.so` beside libelsie, so that the
// core links none of them. Their interface is elsie/physics/engine.h.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace elsie::plugin {

/// The names of the engines that are installed, sorted.
std::vector<std::string> engine_names();

/// The library of an engine; it may not exist. `name` may also be a path without the suffix.
std::filesystem::path engine_file(const std::string& name);

/// The address of a symbol of an engine's library. The first call loads the library after comparing
/// its ABI word; it stays loaded. Throws PluginError, which names the library and what is wrong
/// with it.
void* engine_symbol(const std::string& name, const char* symbol);

}  // namespace elsie::plugin
