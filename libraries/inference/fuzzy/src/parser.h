// FCL tokens to statements.
#pragma once

#include <string_view>
#include <vector>

#include "elsie/fuzzy/error.h"

#include "ast.h"

namespace elsie::fuzzy {

/// Reads all function blocks. A statement that is not understood is reported and left out; the
/// caller must not use the result as a model when there are problems. After too many of them
/// reading ends: the last block then has the last line 0, and those after it are missing.
std::vector<ast::FunctionBlock> parse(std::string_view text, Problems& problems);

}  // namespace elsie::fuzzy
