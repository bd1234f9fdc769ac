// Parts of the core that are separate libraries in elsie/, next to libelsie, so that the core links
// none of them: physics engines, `elsie/engines/NAME.so` with the interface elsie/physics/engine.h,
// `elsie/layouts.so`, which draws layouts (elsie/world/layouts.h), and `elsie/images.so`, which
// reads images (elsie/world/images.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace elsie::plugin {

/// The names of the engines that are installed, sorted.
std::vector<std::string> engine_names();

/// The library of an engine; it may not exist. `name` may also be a path without the suffix.
std::filesystem::path engine_file(const std::string& name);

/// The library of another part, such as "layouts"; it may not exist.
std::filesystem::path part_file(const std::string& name);

/// The address of a symbol of such a library. The first call loads the library after comparing its
/// ABI word; it stays loaded. Throws PluginError, which calls the library `what` ("the physics
/// engine 'ode'") and says what is wrong with it.
void* part_symbol(const std::string& what, const std::filesystem::path& file, const char* symbol);
/// The same for an engine.
void* engine_symbol(const std::string& name, const char* symbol);

}  // namespace elsie::plugin
