#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elsie/base/problems.h"

#include "draft.h"

namespace elsie::experiment {

/// Returns the valid seeds, each once, in order; the others become problems. `element` is the
/// element in messages, "<seeds>"; `most` is the largest number of seeds.
std::vector<std::uint64_t> seeds_from(const SeedsDraft& draft, const std::string& element,
                                      std::uint64_t most, base::Problems& problems);

}  // namespace elsie::experiment
