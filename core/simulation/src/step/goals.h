// Deciding whether a run has reached its goals.
#pragma once

#include <string>

#include "elsie/simulation/run_result.h"

namespace elsie::simulation {

class Simulation;

struct Verdict {
  Outcome outcome = Outcome::running;
  std::string reason;
};

/// Failure when a goal to keep is broken; success when all goals to reach are met, or at the time
/// limit when there are only goals to keep; else time_limit at the world's limit of simulated time.
Verdict judge(const Simulation& simulation);

}  // namespace elsie::simulation
