// Detects that a robot does not move as commanded.
#pragma once

#include <algorithm>
#include <cmath>

#include <elsie/api/perception.h>
#include <elsie/api/remember.h>
#include <elsie/api/simulator_events.h>

class StuckWatch {
 public:
  struct Settings {
    double patience_s = 1.0;
    double collision_patience_s = 0.2;
    double moving = 0.2;        // fraction of the commanded speed that counts as motion
    double least_speed = 0.02;  // m/s; slower commands are not expected to move it
    double progress_m = 0.1;
    double progress_time_s = 0.0;  // 0: progress is not watched
  };

  void set(const Settings& settings) { settings_ = settings; }

  void reset() {
    held_s_ = 0.0;
    last_s_ = -1.0;
    collided_s_ = -kMemory - 1.0;
    is_anchored_ = false;
  }
  void remember(elsie::Memory& memory) {
    memory("held_s", held_s_);
    memory("last_s", last_s_);
    memory("collided_s", collided_s_);
    memory("is_anchored", is_anchored_);
    memory("anchor.x", anchor_.x);
    memory("anchor.y", anchor_.y);
    memory("anchored_s", anchored_s_);
  }

  /// Must be called once in every control period.
  bool is_stuck(const elsie::Perception& now) {
    const double passed = last_s_ < 0.0 ? 0.0 : now.time_s() - last_s_;
    last_s_ = now.time_s();
    for (const elsie::Event& event : now.events()) {
      if (event.name == elsie::events::Collision::kFacts.name) {
        collided_s_ = now.time_s();
      }
    }
    // The time grows while the robot is held and shrinks while it moves: a jerk against the wall
    // does not reset it.
    held_s_ = is_held(now.self()) ? held_s_ + passed : std::max(0.0, held_s_ - passed);
    const bool collided = now.time_s() - collided_s_ <= kMemory;
    const double patience = collided
                                ? std::min(settings_.patience_s, settings_.collision_patience_s)
                                : settings_.patience_s;
    return (is_held(now.self()) && held_s_ >= patience - kRounding) || makes_no_progress(now);
  }

 private:
  static constexpr double kMemory = 1.0;     // s; a collision is remembered for this time
  static constexpr double kRounding = 1e-9;  // s; times are sums of steps

  /// The commanded speed, whatever its direction, m/s.
  static double speed(const elsie::Motion& motion) {
    return std::hypot(motion.forward, motion.lateral);
  }
  /// The speed of the wheels along their circle in a turn on the spot, m/s.
  static double turning_speed(const elsie::OwnState& self) {
    return self.wheels.half_axle * std::abs(self.commanded.turn);
  }

  bool wants_to_move(const elsie::OwnState& self) const {
    return std::max(speed(self.commanded), turning_speed(self)) >= settings_.least_speed;
  }

  /// True if the robot moves less than it should: along its way, or around when it turns on the
  /// spot.
  bool is_held(const elsie::OwnState& self) const {
    const elsie::Motion& wish = self.commanded;
    const double wished = speed(wish);
    if (wished >= settings_.least_speed) {
      const double along = wish.forward * self.moving.forward + wish.lateral * self.moving.lateral;
      return along / (wished * wished) < settings_.moving;
    }
    return turning_speed(self) >= settings_.least_speed &&
           self.moving.turn / wish.turn < settings_.moving;
  }

  bool makes_no_progress(const elsie::Perception& now) {
    const elsie::OwnState& self = now.self();
    if (settings_.progress_time_s <= 0.0) {
      return false;
    }
    if (!is_anchored_ || !wants_to_move(self) ||
        elsie::distance(anchor_, self.pose) >= settings_.progress_m) {
      is_anchored_ = true;
      anchor_ = self.pose;
      anchored_s_ = now.time_s();
    }
    return now.time_s() - anchored_s_ >= settings_.progress_time_s - kRounding;
  }

  Settings settings_;
  double held_s_ = 0.0;
  double last_s_ = -1.0;
  double collided_s_ = -kMemory - 1.0;
  bool is_anchored_ = false;
  elsie::Pose anchor_;
  double anchored_s_ = 0.0;
};
