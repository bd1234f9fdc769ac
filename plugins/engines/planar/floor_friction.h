// The mass of a body in the plane, and the friction of one that slides on the floor.
#pragma once

#include "elsie/world/description.h"

#include "plane.h"

namespace elsie::physics {

/// The mass of a vehicle in the plane.
struct Inertia {
  double mass = 0.0;          // kg
  Vector2 center;             // m, of mass, in the frame of its origin
  double about_center = 0.0;  // kg m2, about the vertical axis through the center of mass

  /// The velocity after an impulse, which is given in the same frame.
  Twist after(const Twist& velocity, const Twist& impulse) const {
    return {velocity.x + impulse.x / mass, velocity.y + impulse.y / mass,
            velocity.turn + impulse.turn / about_center};
  }
};

/// The friction of a body that slides on the floor, for translation and turning together. Force F
/// and torque T lie within an ellipsoid (Howe and Cutkosky, "Practical force-motion models for
/// sliding manipulation", 1996), and where they do not stop the body they take the most energy from
/// its velocity v and turning w:
///
///   (F / f)^2 + (T / t)^2 <= 1,   f = friction m g,   t = lever f,
///   (F, T) = -(f^2 v, t^2 w) / sqrt((f v)^2 + (t w)^2).
class FloorFriction {
 public:
  FloorFriction() = default;  // none
  /// `lever`: the mean distance of its support from its middle, m.
  FloorFriction(const Inertia& inertia, double lever, const world::Physics& physics);

  /// As Undercarriage::solve(), in any frame.
  Twist solve(const Twist& free) const;

 private:
  Inertia inertia_;
  double force_ = 0.0;   // N s, the most in a step
  double torque_ = 0.0;  // N m s
};

}  // namespace elsie::physics
