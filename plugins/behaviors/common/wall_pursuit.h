// Follows a wall on one side at a distance, around inner and outer corners; shared by wall_follow
// and bug.
//
//   searching  no wall: straight on
//   following  a wall on the side: pure pursuit (Coulter 1992) of the line at the distance from it
//   turning    an obstacle ahead: away from the wall's side on the spot, until the way is clear
//   rounding   the wall has ended: an arc towards its side until it is seen again. After three
//              quarters of a circle it is lost; so is a wall that the robot was still approaching
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>
#include <elsie/base/number_text.h>

#include "inactive.h"
#include "seen_points.h"
#include "two_values.h"
#include "wall_sight.h"

class WallPursuit {
 public:
  enum class State { searching, following, turning, rounding };

  struct Settings {
    bool on_left = false;
    double distance = 0.3;         // m, from the robot's middle to the wall
    double reach = 0.75;           // m, beyond it there is no wall
    double front_angle_rad = 0.0;  // see WallSight
    double speed = 0.2;            // m/s
    double lookahead = 0.3;        // m
    double turn_rate = 1.5;        // rad/s, the fastest turn
  };

  /// Throws std::invalid_argument if they do not fit together.
  void set(const Settings& settings) {
    if (settings.reach <= settings.distance) {
      throw std::invalid_argument(
          two_values("reach", settings.reach, "distance", settings.distance, "m") +
          "a wall that is farther than reach counts as none, so reach must be the larger one");
    }
    set_ = settings;
    sight_.set({set_.on_left, set_.front_angle_rad});
  }
  /// Moves the wall to the other side.
  void set_side(bool on_left) {
    set_.on_left = on_left;
    sight_.set({on_left, set_.front_angle_rad});
  }
  const Settings& settings() const { return set_; }

  /// Throws std::invalid_argument if the robot is too large, or has no sensors for this side.
  void check(const elsie::Perception& example) const;

  void reset() {
    state_ = State::searching;
    asked_s_ = -1e9;
  }
  void remember(elsie::Memory& memory) {
    memory("state", state_);
    memory("asked_s", asked_s_);
    memory("is_beside", is_beside_);
    memory("heading_rad", heading_rad_);
    memory("rounded_rad", rounded_rad_);
  }
  /// Follows from now on: the wall is next to the robot, whether it is seen or not.
  void begin(const elsie::Perception& now) {
    state_ = State::following;
    asked_s_ = now.time_s();
    is_beside_ = true;
  }

  /// Sees and decides; once in a step. Returns the state before: searching if it was not called for
  /// a while.
  State look(const elsie::Perception& now) {
    const bool was_away = now.time_s() - asked_s_ > std::max(kAway, 2.0 * now.period_s());
    asked_s_ = now.time_s();
    const State before = was_away ? State::searching : state_;
    sight_.look(now, before == State::following ? kHold * set_.reach : set_.reach);
    wall_ = sight_.wall();
    state_ = next(before, wall_.has_value(), now.self());
    return before;
  }
  State state() const { return state_; }

  /// What to do, after look(): inactive and straight on while searching.
  elsie::Response act() {
    switch (state_) {
      case State::following:
        return pursue(*wall_);
      case State::turning:
        return elsie::Motion{0.0, 0.0, -towards_wall() * set_.turn_rate};
      case State::rounding:
        return drive(set_.speed / set_.distance);
      case State::searching:
        break;
    }
    return inactive({set_.speed, 0.0, 0.0});
  }

  /// 1 if the wall is on the left, else -1: the direction of turns towards it.
  double towards_wall() const { return set_.on_left ? 1.0 : -1.0; }

 private:
  static constexpr double kAway = 0.5;   // s without being asked
  static constexpr double kClear = 1.2;  // distances ahead that end a turn
  static constexpr double kHold = 1.2;   // reaches within which a wall that was found is kept
  static constexpr double kLost = 1.5 * std::numbers::pi;

  State next(State before, bool has_wall, const elsie::OwnState& self) {
    const double clear = before == State::turning ? kClear * set_.distance : set_.distance;
    if (sight_.ahead() && *sight_.ahead() < clear) {
      return State::turning;
    }
    if (has_wall) {
      return State::following;
    }
    if (before == State::searching || (before == State::following && !is_beside_)) {
      return State::searching;
    }
    if (before != State::rounding) {
      rounded_rad_ = 0.0;
    } else {
      rounded_rad_ += towards_wall() * elsie::wrap_angle(self.pose.heading_rad - heading_rad_);
    }
    heading_rad_ = self.pose.heading_rad;
    return rounded_rad_ >= kLost ? State::searching : State::rounding;
  }

  /// Steers to the point on the wanted line that is `lookahead` ahead of the robot's position along
  /// it.
  elsie::Response pursue(const WallSight::Wall& wall) {
    const double error = wall.distance - set_.distance;
    is_beside_ = wall.distance <= 0.5 * (set_.distance + set_.reach);
    const double x = set_.lookahead * wall.along.x - error * wall.along.y;
    const double y = set_.lookahead * wall.along.y + error * wall.along.x;
    elsie::Response response;
    if (x <= 0.0) {
      response.command.turn = (y > 0.0 ? 1.0 : -1.0) * towards_wall() * set_.turn_rate;
    } else {
      response = drive(set_.speed * 2.0 * y / (x * x + y * y));
    }
    response.activation = 0.5 + 0.5 * std::min(1.0, std::abs(error) / set_.distance);
    return response;
  }

  /// Drives ahead and turns towards the wall's side at this rate (rad/s); slower if the turn would
  /// be too fast.
  elsie::Motion drive(double turn) const {
    const double scale = std::min(1.0, set_.turn_rate / std::max(1e-9, std::abs(turn)));
    return {scale * set_.speed, 0.0, scale * towards_wall() * turn};
  }

  Settings set_;
  WallSight sight_;
  std::optional<WallSight::Wall> wall_;  // in this step
  State state_ = State::searching;
  double asked_s_ = -1e9;
  bool is_beside_ = false;    // while following: is near the wall, no longer approaching it
  double heading_rad_ = 0.0;  // while rounding: in the last step
  double rounded_rad_ = 0.0;  // while rounding: turned so far
};

inline void WallPursuit::check(const elsie::Perception& example) const {
  using elsie::base::number_text;
  const double corner = body_radius(example.self());
  if (set_.distance <= corner) {
    throw std::invalid_argument("distance is " + number_text(set_.distance, 6) +
                                " m from the robot's middle to the wall, but the robot's own "
                                "corners are " +
                                number_text(corner, 6) + " m from there; give it a larger one");
  }
  bool ahead = false, aside = false;
  for_each_ray(example, [&](const SensorRay& ray) {
    ahead = ahead || sight_.looks_ahead(ray.azimuth_rad());
    aside = aside || sight_.looks_aside(ray.azimuth_rad());
  });
  if (!ahead || !aside) {
    const std::string angle = number_text(elsie::degrees(set_.front_angle_rad), 6);
    throw std::invalid_argument(
        "it needs a lidar, or a range sensor that looks ahead (yaw_deg from -" + angle + " to " +
        angle + ") and one that looks to the " + (set_.on_left ? "left" : "right") +
        (set_.on_left ? " (" + angle + " to 150" : " (-" + angle + " to -150") +
        "), and the robot has none " +
        (aside   ? "of the first"
         : ahead ? "of the second"
                 : "of either") +
        "; add one");
  }
}
