// Constants of the physics engine.
#pragma once

namespace elsie::world {

/// The highest speed at which overlapping bodies are pushed apart, m/s.
inline constexpr double kMaxCorrectingSpeed = 0.5;

}  // namespace elsie::world
