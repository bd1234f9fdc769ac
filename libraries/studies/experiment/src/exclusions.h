// Combinations of levels that are left out: from the file's elements to choices of cells.
#pragma once

#include <vector>

#include "elsie/base/problems.h"
#include "elsie/experiment/experiment.h"

#include "draft.h"

namespace elsie::experiment {

/// The experiment must have its worlds and factors, and no exclusions yet. One that matches no
/// cell that is left, and the one that leaves none, become problems.
std::vector<Exclusion> exclusions_from(const std::vector<ExclusionDraft>& drafts,
                                       const Experiment& experiment, base::Problems& problems);

}  // namespace elsie::experiment
