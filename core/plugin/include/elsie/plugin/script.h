// Plugins in a language that is interpreted: a file of the plugin path that ends in ".py".
//
// The core knows no Python. `elsie/python.so`, next to libelsie, starts the interpreter when the
// host meets the first such file that declares plugins, and makes their declarations. Without that
// library, or without Python on the machine, such files are left out, and the report says so.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"

namespace elsie::plugin {

/// What a script declares.
struct Script {
  std::shared_ptr<const void> kept;  // its classes: released after everything that is made of them
  std::vector<Declaration> declarations;
  std::string missing;  // a sentence: there is no interpreter
};

/// The function `elsie_load_script` of elsie/python.so. Throws std::runtime_error with a sentence
/// that names the line, if the script fails.
using LoadScript = void (*)(const std::filesystem::path& file, Script& script);
#define ELSIE_LOAD_SCRIPT "elsie_load_script"

/// Whether the name of a file is that of a script.
bool is_script(const std::filesystem::path& file);
/// Whether a file of this name may hold plugins: a library or a script.
bool may_hold_plugins(const std::filesystem::path& file);

}  // namespace elsie::plugin
