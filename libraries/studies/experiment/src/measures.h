// Measures to show, and those that are computed from others.
#pragma once

#include <vector>

#include "elsie/base/problems.h"
#include "elsie/experiment/experiment.h"

#include "cell_check.h"
#include "draft.h"

namespace elsie::experiment {

/// The measures in order, each name once. Formulas with mistakes become problems, and stay: what
/// is expected of them is no further mistake.
std::vector<MeasureUse> measures_from(const std::vector<MeasureDraft>& drafts,
                                      const std::vector<Factor>& factors, base::Problems& problems);

/// Adds each formula to the lists of the cells whose runs have all that is in it. Names that no
/// cell has, and factors that are called like a measure, become problems.
void add_formulas(const Experiment& experiment, CellMeasures& measures, base::Problems& problems);

}  // namespace elsie::experiment
