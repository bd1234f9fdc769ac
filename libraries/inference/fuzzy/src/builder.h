// From statements to a model: everything is checked here that is not grammar.
#pragma once

#include <memory>

#include "elsie/fuzzy/fcl.h"

#include "ast.h"
#include "model_data.h"

namespace elsie::fuzzy {

/// Reports what does not fit together; the result is a model only when there are no problems.
std::shared_ptr<const ModelData> build(const ast::FunctionBlock& block, Problems& problems,
                                       Gaps gaps);

}  // namespace elsie::fuzzy
