// Measures that are computed from others when results are read.
#pragma once

#include <string>
#include <vector>

#include "elsie/experiment/experiment.h"
#include "elsie/report/results.h"

namespace elsie::report {

/// Adds the formulas among these measures to the results, in their order. A run has no value where
/// it lacks one that the formula names, and where the formula has none, as in a division by 0. The
/// runs of the second kind are counted in the measure's meaning, and each such formula gives a
/// sentence. Formulas with names that the results do not have are left out.
///
/// The time of a run that never reached its goals is only a lower bound, and so is a formula that
/// rises with it (Run::bounds). A formula that falls with it is a rate if it names another measure
/// of the run, and keeps its value. Any other formula has no value in such a run: these are counted
/// like runs without a value, with a sentence. Whether a formula rises is tested with longer times,
/// all other values being the run's own.
std::vector<std::string> add_formulas(Results& results,
                                      const std::vector<experiment::MeasureUse>& uses);

}  // namespace elsie::report
