// Motor schemas (Arkin 1989): behaviours that answer a velocity vector.
#pragma once

#include <cmath>

#include <elsie/api/behavior.h>

/// The velocity (m/s) is that of a point P of the robot, `lead` ahead of the middle of its axle:
///
///   forward = Vx     turn = Vy / lead      (Vx ahead, Vy to the left)
///   forward = Vx     lateral = Vy          if the drive moves sideways
///
/// P moves with V exactly, also on a robot that cannot move sideways (input/output linearization;
/// Siciliano, Sciavicco, Villani and Oriolo 2009). The law is linear: the sum of the motions of
/// several schemas is the motion of the sum of their vectors, which coordinators rely on.
class MotorSchema : public elsie::Behavior {
 public:
  double lead = 0.05;  // m

  void reset(elsie::Random&) override { shown_ = {}; }

  void sketch(elsie::Sketch& sketch) const override {
    if (shown_ == elsie::Vector2{}) return;
    sketch.arrow(elsie::SketchRole::wish, {lead, 0.0, 0.0}, {lead + shown_.x, shown_.y, 0.0});
  }

  static elsie::ParameterFacts lead_facts() {
    return {.unit = "m",
            .min = 0.001,
            .max = 10,
            .meaning = "the point that its vector moves is so far ahead of the middle of the axle"};
  }

 protected:
  /// P, in the world.
  elsie::Vector2 here(const elsie::Perception& now) const {
    return elsie::point_of(now.self().pose, {lead, 0.0});
  }

  /// The motion in which P has this velocity, given in the robot's frame.
  elsie::Motion moved(const elsie::Vector2& velocity, const elsie::Perception& now) {
    shown_ = velocity;
    if (now.self().channels.lateral) return {velocity.x, velocity.y, 0.0};
    return {velocity.x, 0.0, velocity.y / lead};
  }

  /// The same for a velocity in the world.
  elsie::Motion moved_in_world(const elsie::Vector2& velocity, const elsie::Perception& now) {
    const double heading = now.self().pose.heading_rad;
    const double c = std::cos(heading), s = std::sin(heading);
    return moved({c * velocity.x + s * velocity.y, c * velocity.y - s * velocity.x}, now);
  }

  /// It wants nothing.
  void rest() { shown_ = {}; }

 private:
  elsie::Vector2 shown_;  // m/s, in the robot's frame, as the last answer had it
};
