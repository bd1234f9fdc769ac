// Compares a repeated run with the original.
#pragma once

#include <string>
#include <vector>

#include "elsie/batch/results_database.h"
#include "elsie/simulation/run_result.h"

namespace elsie::program {

/// Differences between a stored run and its replay: state hash, outcome, steps, and every measure.
/// A line for each, with the new and the old value. Times on the clock do not count.
std::vector<std::string> differences(const batch::RunRecord& before,
                                     const simulation::RunResult& now);

}  // namespace elsie::program
