// The result of a run, for people and for programs.
#pragma once

#include <string>

#include "elsie/simulation/run_result.h"

/// A short table.
std::string table(const elsie::simulation::RunResult& result);

/// One JSON object on one line; see docs/running.md for its members.
std::string json(const elsie::simulation::RunResult& result);

/// "success after 12.3 s: all goals are reached".
std::string headline(const elsie::simulation::RunResult& result);
/// The same line for a run of which only this is known.
std::string headline(const std::string& outcome, double simulated_s, const std::string& reason);
