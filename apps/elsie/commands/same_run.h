// Whether a run that was done again came to the same.
#pragma once

#include <string>
#include <vector>

#include "elsie/batch/results_database.h"
#include "elsie/simulation/run_result.h"

namespace elsie::program {

/// What a run came to that was done before, as far as it differs from what it came to now: state
/// hash, outcome, steps, and every measure. One line each, with the value of now and that of
/// before. Times on the clock do not count.
std::vector<std::string> differences(const batch::RunRecord& before,
                                     const simulation::RunResult& now);

}  // namespace elsie::program
