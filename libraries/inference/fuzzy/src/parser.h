// Reads statements from FCL tokens.
#pragma once

#include <string_view>
#include <vector>

#include "ast.h"
#include "problems.h"

namespace elsie::fuzzy {

/// Reads all function blocks. Statements with errors are reported and left out; with problems, the
/// caller must not use the result as a model. Reading ends after too many problems: the last block
/// then has the last line 0, and later ones are missing.
std::vector<ast::FunctionBlock> parse(std::string_view text, Problems& problems);

}  // namespace elsie::fuzzy
