// The result of a run, for users and for programs.
#pragma once

#include <string>

#include "elsie/simulation/run_result.h"

namespace elsie::program {

/// A short table.
std::string table(const simulation::RunResult& result);

/// One JSON object on one line; see docs/running.md for its members.
std::string json(const simulation::RunResult& result);

/// "success after 12.3 s: all goals are reached".
std::string headline(const simulation::RunResult& result);
/// The same line from its parts.
std::string headline(const std::string& outcome, double simulated_s, const std::string& reason);

}  // namespace elsie::program
