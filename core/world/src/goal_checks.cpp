// Checks the goals of a world.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/plugin/host.h"

#include "reading.h"

namespace elsie::world {
namespace {

using base::number_text;

struct GoalCheck {
  const Reading& reading;
  const plugin::Host& host;
  Problems& problems;
  const World& world = reading.world;

  void check(const std::vector<Goal>& goals) const {
    for (const Goal& goal : goals) {
      std::visit(
          [&](const auto& each) {
            if (!reading.sound(each.location)) return;
            check_robots(each);
            (*this)(each);
          },
          goal);
    }
  }

  void operator()(const CollectGoal& goal) const {
    const bool any =
        std::any_of(world.obstacles.begin(), world.obstacles.end(), [&](const Obstacle& obstacle) {
          return obstacle.kind == ObstacleKind::resource &&
                 (goal.team.empty() || obstacle.team == goal.team);
        });
    if (!any) {
      problems.add(goal.location,
                   goal.team.empty()
                       ? "<collect> has nothing to collect; expected a <resource> in <resources>"
                       : "<collect> has nothing to collect; expected a <resource> of the team '" +
                             goal.team + "' in <resources>");
    }
  }
  void operator()(const ReachGoal& goal) const {
    if (goal.of.empty()) {
      check_place("<reach>", goal.x, goal.y, goal.location);
    } else if (goal.of == goal.robot) {
      problems.add(goal.location, "<reach> gives the robot '" + goal.robot +
                                      "' a place relative to itself; expected another robot in "
                                      "'of'");
    }
  }
  void operator()(const PushGoal& goal) const {
    check_place("<push>", goal.x, goal.y, goal.location);
    for (const Obstacle& obstacle : world.obstacles) {
      if (obstacle.id == goal.obstacle && !obstacle.is_dynamic()) {
        problems.add(goal.location, "<push>: " + obstacle.in_words() +
                                        " cannot be pushed; expected a <dynamic_" +
                                        obstacle.shape_name() + ">");
      }
    }
  }
  void operator()(const GatherGoal& goal) const {
    const auto size = std::count_if(world.robots.begin(), world.robots.end(),
                                    [&](const Robot& robot) { return robot.team == goal.team; });
    if (size < 2) {
      problems.add(goal.location, "<gather> needs at least two robots of the team '" + goal.team +
                                      "'; there " + (size == 1 ? "is 1" : "are none"));
    }
  }
  void operator()(const EndureGoal& goal) const {
    if (goal.time > world.limits.time) {
      problems.add(goal.location, "<endure> lasts " + number_text(goal.time) +
                                      " s, but the run ends after " +
                                      number_text(world.limits.time) + " s; see <limits>");
    }
  }
  void operator()(const EventGoal& goal) const {
    std::vector<std::string> raised = simulator_events();
    list_events(world.rules, host, raised);
    bool is_anyones = false;
    for (std::size_t i = 0; i < world.robots.size(); ++i) {
      if (!is_about(goal, world.robots[i])) continue;
      if (reading.incomplete_robots.contains(i)) return;
      list_events(world.robots[i], host, raised);
      is_anyones = true;
    }
    if (!is_anyones) return;  // there is no such robot
    require_event("<event> waits for", goal.name, raised,
                  !goal.robot.empty()  ? "the robot '" + goal.robot + "'"
                  : !goal.team.empty() ? "the team '" + goal.team + "'"
                                       : "this world",
                  goal.location, problems);
  }
  void operator()(const DeliverGoal& goal) const {
    const bool has_nest =
        std::any_of(world.nests.begin(), world.nests.end(), [&](const Nest& nest) {
          return nest.team.empty() || goal.team.empty() || nest.team == goal.team;
        });
    const bool has_cargo =
        std::any_of(world.obstacles.begin(), world.obstacles.end(), [&](const Obstacle& obstacle) {
          return obstacle.to_nest &&
                 (obstacle.team.empty() || goal.team.empty() || obstacle.team == goal.team);
        });
    if (has_nest && has_cargo) return;
    problems.add(goal.location, std::string("<deliver> has ") +
                                    (has_cargo ? "nowhere to deliver to; expected a <nest>"
                                               : "nothing to deliver; expected a <resource "
                                                 "collect=\"nest\">") +
                                    (goal.team.empty() ? "" : " for the team '" + goal.team + "'"));
  }
  void operator()(const AnyGoal& goal) const { check_group("<any>", goal); }
  void operator()(const AllGoal& goal) const { check_group("<all>", goal); }
  template <class Other>
  void operator()(const Other&) const {}

  void check_group(const std::string& what, const GoalGroup& group) const {
    if (group.goals.empty()) {
      problems.add(group.location,
                   what + " holds no goals; expected goals to reach in it, such as <reach>");
    }
    check(group.goals);
  }

  template <class About>
  static bool is_about(const About& goal, const Robot& robot) {
    return (goal.robot.empty() || robot.id == goal.robot) &&
           (goal.team.empty() || robot.team == goal.team);
  }

  // Checks which robots a goal is about.
  template <class About>
  void check_robots(const About& goal) const {
    if constexpr (requires { goal.robot, goal.team; }) {
      bool any = false;
      if constexpr (requires { goal.any; }) any = goal.any;
      if (!goal.robot.empty() && (any || !goal.team.empty())) {
        problems.add(goal.location, "the goal is about the robot '" + goal.robot +
                                        "' alone; expected no team=\"...\" and no any=\"...\" "
                                        "with robot=\"...\"");
      } else if (std::any_of(world.teams.begin(), world.teams.end(),
                             [&](const Team& team) { return team.id == goal.team; }) &&
                 std::none_of(world.robots.begin(), world.robots.end(),
                              [&](const Robot& robot) { return is_about(goal, robot); })) {
        problems.add(goal.location, "the goal is about robots of the team '" + goal.team +
                                        "', which has none; expected a team with robots");
      }
    }
  }

  void check_place(const std::string& what, double x, double y, const Location& where) const {
    if (std::abs(x) > 0.5 * world.arena.length || std::abs(y) > 0.5 * world.arena.width) {
      problems.add(where, what + ": the place (" + number_text(x) + ", " + number_text(y) +
                              ") is outside of the arena");
    }
  }
};

}  // namespace

void check_goals(const Reading& reading, const plugin::Host& host, Problems& problems) {
  GoalCheck{reading, host, problems}.check(reading.world.goals);
}

}  // namespace elsie::world
