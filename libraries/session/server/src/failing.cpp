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
    if (left > 0) missing_.push_back({{"goal", "collect"}, {"missing", left}, {"of", all}});
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
    }
  }
  /// What is missing of each robot that a goal is about or, where one is enough, of the nearest.
  template <class About, class Missing_m>
  void add_robots(const char* kind, const About& goal, const Missing_m& missing_m) {
    std::vector<std::pair<double, std::string>> all;
    for (std::size_t i = 0; i < simulation_.robots(); ++i) {
      const RobotView robot = simulation_.robot(i);
      if ((goal.robot.empty() || robot.description->id == goal.robot) &&
          (goal.team.empty() || robot.description->team == goal.team)) {
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

}  // namespace

Json standstills_json(const std::vector<traces::Standstill>& found) {
  Json robots = Json::array();
  for (std::size_t i = 0; i < std::min(found.size(), kMostListed); ++i) {
    robots.push_back({{"robot", found[i].robot},
                      {"since_s", found[i].since_s},
                      {"why", to_string(found[i].why)},
                      {"behaviors", found[i].behaviors}});
  }
  return {{"stuck", std::move(robots)}, {"stuck_count", found.size()}};
}

Json broken_by_json(const Simulation& simulation) {
  const auto events = simulation.events();
  for (auto event = events.rbegin(); event != events.rend(); ++event) {
    if (event->as<events::Collision>() || event->as<events::BatteryEmpty>()) {
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
