// Checks of plugins' declarations.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"

namespace elsie::plugin {

/// The faults of a declaration, each a sentence that names the plugin. Names are a small letter
/// followed by small letters, digits and underscores; no parameter, event or reading is declared
/// twice; ranges are not empty, and defaults lie in them; sensors produce one kind of reading and
/// need none, and nothing else produces any; measures need no readings and raise no events.
std::vector<std::string> check_declaration(const Declaration& declaration);

/// The faults of all declarations of one library, among them two plugins of the same kind and name.
std::vector<std::string> check_declarations(std::span<const Declaration> declarations);

}  // namespace elsie::plugin
