// Deciding whether a run has reached its goals.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "elsie/simulation/run_result.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

class Simulation;

/// What one goal counts from, and what has been counted. Groups have none, the goals in them do.
struct GoalProgress {
  struct Done {
    double distance_m = 0.0;
    int collisions = 0;
  };
  // The state when an edit added the goal; empty for goals from the start.
  double time_s = 0.0;
  std::map<std::string, Done> done;  // by the robot's id; a robot without an entry was added later
  // The events of the run that have been read, and those of them that count.
  std::size_t events_read = 0;
  int events = 0;

  Done of(const std::string& robot) const {
    const auto known = done.find(robot);
    return known == done.end() ? Done{} : known->second;
  }
};

/// The goals that are not groups, at any depth.
std::vector<const world::Goal*> single_goals(const std::vector<world::Goal>& goals);

/// Returns whether two such goals are the same, so that the second keeps the progress of the first.
bool same_goal(const world::Goal& a, const world::Goal& b);

struct Judgement {
  Outcome outcome = Outcome::running;
  std::string reason;
};

/// Failure when a goal to keep is broken; success when all goals to reach are met, or at the time
/// limit when there are only goals to keep; else time_limit at the world's limit of simulated time.
/// `progress`: one for each of the single_goals(), in their order; kept up to date.
Judgement judge(const Simulation& simulation, std::span<GoalProgress> progress);

}  // namespace elsie::simulation
