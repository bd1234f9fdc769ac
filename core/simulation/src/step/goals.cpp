#include "step/goals.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

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
    if ((id.empty() || simulation.robot(i).description->id == id) && !test(i)) return false;
  }
  return true;
}

struct Judge {
  const Simulation& simulation;
  const GoalStart& start;

  Standing operator()(const world::CollectGoal& goal) const {
    const auto& obstacles = simulation.world().obstacles;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      if (obstacles[i].kind == world::ObstacleKind::resource &&
          (goal.team.empty() || obstacles[i].team == goal.team) && simulation.obstacle(i)) {
        return Standing::open;
      }
    }
    return Standing::reached;
  }
  Standing operator()(const world::ReachGoal& goal) const {
    return reached(every_robot(simulation, goal.robot, [&](std::size_t i) {
      const Vector2 place = position_of(goal);
      return is_near(simulation.robot(i).pose, place.x, place.y, goal.radius);
    }));
  }
  Standing operator()(const world::PushGoal& goal) const {
    const auto& obstacles = simulation.world().obstacles;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      if (obstacles[i].id == goal.obstacle) {
        const auto pose = simulation.obstacle(i);
        return reached(pose && is_near(*pose, goal.x, goal.y, goal.radius));
      }
    }
    return Standing::open;
  }
  Standing operator()(const world::GatherGoal& goal) const {
    // Robots gather at leaders, or at each other in a team without leaders or of leaders only.
    std::vector<Pose> leaders, followers;
    for (std::size_t i = 0; i < simulation.robots(); ++i) {
      const RobotView robot = simulation.robot(i);
      if (goal.team.empty() || robot.description->team == goal.team) {
        (robot.state->is_leader ? leaders : followers).push_back(robot.pose);
      }
    }
    const bool led = !leaders.empty() && !followers.empty();
    std::vector<Pose>& places = led || followers.empty() ? leaders : followers;
    std::sort(places.begin(), places.end(), [](const Pose& a, const Pose& b) { return a.x < b.x; });
    const std::vector<Pose>& all = led ? followers : places;
    const auto has_arrived = [&](const Pose& pose) {
      const auto first = std::lower_bound(places.begin(), places.end(), pose.x - goal.distance,
                                          [](const Pose& place, double x) { return place.x < x; });
      const auto last = std::upper_bound(first, places.end(), pose.x + goal.distance,
                                         [](double x, const Pose& place) { return x < place.x; });
      return std::any_of(first, last, [&](const Pose& place) {
        return &place != &pose && distance(pose, place) <= goal.distance;
      });
    };
    return reached(std::all_of(all.begin(), all.end(), has_arrived));
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
  Vector2 position_of(const world::ReachGoal& goal) const {
    for (std::size_t i = 0; i < simulation.robots() && !goal.of.empty(); ++i) {
      if (simulation.robot(i).description->id == goal.of) {
        return point_of(simulation.robot(i).pose, {goal.x, goal.y});
      }
    }
    return {goal.x, goal.y};
  }
  static Standing reached(bool yes) { return yes ? Standing::reached : Standing::open; }
  static Standing kept(bool yes) { return yes ? Standing::kept : Standing::broken; }
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
