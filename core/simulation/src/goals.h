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

/// Success when all goals to reach are met; failure when a goal to keep is broken, or is all that
/// there is to be decided at the time limit; the simulated time limit of the world.
Verdict judge(const Simulation& simulation);

}  // namespace elsie::simulation
