#pragma once

#include <cstdint>
#include <vector>

#include "elsie/base/problems.h"

#include "draft.h"

namespace elsie::experiment {

/// Returns the valid seeds, each once, in order; the others become problems.
std::vector<std::uint64_t> seeds_from(const SeedsDraft& draft, base::Problems& problems);

}  // namespace elsie::experiment
