// Expectations, held against the results.
#pragma once

#include "elsie/experiment/grid.h"
#include "elsie/report/findings.h"

namespace elsie::report {

/// `findings` has its results and cells already; `grid` is that of its cells.
Verdict judge(const experiment::Expectation& expectation, const Findings& findings,
              const experiment::Grid& grid);

}  // namespace elsie::report
