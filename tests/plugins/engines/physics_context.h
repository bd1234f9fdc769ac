// A small world for one test: set it up, step it, look at what happened.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/world/parts.h"

namespace elsie::physics {

struct PhysicsContext {
  explicit PhysicsContext(const world::Physics& with = {}, const world::Arena& in = {})
      : physics(with), arena(in), engine(make_engine(in, with)) {}

  std::size_t robot(double x, double y, double heading_deg = 0.0, const world::RobotBody& body = {},
                    double z = 0.0) {
    return engine->add_robot(world::plan_of(body, {}), {x, y, radians(heading_deg)}, z);
  }

  /// A robot that pulls segments.
  std::size_t train(double x, double y, double heading_deg,
                    const std::vector<world::Segment>& segments) {
    return engine->add_robot(world::plan_of({}, segments), {x, y, radians(heading_deg)});
  }

  /// What a robot's motors are to hold, rad/s.
  void drive(std::size_t robot, const std::vector<double>& rates) {
    std::vector<JointSetting> joints;
    for (const double rate : rates) joints.push_back({rate});
    engine->set_joints(robot, joints);
  }

  std::size_t obstacle(world::ObstacleKind kind, double x, double y, const Vector3& size,
                       double heading_deg = 0.0, double z = 0.0,
                       double mass = world::Obstacle{}.mass) {
    world::Obstacle box;
    box.kind = kind;
    box.x = x;
    box.y = y;
    box.z = z;
    box.length = size.x;
    box.width = size.y;
    box.height = size.z;
    box.heading_deg = heading_deg;
    box.mass = mass;
    return engine->add_obstacle(box);
  }

  /// Steps for a time, and calls `each` after every step.
  void run(
      double seconds, const std::function<void()>& each = [] {}) {
    const long steps = std::lround(seconds / physics.step);
    for (long i = 0; i < steps; ++i) {
      engine->step();
      each();
    }
  }

  Pose pose(std::size_t robot) const { return engine->robot(robot).pose; }

  bool touching(const Body& a, const Body& b) const {
    for (const Touch& touch : engine->touches()) {
      if ((touch.a == a && touch.b == b) || (touch.a == b && touch.b == a)) return true;
    }
    return false;
  }

  /// Moves a moving box along at a velocity for a time.
  void drive(
      std::size_t box, const Vector2& velocity, double seconds,
      const std::function<void()>& each = [] {}) {
    Vector3 at = engine->obstacle(box).origin;
    const long steps = std::lround(seconds / physics.step);
    for (long i = 0; i < steps; ++i) {
      at = at + physics.step * Vector3{velocity.x, velocity.y, 0.0};
      engine->drive_obstacle(box, {at.x, at.y}, velocity);
      engine->step();
      each();
    }
  }

  world::Physics physics;
  world::Arena arena;
  std::unique_ptr<Engine> engine;
};

inline Body robot_body(std::size_t index) { return {BodyKind::robot, index}; }
inline Body box_body(std::size_t index) { return {BodyKind::obstacle, index}; }
inline Body wall_body(std::size_t index) { return {BodyKind::wall, index}; }

inline world::Physics with_step(double step) {
  world::Physics physics;
  physics.step = step;
  return physics;
}

/// A robot with a round chassis and its wheels within the chassis' outline.
inline world::RobotBody round_body(double diameter = 0.12) {
  world::RobotBody body;
  body.round = true;
  body.length = body.width = diameter;
  body.axle = diameter - 0.04;
  return body;
}

/// A body that is nothing but a chassis, a millimetre above the floor.
inline BodyPlan alone(const Shape& shape, double mass = 0.1) {
  Part chassis;
  chassis.name = "chassis";
  chassis.shape = shape;
  chassis.frame.origin.z = 0.5 * shape.size.z + 1e-3;
  chassis.mass = mass;
  return {{chassis}};
}

inline world::Arena open_field(double size = 40.0) {
  world::Arena arena;
  arena.length = arena.width = size;
  arena.walls = false;
  return arena;
}

inline constexpr auto kNobody = Engine::kNobody;
inline constexpr double kNone = std::numeric_limits<double>::infinity();

/// The distance (m) at which a ray hits something, or kNone.
inline double cast(const PhysicsContext& context, const Vector3& from, const Vector3& along,
                   double range = 20.0, std::size_t except = kNobody) {
  const auto hit = context.engine->cast_ray(from, along, range, except);
  return hit ? hit->distance : kNone;
}

}  // namespace elsie::physics
