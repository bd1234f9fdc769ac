#include "step/goals.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <type_traits>
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

/// Whether a goal is about this robot.
template <class About>
bool is_about(const About& goal, const world::Robot& robot) {
  return (goal.robot.empty() || robot.id == goal.robot) &&
         (goal.team.empty() || robot.team == goal.team);
}

/// Whether the robots that a goal is about pass a test: each of them or, with `any`, one. There may
/// be none: then they do not, unless the goal is one to keep.
template <class About, class Test>
bool do_robots(const Simulation& simulation, const About& goal, Test test) {
  bool any = false, is_passed = true;
  if constexpr (requires { goal.any; }) {
    any = goal.any;
    is_passed = false;
  }
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    if (!is_about(goal, *simulation.robot(i).description)) continue;
    if (test(i) == any) return any;
    is_passed = !any;
  }
  return is_passed;
}

/// Judges the goals of a world in their order.
class Judge {
 public:
  Judge(const Simulation& simulation, std::span<GoalProgress> progress)
      : simulation_(simulation), next_(progress.data()) {}

  Standing of(const world::Goal& goal) {
    return std::visit(
        [&](const auto& one) {
          using Kind = std::remove_cvref_t<decltype(one)>;
          if constexpr (!std::is_base_of_v<world::GoalGroup, Kind>) progress_ = next_++;
          return standing(one);
        },
        goal);
  }

 private:
  Standing standing(const world::CollectGoal& goal) const {
    const auto& obstacles = simulation_.world().obstacles;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      if (obstacles[i].kind == world::ObstacleKind::resource &&
          (goal.team.empty() || obstacles[i].team == goal.team) && simulation_.obstacle(i)) {
        return Standing::open;
      }
    }
    return Standing::reached;
  }
  Standing standing(const world::ReachGoal& goal) const {
    const Vector2 place = position_of(goal);
    return reached(do_robots(simulation_, goal, [&](std::size_t i) {
      if (id_of(i) == goal.of) return !goal.any;  // the others count
      return is_near(simulation_.robot(i).pose, place.x, place.y, goal.radius);
    }));
  }
  Standing standing(const world::PushGoal& goal) const {
    const auto& obstacles = simulation_.world().obstacles;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      if (obstacles[i].id == goal.obstacle) {
        const auto pose = simulation_.obstacle(i);
        return reached(pose && is_near(*pose, goal.x, goal.y, goal.radius));
      }
    }
    return Standing::open;
  }
  Standing standing(const world::GatherGoal& goal) const {
    // Robots gather at leaders, or at each other in a team without leaders or of leaders only.
    std::vector<Pose> leaders, followers;
    for (std::size_t i = 0; i < simulation_.robots(); ++i) {
      const RobotView robot = simulation_.robot(i);
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
  Standing standing(const world::TravelGoal& goal) const {
    return reached(do_robots(simulation_, goal, [&](std::size_t i) {
      return simulation_.robot(i).distance_m - progress_->of(id_of(i)).distance_m >= goal.distance;
    }));
  }
  Standing standing(const world::EndureGoal& goal) const {
    return reached(simulation_.time_s() - progress_->time_s >= goal.time - kTimeTolerance);
  }
  Standing standing(const world::NoCollisionGoal& goal) const {
    return kept(do_robots(simulation_, goal, [&](std::size_t i) {
      return simulation_.robot(i).collisions == progress_->of(id_of(i)).collisions;
    }));
  }
  Standing standing(const world::BatteryGoal& goal) const {
    return kept(
        do_robots(simulation_, goal, [&](std::size_t i) { return !simulation_.robot(i).empty; }));
  }
  /// Reads only what is new in the log of the run.
  Standing standing(const world::EventGoal& goal) const {
    const auto events = simulation_.events();
    for (std::size_t& i = progress_->events_read; i < events.size(); ++i) {
      const EventRecord& event = events[i];
      if (events::name_of(event.event) == goal.name && is_of(goal, event.robot)) {
        ++progress_->events;
      }
    }
    return reached(progress_->events >= goal.count);
  }
  // All goals of a group are judged, because each may count something.
  Standing standing(const world::AnyGoal& group) { return reached(reached_of(group) > 0); }
  Standing standing(const world::AllGoal& group) {
    return reached(reached_of(group) == group.goals.size());
  }
  std::size_t reached_of(const world::GoalGroup& group) {
    std::size_t count = 0;
    for (const world::Goal& goal : group.goals) count += of(goal) == Standing::reached ? 1 : 0;
    return count;
  }

  const std::string& id_of(std::size_t robot) const {
    return simulation_.robot(robot).description->id;
  }
  /// Whether a goal is about the robot that raised an event.
  bool is_of(const world::EventGoal& goal, const std::string& robot) const {
    if (!goal.robot.empty()) return robot == goal.robot;
    for (std::size_t i = 0; i < simulation_.robots(); ++i) {
      if (id_of(i) == robot) return is_about(goal, *simulation_.robot(i).description);
    }
    return goal.team.empty();
  }
  Vector2 position_of(const world::ReachGoal& goal) const {
    for (std::size_t i = 0; i < simulation_.robots() && !goal.of.empty(); ++i) {
      if (id_of(i) == goal.of) {
        return point_of(simulation_.robot(i).pose, {goal.x, goal.y});
      }
    }
    return {goal.x, goal.y};
  }
  static Standing reached(bool yes) { return yes ? Standing::reached : Standing::open; }
  static Standing kept(bool yes) { return yes ? Standing::kept : Standing::broken; }

  const Simulation& simulation_;
  GoalProgress* next_;                // of the next goal that is not a group
  GoalProgress* progress_ = nullptr;  // of the one that is judged
};

const char* broken_sentence(const world::Goal& goal) {
  return std::holds_alternative<world::NoCollisionGoal>(goal)
             ? "a robot collided, which a goal of the world forbids"
             : "a battery ran empty, which a goal of the world forbids";
}

}  // namespace

std::vector<const world::Goal*> single_goals(const std::vector<world::Goal>& goals) {
  std::vector<const world::Goal*> all;
  world::for_each_goal(goals, [&](const world::Goal& goal) { all.push_back(&goal); });
  return all;
}

bool same_goal(const world::Goal& a, const world::Goal& b) {
  const auto what = [](const world::Goal& goal) {
    return std::visit(
        [](const auto& one) {
          std::tuple<std::string, std::string, std::string, bool, double> asked;
          auto& [name, robot, team, any, amount] = asked;
          if constexpr (requires { one.name; }) name = one.name;
          if constexpr (requires { one.robot, one.team; }) {
            robot = one.robot;
            team = one.team;
          }
          if constexpr (requires { one.any; }) any = one.any;
          if constexpr (requires { one.distance; }) amount = one.distance;
          if constexpr (requires { one.time; }) amount = one.time;
          return asked;
        },
        goal);
  };
  return a.index() == b.index() && what(a) == what(b);
}

Judgement judge(const Simulation& simulation, std::span<GoalProgress> progress) {
  bool any_to_reach = false;
  bool all_reached = true;
  Judge judge(simulation, progress);
  for (const world::Goal& goal : simulation.world().goals) {
    switch (judge.of(goal)) {
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
