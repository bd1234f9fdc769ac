#include "failing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace elsie::server {
namespace {

using simulation::RobotView;
using simulation::Simulation;

constexpr std::size_t kMostListed = 20;  // nobody reads more

/// Whether a goal of some robots is one of this robot.
template <class About>
bool is_about(const About& goal, const world::Robot& robot) {
  return (goal.robot.empty() || robot.id == goal.robot) &&
         (goal.team.empty() || robot.team == goal.team);
}

/// Adds what is missing of each goal.
class Missing {
 public:
  explicit Missing(const Simulation& simulation) : simulation_(simulation) {}

  void add(const std::vector<world::Goal>& goals) {
    for (const world::Goal& goal : goals) {
      std::visit([this](const auto& one) { add(one); }, goal);
    }
  }
  Json take() { return std::move(missing_); }

 private:
  void add(const world::CollectGoal& goal) {
    const auto& obstacles = simulation_.world().obstacles;
    int all = 0, left = 0;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      if (obstacles[i].kind == world::ObstacleKind::resource &&
          (goal.team.empty() || obstacles[i].team == goal.team)) {
        ++all;
        left += simulation_.obstacle(i) ? 1 : 0;
      }
    }
    if (left > 0) {
      missing_.push_back({{"goal", "collect"}, {"missing", left}, {"of", all}});
      if (!goal.team.empty()) missing_.back()["team"] = goal.team;
    }
  }
  void add(const world::ReachGoal& goal) {
    if (!goal.of.empty()) return;
    add_robots("reach", goal, [&](const RobotView& robot) {
      return std::hypot(robot.pose.x - goal.x, robot.pose.y - goal.y) - goal.radius;
    });
  }
  void add(const world::TravelGoal& goal) {
    add_robots("travel", goal,
               [&](const RobotView& robot) { return goal.distance - robot.distance_m; });
  }
  void add(const world::PushGoal& goal) {
    const auto& obstacles = simulation_.world().obstacles;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      const auto pose = simulation_.obstacle(i);
      if (obstacles[i].id != goal.obstacle || !pose) continue;
      const double far_m = std::hypot(pose->x - goal.x, pose->y - goal.y) - goal.radius;
      if (far_m > 0.0) {
        missing_.push_back({{"goal", "push"}, {"obstacle", goal.obstacle}, {"missing_m", far_m}});
      }
    }
  }
  void add(const world::EventGoal& goal) { add_events("event", goal); }
  void add(const world::DeliverGoal& goal) { add_events("deliver", goal); }
  void add(const world::AllGoal& group) { add(group.goals); }
  template <class Other>
  void add(const Other&) {}

  void add_events(const char* kind, const world::EventGoal& goal) {
    const auto& events = simulation_.events();
    const auto count = std::count_if(events.begin(), events.end(), [&](const auto& event) {
      return event.name() == goal.name && (goal.robot.empty() || event.robot == goal.robot);
    });
    if (goal.team.empty() && count < goal.count) {
      missing_.push_back({{"goal", kind},
                          {"name", goal.name},
                          {"missing", goal.count - count},
                          {"of", goal.count}});
      if (!goal.robot.empty()) missing_.back()["robot"] = goal.robot;
    }
  }
  /// What is missing of each robot that a goal is about or, where one is enough, of the nearest.
  template <class About, class Missing_m>
  void add_robots(const char* kind, const About& goal, const Missing_m& missing_m) {
    std::vector<std::pair<double, std::string>> all;
    for (std::size_t i = 0; i < simulation_.robots(); ++i) {
      const RobotView robot = simulation_.robot(i);
      if (is_about(goal, *robot.description)) {
        all.emplace_back(missing_m(robot), robot.description->id);
      }
    }
    if (goal.any && !all.empty()) all = {*std::min_element(all.begin(), all.end())};
    for (const auto& [missing, robot] : all) {
      if (missing > 0.0 && missing_.size() < kMostListed) {
        missing_.push_back({{"goal", kind}, {"robot", robot}, {"missing_m", missing}});
      }
    }
  }

  const Simulation& simulation_;
  Json missing_ = Json::array();
};

/// Whether an open goal needs a robot, or may need it.
class Awaits {
 public:
  explicit Awaits(const Simulation& simulation)
      : simulation_(simulation), open_(open_goals_json(simulation)) {}

  bool operator()(const traces::Standstill& robot) const {
    return std::any_of(open_.begin(), open_.end(), [&](const Json& goal) {
      const std::string named = goal.value("robot", std::string());
      const std::string team = goal.value("team", std::string());
      return (named.empty() || named == robot.robot) &&
             (team.empty() || team == team_of(robot.robot));
    });
  }

 private:
  std::string team_of(const std::string& id) const {
    for (std::size_t i = 0; i < simulation_.robots(); ++i) {
      const world::Robot& robot = *simulation_.robot(i).description;
      if (robot.id == id) return robot.team;
    }
    return {};
  }

  const Simulation& simulation_;
  Json open_;
};

template <class Goal, class Event>
bool breaks_goal(const Simulation& simulation, const world::Goal& goal,
                 const simulation::EventRecord& event) {
  const auto* const kept = std::get_if<Goal>(&goal);
  if (!kept || !event.as<Event>()) return false;
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    const auto& robot = *simulation.robot(i).description;
    if (robot.id == event.robot) return is_about(*kept, robot);
  }
  return false;
}

}  // namespace

Json standstills_json(const Simulation& simulation, std::vector<traces::Standstill> found) {
  const auto idle = std::stable_partition(
      found.begin(), found.end(),
      [](const traces::Standstill& each) { return each.why != traces::Hold::idle; });
  const auto troubled = idle - found.begin();
  const auto awaited = std::stable_partition(idle, found.end(), Awaits(simulation)) - idle;
  const auto all = found.size();
  found.resize(std::min(all, kMostListed));
  Json robots = Json::array();
  for (const traces::Standstill& each : found) {
    robots.push_back({{"robot", each.robot},
                      {"since_s", each.since_s},
                      {"why", to_string(each.why)},
                      {"behaviors", each.behaviors}});
  }
  return {{"stuck", std::move(robots)},
          {"stuck_count", all},
          {"troubled_count", troubled},
          {"awaited_count", awaited}};
}

Json broken_by_json(const Simulation& simulation) {
  const auto events = simulation.events();
  const auto& goals = simulation.world().goals;
  for (auto event = events.rbegin(); event != events.rend(); ++event) {
    const auto breaks = [&](const world::Goal& goal) {
      return breaks_goal<world::NoCollisionGoal, events::Collision>(simulation, goal, *event) ||
             breaks_goal<world::BatteryGoal, events::BatteryEmpty>(simulation, goal, *event);
    };
    if (std::any_of(goals.begin(), goals.end(), breaks)) {
      return {{"name", event->name()},
              {"robot", event->robot},
              {"detail", event->detail()},
              {"time_s", event->time_s}};
    }
  }
  return {};
}

Json open_goals_json(const Simulation& simulation) {
  Missing missing(simulation);
  missing.add(simulation.world().goals);
  return missing.take();
}

}  // namespace elsie::server
