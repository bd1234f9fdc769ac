// The robots of a measure: one, those of a team, or all.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/measure.h>

class ChosenRobots {
 public:
  std::string robot;
  std::string team;

 protected:
  ChosenRobots() = default;
  ~ChosenRobots() = default;

  /// Throws std::invalid_argument when there are no such robots.
  void choose(const elsie::Observation& start) {
    if (!robot.empty() && !team.empty()) {
      throw std::invalid_argument("it names both a robot, '" + robot + "', and a team, '" + team +
                                  "'; expected one of them, or none for all robots");
    }
    if (!robot.empty()) {
      start.robot(robot);
    }
    if (!team.empty()) {
      start.require_team(team);
    }
    chosen_.clear();
    for (std::size_t i = 0; i < start.robots.size(); ++i) {
      const elsie::ObservedRobot& each = start.robots[i];
      if ((robot.empty() || each.id == robot) && (team.empty() || each.team == team)) {
        chosen_.push_back(i);
      }
    }
    if (chosen_.empty()) {
      throw std::invalid_argument(team.empty() ? "there is no robot in the world"
                                               : "the team '" + team + "' has no robot");
    }
  }

  /// Indices of the robots in the world.
  const std::vector<std::size_t>& chosen() const { return chosen_; }

  /// The sum of a value over the robots.
  template <class Value>
  Value sum(const elsie::Observation& now, Value elsie::ObservedRobot::*member) const {
    Value all{};
    for (const std::size_t i : chosen_) {
      all += now.robots[i].*member;
    }
    return all;
  }

 private:
  std::vector<std::size_t> chosen_;
};

/// Parameters for the declaration of such a measure.
#define CHOSEN_ROBOTS_PARAMETERS                                                  \
  elsie::parameter("robot", &ChosenRobots::robot,                                 \
                   {.meaning = "only this one; by default all robots together"}), \
      elsie::parameter("team", &ChosenRobots::team, {.meaning = "only those of this team"})
