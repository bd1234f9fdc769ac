// Deciding whether a run has reached its goals.
#pragma once

#include <map>
#include <span>
#include <string>

#include "elsie/simulation/run_result.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

class Simulation;

/// The state when an edit added a goal; empty for goals from the start.
struct GoalStart {
  struct Done {
    double distance_m = 0.0;
    int collisions = 0;
  };
  double time_s = 0.0;
  std::map<std::string, Done> done;  // by the robot's id; a robot without an entry was added later
  Done of(const std::string& robot) const {
    const auto known = done.find(robot);
    return known == done.end() ? Done{} : known->second;
  }
};

/// Returns whether two goals are the same, so that the second keeps the start of the first.
bool same_goal(const world::Goal& a, const world::Goal& b);

struct Judgement {
  Outcome outcome = Outcome::running;
  std::string reason;
};

/// Failure when a goal to keep is broken; success when all goals to reach are met, or at the time
/// limit when there are only goals to keep; else time_limit at the world's limit of simulated time.
/// `starts`: one for each goal, in their order.
Judgement judge(const Simulation& simulation, std::span<const GoalStart> starts);

}  // namespace elsie::simulation
