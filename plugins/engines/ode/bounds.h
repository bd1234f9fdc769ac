// Where bodies can be, and how fast.
#pragma once

#include <optional>

#include "elsie/api/body.h"
#include "elsie/api/geometry.h"
#include "elsie/physics/failure.h"
#include "elsie/world/description.h"

namespace elsie::physics {

/// The places and speeds that the things in a world can bring about. A body outside of them has
/// been thrown there by errors of the solver.
///
/// Speed: nothing but wheels, moving boxes and gravity sets anything in motion. A robot whose rims
/// move at u turns on the spot at u / half_axle, so that what is d m from the middle of its axle
/// moves at u d / half_axle: its fastest part moves at u max(1, reach / half_axle), with the reach
/// of its farthest corner, or that of its last segment when all are in line (lever_of()). A body
/// that is hit by one at the speed v leaves with (1 + bounce) v at most, however light it is; two
/// such speeds may add where bodies meet head on. A fall from the height h adds sqrt(2 g h). Bodies
/// that overlap are put apart at 0.5 m/s, which a few in a row may add up. So the limit is
///
///   2 (1 + bounce) (fastest robot's part + fastest moving box) + sqrt(2 g h) + 2 m/s
///
/// with the highest speeds asked for so far, and the highest point of any body at its start.
class Bounds {
 public:
  Bounds(const world::Arena& arena, const world::Physics& physics)
      : arena_(arena), physics_(physics) {}

  /// What has set bodies in motion elsewhere counts here, too.
  void add(const Bounds& other);

  // What may set bodies in motion.
  void add_height(double top);          // m, the upper side of a body that may fall
  void add_robot_speed(double speed);   // m/s, of a robot's fastest part
  void add_moving_speed(double speed);  // m/s, of a moving box

  /// The highest speed of a body, m/s.
  double most_speed() const;
  /// Whether there are walls and this place is between them.
  bool within_walls(const Vector3& place) const;

  /// What is wrong with a body whose middle is there. `stays_within`: it began within the walls.
  std::optional<Failure> check(const Vector3& middle, const Vector3& velocity,
                               bool stays_within) const;

 private:
  world::Arena arena_;
  world::Physics physics_;
  double top_ = 0.0;
  double robot_ = 0.0;
  double moving_ = 0.0;
};

/// Reach over the distance of the nearest driven wheel from the middle, at least 1: how many times
/// as fast as its wheels' rims the fastest part of a robot can move. 1.26 for one of default size
/// that pulls nothing.
double lever_of(const BodyPlan& plan);

}  // namespace elsie::physics
