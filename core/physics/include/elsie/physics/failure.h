// How a physics engine reports that it has lost a body.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include "elsie/api/geometry.h"
#include "elsie/physics/engine.h"

namespace elsie::physics {

/// A state of a body that nothing in the world could cause.
struct Failure {
  enum class Kind {
    stopped,      // the solver could not go on; no body is known
    not_finite,   // a number of the body's state is infinite, or not a number
    below_floor,  // the middle of the body is below the floor
    outside,      // it began within the arena's walls, and its middle has left them
    too_fast,     // it moves faster than anything in the world could make it move
    pressed       // a moving obstacle, which nothing stops, leaves it no room
  };
  Kind kind = Kind::stopped;
  std::optional<Body> body;            // a robot or an obstacle
  std::optional<std::size_t> segment;  // of the robot; none: the robot itself
  std::optional<Body> presser;         // pressed: the moving obstacle
  double time_s = 0.0;
  Vector3 place;       // of its middle, m
  double speed = 0.0;  // m/s
  double limit = 0.0;  // m/s; too_fast: the largest possible speed

  /// "is below the floor: its middle is at (0.1, 0.2, -0.3) m", to follow the body's name.
  std::string in_words() const;
};

/// The state of the physics is no longer valid. what() is a sentence that names the body by its
/// number.
class PhysicsFailure : public std::runtime_error {
 public:
  explicit PhysicsFailure(Failure failed);
  Failure failure;
};

}  // namespace elsie::physics
