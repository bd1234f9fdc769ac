// What the cases for every engine share.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/base/thread_pool.h"
#include "elsie/plugin/engine_libraries.h"

#include "physics_context.h"

namespace elsie::physics {

inline world::Physics with(const std::string& engine, double step = 0.01) {
  world::Physics physics = with_step(step);
  physics.engine = engine;
  return physics;
}

/// Returns one engine after the other, and says which in the messages of a case.
inline std::string each_engine() { return GENERATE(from_range(plugin::engine_names())); }

inline double each_step() { return GENERATE(0.005, 0.02); }

/// The sine of the angle between the headings of two frames.
inline double cross_z(const Frame& a, const Frame& b) {
  return a.forward.x * b.forward.y - a.forward.y * b.forward.x;
}

inline double across(const Vector3& a, const Vector3& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// A square of robots in a small arena, which run into everything: boxes between them, a train, and
/// a box that moves through them. Half way, one box is removed.
struct Bustle {
  std::uint64_t seed = 1;
  int steps = 400;
  int side = 3;
  double apart = 0.8;                                            // m
  std::function<void(const Engine&)> after_each_step = nullptr;  // all robots are watched then
};

/// The hash after each step.
inline std::vector<std::uint64_t> history(const std::string& engine, const Bustle& bustle,
                                          std::size_t threads = 1) {
  base::ThreadPool pool(threads);
  const auto& [seed, steps, side, apart, after_each_step] = bustle;
  const double size = apart * (side + 0.2), first = -0.5 * apart * (side - 1);
  PhysicsContext context(with(engine), {.length = size, .width = size});
  context.engine->work_with(pool);
  Random random(seed);
  const auto robots = static_cast<std::size_t>(side * side);
  for (int i = 0; i < side * side; ++i) {
    context.robot(first + apart * (i % side), first + apart * (i / side),
                  random.uniform(-180, 180));
  }
  for (int i = 0; i < (side - 1) * (side - 1); ++i) {
    context.obstacle(world::ObstacleKind::dynamic, first + apart * (i % (side - 1) + 0.5),
                     first + apart * (i / (side - 1) + 0.5), {0.1, 0.15, 0.1}, 30.0 * i);
  }
  context.train(0.0, 0.07 - 0.5 * size, 0.0, {world::Segment(), world::Segment()});
  const double y = first + 0.5 * apart;
  const std::size_t moving =
      context.obstacle(world::ObstacleKind::moving, first, y, {0.1, 0.1, 0.1});
  for (std::size_t robot = 0; after_each_step && robot <= robots; ++robot) {
    context.engine->watch_contacts(robot);
  }
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < steps; ++i) {
    for (std::size_t robot = 0; i % 20 == 0 && robot <= robots; ++robot) {
      context.drive(robot, {random.uniform(-5, 25), random.uniform(-5, 25)});
    }
    if (i == steps / 2) context.engine->remove_obstacle(2);
    context.engine->drive_obstacle(moving, {first + 0.003 * (i + 1), y}, {0.3, 0.0});
    context.engine->step();
    hashes.push_back(context.engine->hash_state());
    if (after_each_step) after_each_step(*context.engine);
  }
  return hashes;
}

}  // namespace elsie::physics
