// The M-line of a bug: from where it began to its goal.
#pragma once

#include <algorithm>
#include <cmath>

#include <elsie/api/geometry.h>
#include <elsie/api/remember.h>

class MLine {
 public:
  void begin(const elsie::Pose& start, const elsie::Vector2& goal) {
    start_ = last_ = {start.x, start.y};
    goal_ = goal;
  }
  const elsie::Vector2& goal() const { return goal_; }

  /// In each step. Returns whether the robot is on the line, or has crossed it in this step.
  bool meets(const elsie::Pose& pose) {
    constexpr double kBand = 0.01;  // m, half the width of the line
    const elsie::Vector2 here{pose.x, pose.y};
    const double off = aside(here), before = aside(last_);
    last_ = here;
    return std::abs(off) < kBand || off * before < 0.0;
  }

  void remember(elsie::Memory& memory) {
    memory("start_x", start_.x);
    memory("start_y", start_.y);
    memory("last_x", last_.x);
    memory("last_y", last_.y);
    memory("goal_x", goal_.x);
    memory("goal_y", goal_.y);
  }

 private:
  /// m, to the left of the line
  double aside(const elsie::Vector2& at) const {
    const elsie::Vector2 line{goal_.x - start_.x, goal_.y - start_.y};
    const double length = std::max(1e-9, std::hypot(line.x, line.y));
    return (line.x * (at.y - start_.y) - line.y * (at.x - start_.x)) / length;
  }

  elsie::Vector2 start_, last_, goal_;
};
