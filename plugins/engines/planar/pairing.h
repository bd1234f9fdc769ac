// Where two bodies meet, solid by solid.
#pragma once

#include <cstddef>
#include <vector>

#include "outline.h"
#include "planar_vehicle.h"
#include "plane.h"

namespace elsie::physics {

/// The memory that for_each_meeting() uses; one for each thread.
struct PairingSpace {
  std::vector<Vector2> a, b;
};

/// Calls `call(i, k, meeting)` for each solid `i` of one body and `k` of another one that may be no
/// further apart than `margin`.
template <class Call>
void for_each_meeting(const std::vector<Solid>& solids_a, const Placement& a,
                      const std::vector<Solid>& solids_b, const Placement& b, double margin,
                      PairingSpace& space, Call call) {
  const auto middle = [](const Solid& solid, const Placement& at) {
    const Vector2 turned = at.ahead.turn(solid.place);
    return Vector2{at.place.x + turned.x, at.place.y + turned.y};
  };
  for (std::size_t i = 0; i < solids_a.size(); ++i) {
    const Solid& of_a = solids_a[i];
    const Vector2 middle_a = middle(of_a, a);
    const Direction whole_a = a.ahead.turned(of_a.ahead);
    bool is_placed = false;
    PlacedOutline placed_a;
    for (std::size_t k = 0; k < solids_b.size(); ++k) {
      const Solid& of_b = solids_b[k];
      if (!of_a.outline.is_level_with(of_b.outline)) continue;
      if (of_a.below && of_b.outline.is_level_with(solids_a.front().outline)) continue;
      if (of_b.below && of_a.outline.is_level_with(solids_b.front().outline)) continue;
      const Vector2 middle_b = middle(of_b, b);
      const double dx = middle_a.x - middle_b.x, dy = middle_a.y - middle_b.y;
      const double far = of_a.outline.reach + of_b.outline.reach + margin;
      if (dx * dx + dy * dy > far * far) continue;
      const Direction whole_b = b.ahead.turned(of_b.ahead);
      if (!may_meet(of_a.outline, whole_a, of_b.outline, whole_b, {dx, dy}, margin)) continue;
      if (!is_placed) {
        placed_a = placed(of_a.outline, middle_a, whole_a, space.a);
        is_placed = true;
      }
      call(i, k, meet(placed_a, placed(of_b.outline, middle_b, whole_b, space.b), margin));
    }
  }
}

}  // namespace elsie::physics
