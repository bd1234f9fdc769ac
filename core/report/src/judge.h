// Expectations, held against the results.
#pragma once

#include "elsie/report/findings.h"

namespace elsie::report {

/// `findings` has its results and cells already.
Verdict judge(const experiment::Expectation& expectation, const Findings& findings);

}  // namespace elsie::report
