// What the cases for every engine share.
#pragma once

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

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

inline double each_step() { return GENERATE(0.001, 0.005, 0.01, 0.02); }

/// The sine of the angle between the headings of two frames.
inline double cross_z(const Frame& a, const Frame& b) {
  return a.forward.x * b.forward.y - a.forward.y * b.forward.x;
}

inline double across(const Vector3& a, const Vector3& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace elsie::physics
