#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elsie/base/problems.h"

#include "draft.h"

namespace elsie::experiment {

/// The valid seeds, each once, in order; the others become problems. `element` names what says
/// them, "<seeds>"; `most`: of them.
std::vector<std::uint64_t> seeds_from(const SeedsDraft& draft, const std::string& element,
                                      std::uint64_t most, base::Problems& problems);

}  // namespace elsie::experiment
