// What is allowed in a world, but cannot be meant.
#pragma once

#include <vector>

#include "elsie/base/problems.h"

namespace elsie::simulation {
class Simulation;
}

namespace elsie::check {

/// Goals that no robot can reach, and boxes that the beams of a robot look over: a warning for each
/// goal, and for the first such box of each robot. Edits of the running world are not foreseen:
/// they may make possible what is not.
std::vector<base::Problem> doubts(const simulation::Simulation& simulation);

}  // namespace elsie::check
