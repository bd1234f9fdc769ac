#pragma once

#include <cstdint>
#include <vector>

#include "elsie/base/problems.h"

#include "draft.h"

namespace elsie::experiment {

/// The seeds that are named, each once, in order; without those that are none.
std::vector<std::uint64_t> seeds_from(const SeedsDraft& draft, base::Problems& problems);

}  // namespace elsie::experiment
