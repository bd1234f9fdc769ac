// Builds a model from statements, and checks everything that is not grammar.
#pragma once

#include <memory>

#include "elsie/fuzzy/fcl.h"

#include "ast.h"
#include "model_data.h"
#include "problems.h"

namespace elsie::fuzzy {

/// Reports contradictions; the result is a model only if there are no problems.
std::shared_ptr<const ModelData> build(const ast::FunctionBlock& block, Problems& problems,
                                       Gaps gaps);

}  // namespace elsie::fuzzy
