// Limits on the places and speeds of bodies.
#pragma once

#include <optional>

#include "elsie/api/body.h"
#include "elsie/api/geometry.h"
#include "elsie/physics/failure.h"
#include "elsie/world/description.h"

namespace elsie::physics {

/// The places and speeds that are possible in a world. A body outside of them has been thrown there
/// by errors of the solver.
///
/// Speed: only wheels, moving boxes and gravity set bodies in motion. A robot whose rims move at u
/// turns on the spot at u / half_axle, so a point d m from the middle of its axle moves at u d /
/// half_axle. Its fastest part moves at u max(1, reach / half_axle), where the reach is that of its
/// farthest corner, or of its last segment when all are in line (lever_of()). A body that is hit at
/// the speed v leaves with at most (1 + bounce) v, however light it is; two such speeds may add
/// where bodies meet head on. A fall from the height h adds sqrt(2 g h). Overlapping bodies are
/// pushed apart at 0.5 m/s, which may add up over a few in a row. So the limit is
///
///   2 (1 + bounce) (fastest robot's part + fastest moving box) + sqrt(2 g h) + 2 m/s
///
/// with the highest speeds commanded so far, and the highest point of any body at its start.
class Bounds {
 public:
  Bounds(const world::Arena& arena, const world::Physics& physics)
      : arena_(arena), physics_(physics) {}

  /// Includes everything that has set bodies in motion according to `other`.
  void add(const Bounds& other);

  // Things that may set bodies in motion.
  void add_height(double top);          // m, the upper side of a body that may fall
  void add_robot_speed(double speed);   // m/s, of a robot's fastest part; several threads may
  void add_moving_speed(double speed);  // m/s, of a moving box

  /// The highest possible speed of a body, m/s.
  double most_speed() const;
  /// True if there are walls and this place is between them.
  bool within_walls(const Vector3& place) const;

  /// The fault of a body whose middle is there, if any. `stays_within`: it began within the walls.
  std::optional<Failure> check(const Vector3& middle, const Vector3& velocity,
                               bool stays_within) const;

 private:
  world::Arena arena_;
  world::Physics physics_;
  double top_ = 0.0;
  double robot_ = 0.0;
  double moving_ = 0.0;
};

/// The reach divided by the distance of the nearest driven wheel from the middle, at least 1: how
/// many times as fast as its wheels' rims the fastest part of a robot can move. It is 1.26 for a
/// robot of default size that pulls nothing.
double lever_of(const BodyPlan& plan);

}  // namespace elsie::physics
