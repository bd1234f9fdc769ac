// FCL tokens to statements.
#pragma once

#include <string_view>

#include "ast.h"
#include "problems.h"

namespace elsie::fuzzy {

/// Reads one function block. A statement that is not understood is reported and left out; the
/// caller must not use the result as a model when there are problems.
ast::FunctionBlock parse(std::string_view text, Problems& problems);

}  // namespace elsie::fuzzy
