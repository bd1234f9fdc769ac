// What a bug notes on its way along the boundary of an obstacle: the registers R1 to R3 of
// Lumelsky and Stepanov (1987).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <elsie/api/geometry.h>
#include <elsie/api/remember.h>

class BoundaryTrip {
 public:
  /// From H, whose heading is along the boundary, `away_m` from the goal. Nothing closer than
  /// `spacing_m` counts as another part of the boundary.
  void begin(const elsie::Pose& hit, double away_m, double spacing_m) {
    hit_ = last_ = nearest_ = hit;
    hit_away_ = nearest_away_ = away_m;
    spacing_ = spacing_m;
    path_ = nearest_path_ = past_hit_ = 0.0;
    least_ = std::numeric_limits<double>::max();
    has_left_ = has_left_nearest_ = false;
  }

  /// In each step. Returns whether it has come round, back to H: through a gate across the boundary
  /// there, in the direction of the beginning. Between obstacles that are too near to each other H
  /// may be missed: then it has come round at the nearest point.
  bool comes_round(const elsie::Pose& pose, double away_m) {
    path_ += elsie::distance(pose, last_);
    last_ = pose;
    if (away_m < nearest_away_) {
      nearest_away_ = away_m;
      nearest_ = pose;
      nearest_path_ = path_;
      has_left_nearest_ = false;
    }
    const double off_nearest = elsie::distance(pose, nearest_);
    has_left_nearest_ = has_left_nearest_ || off_nearest > spacing_;
    if (has_left_nearest_ && off_nearest < 0.5 * spacing_) {
      nearest_path_ = 0.0;
      return true;
    }
    const double off = elsie::distance(pose, hit_);
    has_left_ = has_left_ || off > spacing_;
    const double before = past_hit_;
    past_hit_ = (pose.x - hit_.x) * std::cos(hit_.heading_rad) +
                (pose.y - hit_.y) * std::sin(hit_.heading_rad);
    return has_left_ && off <= spacing_ && before < 0.0 && past_hit_ >= 0.0;
  }

  /// Once round: whether the shorter way to the nearest point is the one that it came.
  bool is_nearer_back() const { return nearest_path_ > 0.5 * path_; }
  /// In each step after that: whether it has just passed the nearest point.
  bool passes_nearest(const elsie::Pose& pose) {
    constexpr double kPassed = 0.01;  // m
    const double off = elsie::distance(pose, nearest_);
    least_ = std::min(least_, off);
    return least_ < spacing_ && off > least_ + kPassed;
  }

  /// It leaves the boundary here, which is near the nearest point for Bug1. `wall_rad`: where the
  /// obstacle is from the heading along the boundary.
  void leave(const elsie::Pose& pose, double wall_rad) {
    leave_ = {pose.x, pose.y, nearest_.heading_rad + wall_rad};
  }
  /// It begins anew: it has left nothing.
  void forget_leave() { leave_ = {1e9, 1e9, 0.0}; }
  /// Whether it is still at L, and this direction in the world leads into the obstacle there.
  bool leads_back(const elsie::Pose& pose, double direction_rad) const {
    constexpr double kSame = 0.1;  // m, within it two points are the same
    return elsie::distance(pose, leave_) < kSame &&
           std::cos(direction_rad - leave_.heading_rad) > 0.0;
  }
  /// From H to the goal, m.
  double hit_away_m() const { return hit_away_; }

  void remember(elsie::Memory& memory) {
    double* const numbers[] = {
        &hit_.x,    &hit_.y,       &hit_.heading_rad,   &last_.x,
        &last_.y,   &nearest_.x,   &nearest_.y,         &nearest_.heading_rad,
        &hit_away_, &spacing_,     &nearest_away_,      &path_,
        &leave_.x,  &leave_.y,     &leave_.heading_rad, &past_hit_,
        &least_,    &nearest_path_};
    std::vector<double> values;
    for (const double* const number : numbers) values.push_back(*number);
    memory("trip", values);
    for (std::size_t i = 0; i < std::min(values.size(), std::size(numbers)); ++i) {
      *numbers[i] = values[i];
    }
    memory("has_left", has_left_);
    memory("has_left_nearest", has_left_nearest_);
  }

 private:
  elsie::Pose hit_, last_, nearest_;
  elsie::Pose leave_{1e9, 1e9, 0.0};  // L; the heading is that to the obstacle
  double hit_away_ = 0.0;             // m, from H to the goal
  double nearest_away_ = 0.0;         // m, from the nearest point to the goal
  double spacing_ = 0.0;              // m
  double path_ = 0.0;                 // m along the boundary since H
  double nearest_path_ = 0.0;         // m along the boundary from H to the nearest point
  double past_hit_ = 0.0;             // m, past H in the direction of the boundary
  double least_ = 0.0;                // m, as near as it has come to the nearest point again
  bool has_left_ = false;             // it has been away from H
  bool has_left_nearest_ = false;     // and from the nearest point
};
