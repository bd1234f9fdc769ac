#include "step/goals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "elsie/simulation/simulation.h"

namespace elsie::simulation {
namespace {

/// Times are sums of steps: 60000 steps of 0.01 s reach a limit of 600 s.
constexpr double kTimeTolerance = 1e-9;

enum class Standing { open, reached, kept, broken };

bool is_near(const Pose& pose, double x, double y, double radius) {
  return std::hypot(pose.x - x, pose.y - y) <= radius;
}

template <class Test>
bool every_robot(const Simulation& simulation, const std::string& id, Test test) {
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    if ((id.empty() || simulation.robot(i).description->id == id) && !test(i)) {
      return false;
    }
  }
  return true;
}

struct Judge {
  const Simulation& simulation;
  const GoalStart& start;

  Standing operator()(const world::CollectGoal& goal) const {
    const auto& boxes = simulation.world().boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].kind == world::BoxKind::resource &&
          (goal.team.empty() || boxes[i].team == goal.team) && simulation.box(i)) {
        return Standing::open;
      }
    }
    return Standing::reached;
  }
  Standing operator()(const world::ReachGoal& goal) const {
    return reached(every_robot(simulation, goal.robot, [&](std::size_t i) {
      const Vector2 place = place_of(goal);
      return is_near(simulation.robot(i).state->pose, place.x, place.y, goal.radius);
    }));
  }
  Standing operator()(const world::PushGoal& goal) const {
    const auto& boxes = simulation.world().boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].id == goal.box) {
        const auto pose = simulation.box(i);
        return reached(pose && is_near(*pose, goal.x, goal.y, goal.radius));
      }
    }
    return Standing::open;
  }
  Standing operator()(const world::GatherGoal& goal) const {
    for (std::size_t i = 0; i < simulation.robots(); ++i) {
      if (in_team(i, goal.team) && nearest_to_gather_at(i, goal.team) > goal.distance) {
        return Standing::open;
      }
    }
    return Standing::reached;
  }
  Standing operator()(const world::TravelGoal& goal) const {
    return reached(every_robot(simulation, goal.robot, [&](std::size_t i) {
      return simulation.robot(i).distance_m - done(i).distance_m >= goal.distance;
    }));
  }
  Standing operator()(const world::EndureGoal& goal) const {
    return reached(simulation.time_s() - start.time_s >= goal.time - kTimeTolerance);
  }
  Standing operator()(const world::NoCollisionGoal& goal) const {
    return kept(every_robot(simulation, goal.robot, [&](std::size_t i) {
      return simulation.robot(i).collisions == done(i).collisions;
    }));
  }
  Standing operator()(const world::BatteryGoal& goal) const {
    return kept(every_robot(simulation, goal.robot,
                            [&](std::size_t i) { return !simulation.robot(i).empty; }));
  }

 private:
  GoalStart::Done done(std::size_t i) const {
    return start.of(simulation.robot(i).description->id);
  }
  Vector2 place_of(const world::ReachGoal& goal) const {
    for (std::size_t i = 0; i < simulation.robots() && !goal.of.empty(); ++i) {
      if (simulation.robot(i).description->id == goal.of) {
        return point_of(simulation.robot(i).state->pose, {goal.x, goal.y});
      }
    }
    return {goal.x, goal.y};
  }
  static Standing reached(bool yes) { return yes ? Standing::reached : Standing::open; }
  static Standing kept(bool yes) { return yes ? Standing::kept : Standing::broken; }
  bool in_team(std::size_t i, const std::string& team) const {
    return team.empty() || simulation.robot(i).description->team == team;
  }
  bool leads(std::size_t i) const { return simulation.robot(i).state->is_leader; }
  /// Distance from a robot to the team's nearest leader; 0 for a leader. In a team without leaders,
  /// or of leaders only, the distance to the nearest mate.
  double nearest_to_gather_at(std::size_t robot, const std::string& team) const {
    bool has_leader = false, has_follower = false;
    for (std::size_t i = 0; i < simulation.robots(); ++i) {
      has_leader = has_leader || (in_team(i, team) && leads(i));
      has_follower = has_follower || (in_team(i, team) && !leads(i));
    }
    const bool led = has_leader && has_follower;
    if (led && leads(robot)) {
      return 0.0;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < simulation.robots(); ++i) {
      if (i != robot && in_team(i, team) && (!led || leads(i))) {
        nearest = std::min(nearest, distance(simulation.robot(robot).state->pose,
                                             simulation.robot(i).state->pose));
      }
    }
    return nearest;
  }
};

const char* broken_sentence(const world::Goal& goal) {
  return std::holds_alternative<world::NoCollisionGoal>(goal)
             ? "a robot collided, which a goal of the world forbids"
             : "a battery ran empty, which a goal of the world forbids";
}

}  // namespace

bool same_goal(const world::Goal& a, const world::Goal& b) {
  const auto what = [](const world::Goal& goal) {
    return std::visit(
        [](const auto& one) {
          std::pair<std::string, double> asked;
          if constexpr (requires { one.robot; }) asked.first = one.robot;
          if constexpr (requires { one.distance; }) asked.second = one.distance;
          if constexpr (requires { one.time; }) asked.second = one.time;
          return asked;
        },
        goal);
  };
  return a.index() == b.index() && what(a) == what(b);
}

Judgement judge(const Simulation& simulation, std::span<const GoalStart> starts) {
  bool any_to_reach = false;
  bool all_reached = true;
  auto start = starts.begin();
  for (const world::Goal& goal : simulation.world().goals) {
    switch (std::visit(Judge{simulation, *start++}, goal)) {
      case Standing::broken:
        return {Outcome::failure, broken_sentence(goal)};
      case Standing::open:
        all_reached = false;
        [[fallthrough]];
      case Standing::reached:
        any_to_reach = true;
        break;
      case Standing::kept:
        break;
    }
  }
  if (any_to_reach && all_reached) {
    return {Outcome::success, "all goals are reached"};
  }
  if (simulation.time_s() >= simulation.time_limit_s() - kTimeTolerance) {
    if (!any_to_reach && !simulation.world().goals.empty()) {
      return {Outcome::success, "all goals were kept until the time limit"};
    }
    return {Outcome::time_limit, "the limit of simulated time was met"};
  }
  return {};
}

}  // namespace elsie::simulation
