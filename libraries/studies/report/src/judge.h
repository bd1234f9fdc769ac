// Evaluates expectations on the results.
#pragma once

#include "elsie/experiment/grid.h"
#include "elsie/report/findings.h"

namespace elsie::report {

/// `findings` must have its results and cells; `grid` is the grid of these cells.
Verdict judge(const experiment::Expectation& expectation, const Findings& findings,
              const experiment::Grid& grid);

}  // namespace elsie::report
