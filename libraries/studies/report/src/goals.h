// Which worlds have goals, and which runs never reached theirs.
#pragma once

#include <vector>

#include "elsie/report/results.h"

namespace elsie::report {

/// For each cell whether its world has goals. A world that cannot be read, in a damaged database,
/// counts as having some: its cell keeps its success rate, and its runs without success are listed.
std::vector<bool> cells_with_goals(const Results& results);

/// Returns whether the run of a world with goals ended normally without reaching them: its time is
/// only a bound.
bool never_arrived(const Run& run, bool goals);

}  // namespace elsie::report
