// What only the physics engine sets.
#pragma once

namespace elsie::world {

/// The highest speed at which bodies that overlap are pushed apart; m/s.
inline constexpr double kMaxCorrectingSpeed = 0.5;

}  // namespace elsie::world
